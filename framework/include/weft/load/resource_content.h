// Purpose: reads the content of resources that have the key "file", in the form in which a device needs it:
// texels in the format of the image, with all mips, or the bytes of a buffer. load_graph() reads only the
// headers of the files. Errors: W145 the file cannot be read or decoded, or has changed since load_graph().
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "weft/declaration.h"
#include "weft/load/load_graph.h"

namespace weft {

struct ResourceContent {
    // For an image, one item per mip with all its layers, without gaps. For a buffer, one item.
    std::vector<std::vector<std::byte>> levels;
    uint64_t hash = 0;  // Hash of the content. It detects changes, but is not safe against attackers.
};

// Reads the file of a resource of a loaded graph. ResourceDecl::file must not be empty.
[[nodiscard]] Result<ResourceContent> read_resource_content(const ResolvedGraph& graph,
                                                            const ResourceDecl& resource,
                                                            const LoadSettings& settings);

}  // namespace weft
