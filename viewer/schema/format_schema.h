// Purpose: the graph format as a JSON schema (draft-07), for editors and validators. It consists of
// schema/format.json, which describes each key, the words known to the parser, and additional forms for
// patches in tiers and including files.
#pragma once

#include <string>
#include <string_view>

namespace weft::viewer {

// The content of schema/format.json. Definitions that are {} there are filled in by format_schema().
[[nodiscard]] std::string_view described_format();

// The schema of all graphs, which is stored as graphs/weft.schema.json.
[[nodiscard]] std::string format_schema();

}  // namespace weft::viewer
