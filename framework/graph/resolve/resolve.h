// Purpose: converts a GraphDesc into a ResolvedGraph, in which every name, size, format and version is
// resolved.
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
    // resolve() uses only the parameter values, the output size, the observed references, the sizes of
    // imports and the exports of the request.
    GraphRequest request;
    GraphLimits limits = {};
    // For images with a list of formats, by the name of the image: the number of formats at the start of the
    // list that are skipped although the device supports them. Used to give an image the same format in all
    // tiers.
    std::map<std::string, size_t> skipped_formats = {};
};
// Returns an error W120 for each parameter value that the graph does not allow (default values included), and
// for each name that is not a parameter of the graph.
[[nodiscard]] Diagnostics param_faults(const GraphDesc& graph, const std::map<std::string, double>& params);
// Resolves a graph. Errors are in the result, and warnings are added to `warnings`.
[[nodiscard]] Result<ResolvedGraph> resolve(const ResolveInput& input, Diagnostics& warnings);

}  // namespace weft
