// Purpose: applies one JSON document to another as a JSON merge patch (RFC 7396): objects are merged member
// by member, null removes a member, and any other value replaces the old value. Internal to weft_graph.
#pragma once

#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

// Collects further results of a merge: its errors, and (in SourceMap::replacements) the places of each
// replaced value and of the value that replaced it.
struct PatchLog {
    SourceMap& sources;
    // apply_patch() adds errors of code W128: a null in the patch names a member that does not exist. merge()
    // adds errors of other codes.
    Diagnostics errors;
};

// Says what null means in a patch. `remove`: null removes the member of this name. `remove_outside_tiers`:
// used when files are merged; a null in the patch of a tier ("/tiers/NAME/patch") is kept as a value, because
// that patch is applied later.
enum class NullMeaning : uint8_t { remove, remove_outside_tiers };

void apply_patch(JsonNode& target, JsonNode patch, NullMeaning nulls, PatchLog& log);

}  // namespace weft
