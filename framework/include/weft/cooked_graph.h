// Purpose: a resolved graph and its compiled shaders as bytes, for programs that ship graphs and neither read
// graph files nor compile GLSL. cook() and `weft plan --format cooked` make the bytes, and read_cooked()
// reads them. None of these needs a device. The program compiles the graph for its device with compile(),
// which takes milliseconds. The bytes depend on the version of Weft, on the request (tier, parameters, size)
// and on the device profile, by which formats were chosen. Read only bytes from a source that you trust: the
// SPIR-V is not checked again. A hash detects damaged bytes. Error: V427.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "weft/declaration.h"
#include "weft/result.h"
#include "weft/shader_interface.h"

namespace weft {

struct CookedGraph {
    ResolvedGraph graph;  // Without the texts and places of the graph file.
    ShaderCatalog shaders;
};

[[nodiscard]] std::vector<std::byte> cook(const ResolvedGraph& graph, const ShaderCatalog& shaders);
// `name` names the bytes in messages, for example the path of their file.
[[nodiscard]] Result<CookedGraph> read_cooked(std::span<const std::byte> bytes, const std::string& name);

}  // namespace weft
