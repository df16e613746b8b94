// Purpose: the stage of resolve() that finds the extents, mips, layers and sizes of all images and buffers,
// and the properties of imports. Formats are chosen in a later stage, when all usages are known. Errors:
// W105, W106, W109, W116, W118, W119, W125.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "graph/resolve/evaluate.h"
#include "graph/resolve/suspects.h"

namespace weft {

struct ResourceOrigin {
    // The description in the graph file; null for an import.
    const ResourceDesc* desc = nullptr;
    // True if the resource has content before the frame begins. These resources have such content: imports
    // (except images with entry layout UNDEFINED), earlier frames of a history, and resources with "keep".
    bool has_content = false;
};

struct Shapes {
    // All resources, sorted by name. At this stage only imports have a format.
    std::vector<ResourceDecl> resources;
    // The origin of each resource, indexed by ResourceId.
    std::vector<ResourceOrigin> origins;
    // Number of mips of each image, by name, for mips() in expressions.
    std::map<std::string, uint32_t> mip_counts;
    // Number of earlier frames that a resource keeps, by name. Only resources with history are in the map.
    std::map<std::string, uint32_t> histories;
    // Names of the resources whose "history" has an error that was reported.
    std::set<std::string> suspect_histories;
    // The import of kind "output", or kNoId if the graph has none.
    ResourceId output = kNoId;
    // True if the graph has too many resources. The error was reported.
    bool too_large = false;
    Suspects suspects;
};
[[nodiscard]] Shapes shape_resources(const ResolveInput& input, const Values& values, Reporter& reporter);

// Returns the index of a resource by its name, or kNoId if there is no such resource.
[[nodiscard]] ResourceId resource_id(const std::vector<ResourceDecl>& resources, std::string_view name);
// Returns the names of all resources, without entries for earlier frames such as "color[-1]".
[[nodiscard]] std::vector<std::string> resource_names(const std::vector<ResourceDecl>& resources);

}  // namespace weft
