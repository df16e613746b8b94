// Purpose: merges the JSON of a graph file, of its included files and of one tier.
#pragma once

#include <string>
#include <vector>

#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

// Merges a graph file with its included files and one tier. First expands shorthand notation to objects, so
// that a patch adds to an object instead of replacing a plain value. Then applies each file as a merge patch
// (RFC 7396) to the files that it includes, and finally the changes of the tier. In a patch, null removes a
// member, objects are merged, and any other value replaces the old value. Errors: W003: two ports of a pass
// would get the same name. W239, W240: see ModuleNames::check(). W128: null for a member that does not exist.
// W129: unknown tier. W131: the tier sets a name that is not a parameter.
[[nodiscard]] Result<JsonDoc> merge(JsonDoc document, const std::string& tier = {});
// Returns the names of the tiers in the order of the files. The list is empty if no file declares tiers.
[[nodiscard]] std::vector<std::string> tier_names(const JsonDoc& document);

}  // namespace weft
