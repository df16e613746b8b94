// Purpose: shaders that fit whatever a graph says of its passes, as interfaces alone, so that a fuzzer gets
// past the matching of ports to the stages behind it without compiling anything.
#pragma once

#include "weft/graph_desc.h"
#include "weft/shader_interface.h"

namespace weft::fuzz {

// By the shader references of the graph's passes. `choices` varies what a port may be in more than one way:
// storage or sampled images, one kind of output or another.
[[nodiscard]] ShaderCatalog fitting_shaders(const GraphDesc& graph, uint64_t choices);

}  // namespace weft::fuzz
