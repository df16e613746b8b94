// Purpose: formats lists of names for messages.
#pragma once

#include <string>
#include <vector>

namespace weft {

// Returns the names in quotes, for example `"a", "b" and "c"`. Of a long list only the first names are shown,
// followed by the number of omitted names.
[[nodiscard]] std::string quoted_list(const std::vector<std::string>& names);

}  // namespace weft
