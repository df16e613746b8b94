// Purpose: lists of names in messages.
#pragma once

#include <string>
#include <vector>

namespace weft {

// For example `"a", "b" and "c"`; a long list is shortened.
[[nodiscard]] std::string quoted_list(const std::vector<std::string>& names);

}  // namespace weft
