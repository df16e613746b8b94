// Purpose: random frames for tests: 5 to 60 passes over images with mips and layers, buffers and imports,
// with partial ranges, in-place writes, overwrites, several readers, and unused branches. Optional features:
// persistent resources, queue hints, mip chains and more. A disabled option uses no random numbers, so that a
// seed keeps its graph.
//
// The graphs can run on a device. All passes use exact integer arithmetic on r32u images and u32 buffers (and
// one exact conversion to d32f), so that any two correct plans of a graph give the same bytes. Passes without
// a shader are clear, copy and readback; the others use this fixed set in tests/graph/shaders/:
//   compute     fill_image, mix_image_1, mix_image_2, mix_image_3, mix_depth, update_image,
//               mix_buffer_1, mix_buffer_2, update_buffer, image_to_buffer, buffer_to_image   (.comp)
//   fullscreen  mix_color_1, mix_color_2, write_depth, mix_color_depth   (.frag)
// Ports a, b, c, dst, bound in this order in set 1; colours at location 0; `Params { uint seed; }` in push
// constants. Sampled ports see one layer, and one mip or all of them; storage ports see one mip of one layer.
//
// Imports that a graph may have (the runner provides them, with any content, the same for both plans):
//   import_image  r32u, 32 px, stays in shader_read_only     import_words  256 words, only read
//   state_words   256 words, modified in place by a pass with a side effect
// The result is the data of the readback pass "read_back": random_graph_result().
#pragma once

#include <cstdint>

#include "weft/declaration.h"

namespace weft::test {

struct RandomGraphOptions {
    uint32_t min_passes = 5;
    uint32_t max_passes = 60;
    bool history = false;      // rings of two or three images or buffers
    bool keep = false;         // kept resources, modified in place and read before and after
    bool queues = false;       // hints to use compute and transfer queues; most imports are concurrent
    bool after = false;        // edges without a shared resource
    bool chains = false;       // passes that process an image mip by mip, down and up again, layer by layer
    bool ranges = false;       // clears and copies of several mips and layers
    bool depth_input = false;  // depth as attachment and input of the same pass
    bool layers = false;       // several passes that draw on the same image and can share one rendering scope
};

// All options above.
[[nodiscard]] RandomGraphOptions all_features();

[[nodiscard]] ResolvedGraph random_graph(uint32_t seed, const RandomGraphOptions& options = {});

// The image that "read_back" reads as a whole.
[[nodiscard]] ResourceId random_graph_result(const ResolvedGraph& graph);

}  // namespace weft::test
