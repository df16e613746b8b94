// Purpose: one JSON document laid over another, as JSON merge patches are (RFC 7396): objects are merged
// member by member, null removes a member, anything else replaces what was there. Internal to weft_graph.
#pragma once

#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

// What goes on beside the merging: faults, and which value stands for which (SourceMap::replacements).
struct PatchLog {
    SourceMap& sources;
    Diagnostics errors;  // W128: null for a member that isn't there
};

// A tier's patch is kept as it is, nulls included, when the files that hold it are merged.
enum class NullMeaning : uint8_t { remove, remove_outside_tiers };

void apply_patch(JsonNode& target, JsonNode patch, NullMeaning nulls, PatchLog& log);

}  // namespace weft
