// Purpose: makes shader interfaces that match the passes of any graph. With them a fuzzer can test the stages
// after the matching of ports without compiling shaders.
#pragma once

#include "weft/graph_desc.h"
#include "weft/shader_interface.h"

namespace weft::fuzz {

// Indexed by the shader references of the graph's passes. `choices` selects among the possible kinds of each
// port, such as storage or sampled image.
[[nodiscard]] ShaderCatalog fitting_shaders(const GraphDesc& graph, uint64_t choices);

}  // namespace weft::fuzz
