// Purpose: the graph format as a JSON schema (draft-07), for editors and validators: schema/format.json,
// which describes each key, completed by the words that the parser knows and by forms in which parts of
// things are allowed, for tiers and including files.
#pragma once

#include <string>
#include <string_view>

namespace weft::viewer {

// schema/format.json. What stands as {} in its definitions is filled in.
[[nodiscard]] std::string_view described_format();

// The schema of all graphs: graphs/weft.schema.json.
[[nodiscard]] std::string format_schema();

}  // namespace weft::viewer
