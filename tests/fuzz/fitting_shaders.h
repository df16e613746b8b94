// Purpose: makes shader interfaces for the passes of any graph. Their bindings and outputs match the ports of
// the passes. So the fuzzer can test the stages after the matching of ports, although no shader is compiled.
#pragma once

#include "weft/graph_desc.h"
#include "weft/shader_interface.h"

namespace weft::fuzz {

// Returns a shader interface for each shader reference of the graph's passes. `choices` is a seed that
// selects among the possible kinds of each port, such as storage image or sampled image.
[[nodiscard]] ShaderCatalog fitting_shaders(const GraphDesc& graph, uint64_t choices);

}  // namespace weft::fuzz
