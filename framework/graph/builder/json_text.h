// Purpose: writes JSON values as text on one line.
#pragma once

#include <string>

#include "weft/syntax/json_doc.h"

namespace weft {

// Returns a JSON string with its quotes.
[[nodiscard]] std::string json_string(const std::string& text);
// Returns the text of a value. Numbers keep their text, for example 1.50.
[[nodiscard]] std::string json_text(const JsonNode& node);

}  // namespace weft
