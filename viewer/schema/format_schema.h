// Purpose: makes the JSON schema (draft-07) of the graph format, for editors and validators. The schema
// consists of schema/format.json, which describes each key, the words that the parser knows, and additional
// forms for patches in tiers and in files that include others.
#pragma once

#include <string>
#include <string_view>

namespace weft::viewer {

// Returns the contents of schema/format.json. Definitions that are {} in that file are filled in by
// format_schema().
[[nodiscard]] std::string_view format_description();

// Returns the schema of all graphs. The file graphs/weft.schema.json contains this text.
[[nodiscard]] std::string format_schema();

}  // namespace weft::viewer
