// Purpose: suggests commands and flags with similar names.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace weft::viewer {

// After a failed parse: a line "did you mean …?" for each argument that was not recognised; empty if there
// are no suggestions.
[[nodiscard]] std::string usage_hint(const CLI::App& app);

}  // namespace weft::viewer
