// Purpose: suggests commands and flags with similar names after a typing error.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace weft::viewer {

// Returns a line "did you mean ...?" for each argument that the parser did not recognise, if a command or
// flag has a similar name. Returns an empty text if there is no such line.
[[nodiscard]] std::string usage_hint(const CLI::App& app);

}  // namespace weft::viewer
