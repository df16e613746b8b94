// Purpose: makes random frames for tests: 5 to 60 passes over images with mips and layers, buffers and
// imports. Passes write parts of resources, modify content in place, overwrite content and share inputs. Some
// results stay unread. Optional features add persistent resources, queue hints, mip chains and more. A
// disabled option uses no random numbers, so tests that do not enable a new option keep their graphs.
//
// The graphs can run on a device. All passes use exact integer arithmetic on r32u images and u32 buffers (and
// one exact conversion to d32f). So any two correct plans of a graph give the same bytes. Clear, copy and
// readback passes have no shader; the other passes use these shaders in tests/graph/shaders/:
//   compute     fill_image, mix_image_1, mix_image_2, mix_image_3, mix_mips, mix_depth, update_image,
//               mix_buffer_1, mix_buffer_2, update_buffer, image_to_buffer, buffer_to_image   (.comp)
//   fullscreen  mix_color_1, mix_color_2, write_depth, mix_color_depth   (.frag)
// A shader has some of the ports a, b, c and dst, bound in this order in set 1. Colour outputs are at
// location 0. The push constants are `Params { uint seed; }`. A sampled port accesses one layer, with one mip
// or all mips. A storage port accesses one mip of one layer.
//
// A graph may have these imports; a word is a u32. The test program provides them with any content. A test
// that compares two plans gives both plans the same content:
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
    // Adds rings: resources whose content from the last one or two frames is still available.
    bool history = false;
    // Adds resources that keep their content from frame to frame. In each frame, one pass modifies such a
    // resource in place. Other passes may read the resource before or after this pass.
    bool keep = false;
    // Gives passes hints to run on compute and transfer queues. In most graphs, all queue families may use
    // the imports (ImportState::concurrent). Otherwise the passes that use an import could not follow a hint.
    bool queues = false;
    // Adds `after` edges between random passes, which may share no resource.
    bool after = false;
    // Adds passes that write an image mip by mip, from the largest mip to the smallest and sometimes back. If
    // the image has two layers, the passes of layer 0 come first.
    bool chains = false;
    // Adds clears and copies of several mips and layers at once, and passes that use ranges of buffers.
    bool ranges = false;
    // Adds passes that use the same depth image as attachment and as input.
    bool depth_input = false;
    // Adds groups of passes that draw on the same image and can share one rendering scope.
    bool layers = false;
    // Lets some compute passes also sample a table of textures. The other content of the graph stays the
    // same. The shaders of tests/graph/shaders/ have no tables, so such graphs cannot run on a device.
    bool tables = false;
    // Adds dispatches whose numbers of workgroups are in ranges of a buffer.
    bool indirect = false;
    // Adds passes that read the layers of an image as an array.
    bool layer_arrays = false;
    // Adds passes that draw several views with multiview.
    bool views = false;
};

// Returns options with all optional features enabled that can run on a device.
[[nodiscard]] RandomGraphOptions all_features();

[[nodiscard]] ResolvedGraph random_graph(uint32_t seed, const RandomGraphOptions& options = {});

// Returns the image that the pass "read_back" reads. The pass reads the whole image.
[[nodiscard]] ResourceId random_graph_result(const ResolvedGraph& graph);

}  // namespace weft::test
