// Purpose: applies one JSON document to another as a JSON merge patch (RFC 7396): objects are merged member
// by member, null removes a member, and any other value replaces the old one. Internal to weft_graph.
#pragma once

#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

// Side results of a merge: faults, and which value replaced which (SourceMap::replacements).
struct PatchLog {
    SourceMap& sources;
    Diagnostics errors;  // W128: null for a member that does not exist
};

// remove_outside_tiers: when files are merged, the patch of a tier is kept as it is, including its nulls.
enum class NullMeaning : uint8_t { remove, remove_outside_tiers };

void apply_patch(JsonNode& target, JsonNode patch, NullMeaning nulls, PatchLog& log);

}  // namespace weft
