// Purpose: resources with history. Such a resource is a ring of copies, which the graph names "x" (this
// frame), "x[-1]" (one frame ago) and so on. Each copy is one ResourceDecl; the copies differ only in name
// and age.
#pragma once

#include <string>
#include <vector>

#include "graph/resolve/suspects.h"
#include "weft/declaration.h"

namespace weft {

[[nodiscard]] std::string role_name(const std::string& name, uint32_t age);
// For each resource with history, copies shape, format and usage from the copy of the current frame (age 0)
// to all other copies.
void spread_over_rings(std::vector<ResourceDecl>& resources, Suspects& suspects);

}  // namespace weft
