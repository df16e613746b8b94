// Purpose: makes a ResolvedGraph of a GraphDesc: every name, size, format and version is resolved.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "weft/declaration.h"
#include "weft/device_profile.h"
#include "weft/graph_desc.h"
#include "weft/graph_request.h"
#include "weft/imports.h"
#include "weft/limits.h"
#include "weft/pass.h"
#include "weft/result.h"
#include "weft/shader_interface.h"

namespace weft {

struct ResolveInput {
    const GraphDesc& graph;
    const PassCatalog& passes;
    const ShaderCatalog& shaders;
    const ImportCatalog& imports;
    const DeviceProfile& profile;
    GraphRequest request;  // its parameters, size and observed resources
    GraphLimits limits = {};
    // For images with alternatives, by name: how many of the first alternatives to skip, though the device
    // supports them.
    std::map<std::string, size_t> skipped_formats = {};
};
// W120: values that parameters may not have, defaults among them, and names that the graph does not declare.
[[nodiscard]] Diagnostics param_faults(const GraphDesc& graph, const std::map<std::string, double>& params);
// Warnings are added to `warnings`.
[[nodiscard]] Result<ResolvedGraph> resolve(const ResolveInput& input, Diagnostics& warnings);

}  // namespace weft
