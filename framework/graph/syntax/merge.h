// Purpose: lays the JSON of included files and of one tier over each other.
#pragma once

#include <string>
#include <vector>

#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

// Shorthand becomes objects, so that a patch adds to an object instead of replacing it. Then, as RFC 7396
// says, each file goes over the files that it includes, and the tier over them all: null removes, objects are
// merged, anything else replaces. Errors: W128 null where there is nothing to remove, W129 no such tier, W131
// a tier sets no parameter.
[[nodiscard]] Result<JsonDoc> merge(JsonDoc document, const std::string& tier = {});
// The names of the tiers, in the order written; none where the file does not state its tiers.
[[nodiscard]] std::vector<std::string> tier_names(const JsonDoc& document);

}  // namespace weft
