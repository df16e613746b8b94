// Purpose: writes a JSON value as the text of a graph file.
#pragma once

#include <string>

#include "weft/syntax/json_doc.h"

namespace weft {

// Writes each key of the graph, of its sections, and of the entries of sections on a line of its own, so that
// the line of an error shows the faulty key. Deeper values are on one line.
[[nodiscard]] std::string graph_text(const JsonNode& root);

}  // namespace weft
