// Purpose: merges the JSON of included files and of one tier.
#pragma once

#include <string>
#include <vector>

#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

// Expands shorthand to objects, so that a patch adds to an object instead of replacing it. Then, as in RFC
// 7396, each file is applied to the files that it includes, and the tier to the result: null removes, objects
// are merged, any other value replaces. Errors: W128 null for a member that does not exist, W129 no such
// tier, W131 a tier sets no parameter.
[[nodiscard]] Result<JsonDoc> merge(JsonDoc document, const std::string& tier = {});
// The names of the tiers, in the order written; empty if the file declares no tiers.
[[nodiscard]] std::vector<std::string> tier_names(const JsonDoc& document);

}  // namespace weft
