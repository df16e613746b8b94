// Purpose: the stage of resolve() that finds extents, mips, layers and bytes of all images and buffers, and
// the contents of imports. Formats are chosen later, when the usages are known. Errors: W105, W106, W109,
// W116, W118, W119, W125.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "graph/resolve/evaluate.h"
#include "graph/resolve/suspects.h"

namespace weft {

struct ResourceOrigin {
    const ResourceDesc* desc = nullptr;  // null: an import
    bool has_content = false;            // before the frame: of imports, history and "keep"
};

struct Shapes {
    std::vector<ResourceDecl> resources;  // sorted by name; only imports have a format
    std::vector<ResourceOrigin> origins;  // by ResourceId
    std::map<std::string, uint32_t> mip_counts;
    std::map<std::string, uint32_t> histories;  // of resources that keep earlier frames
    std::set<std::string> suspect_histories;    // reported
    ResourceId output = kNoId;                  // the import of kind "output"
    bool too_large = false;                     // reported
    Suspects suspects;
};
[[nodiscard]] Shapes shape_resources(const ResolveInput& input, const Values& values, Reporter& reporter);

[[nodiscard]] ResourceId resource_id(const std::vector<ResourceDecl>& resources,
                                     std::string_view name);  // kNoId: none
// Without the roles of earlier frames.
[[nodiscard]] std::vector<std::string> resource_names(const std::vector<ResourceDecl>& resources);

}  // namespace weft
