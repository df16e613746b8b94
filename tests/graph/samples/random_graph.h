// Purpose: makes random frames for tests: 5 to 60 passes over images with mips and layers, buffers and
// imports. The passes write parts of resources, write in place, overwrite content, share inputs, and some
// results stay unused. Optional features add persistent resources, queue hints, mip chains and more. A
// disabled option draws no random numbers, so that a seed keeps its graph.
//
// The graphs can run on a device. All passes use exact integer arithmetic on r32u images and u32 buffers (and
// one exact conversion to d32f). So any two correct plans of a graph give the same bytes. Clear, copy and
// readback passes have no shader; the other passes use these shaders in tests/graph/shaders/:
//   compute     fill_image, mix_image_1, mix_image_2, mix_image_3, mix_depth, update_image,
//               mix_buffer_1, mix_buffer_2, update_buffer, image_to_buffer, buffer_to_image   (.comp)
//   fullscreen  mix_color_1, mix_color_2, write_depth, mix_color_depth   (.frag)
// Shaders have the ports a, b, c and dst, bound in this order in set 1, colour outputs at location 0, and
// push constants `Params { uint seed; }`. A sampled port sees one layer with one or all of its mips. A
// storage port sees one mip of one layer.
//
// A graph may have these imports. The test program provides them with any content, the same for both plans:
//   import_image  r32u, 32 px, stays in shader_read_only     import_words  256 words, only read
//   state_words   256 words, modified in place by a pass with a side effect
// The result of a graph is the data of its readback pass "read_back"; see random_graph_result().
#pragma once

#include <cstdint>

#include "weft/declaration.h"

namespace weft::test {

struct RandomGraphOptions {
    uint32_t min_passes = 5;
    uint32_t max_passes = 60;
    // Adds rings: resources with one or two past frames.
    bool history = false;
    // Adds resources that keep their content from frame to frame. Passes modify them in place, and others
    // read them before and after the change.
    bool keep = false;
    // Gives passes hints to run on compute and transfer queues. Most imports become usable on all queue
    // families (ImportState::concurrent), so that these hints have an effect on their passes.
    bool queues = false;
    // Adds edges (`after`) between passes that share no resource.
    bool after = false;
    // Adds passes that process an image mip by mip, downwards and upwards again, layer by layer.
    bool chains = false;
    // Adds clears and copies of several mips and layers at once.
    bool ranges = false;
    // Adds passes that use the same depth image as attachment and as input.
    bool depth_input = false;
    // Adds groups of passes that draw on the same image and can share one rendering scope.
    bool layers = false;
};

// Returns options with all optional features enabled.
[[nodiscard]] RandomGraphOptions all_features();

[[nodiscard]] ResolvedGraph random_graph(uint32_t seed, const RandomGraphOptions& options = {});

// Returns the image whose whole content the pass "read_back" reads.
[[nodiscard]] ResourceId random_graph_result(const ResolvedGraph& graph);

}  // namespace weft::test
