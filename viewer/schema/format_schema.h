// Purpose: makes the JSON schema (draft-07) of the graph format, for editors and validators. The schema has
// three parts. The first part is viewer/schema/format.json, which describes each key. The second part is the
// words that the parser knows. The third part is the schemas of patches, which occur in tiers and in files
// that include other files.
#pragma once

#include <string>
#include <string_view>

namespace weft::viewer {

// Returns the contents of viewer/schema/format.json. format_schema() completes the definitions that are empty
// ({}) in that file.
[[nodiscard]] std::string_view format_description();

// Returns the schema of all graphs. The file graphs/weft.schema.json contains this text.
[[nodiscard]] std::string format_schema();

}  // namespace weft::viewer
