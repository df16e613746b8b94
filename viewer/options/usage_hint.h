// Purpose: names of commands and flags that a user may have meant.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace weft::viewer {

// After a parse that failed: "did you mean …?" for the arguments that nothing took, a line each; else empty.
[[nodiscard]] std::string usage_hint(const CLI::App& app);

}  // namespace weft::viewer
