// Purpose: a resource with history is a ring of roles, "x", "x[-1]" and so on, which differ in name and age
// only.
#pragma once

#include <string>
#include <vector>

#include "graph/resolve/suspects.h"
#include "weft/declaration.h"

namespace weft {

[[nodiscard]] std::string role_name(const std::string& name, uint32_t age);
// Each role of a ring gets the shape, format and usage of its role of age 0.
void spread_over_rings(std::vector<ResourceDecl>& resources, Suspects& suspects);

}  // namespace weft
