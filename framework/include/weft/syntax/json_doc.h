// Purpose: JSON with comments and trailing commas, in which every value and key knows where it was written.
// Limits: of bytes, depth, values and strings, as given.
// Errors: W001 syntax, W002 no such file, W003 duplicate key (all of them are reported), W004 too large or
// too deep, W005 not UTF-8; each with its line and column and a remedy. Source: RFC 8259, with // and /* */
// comments and a comma allowed behind the last value.
#pragma once

#include <string>
#include <vector>

#include "weft/limits.h"
#include "weft/result.h"
#include "weft/source.h"

namespace weft {

enum class JsonKind : uint8_t { null, boolean, number, string, array, object };

struct JsonMember;

struct JsonNode {
    JsonKind kind = JsonKind::null;
    bool boolean = false;
    double number = 0;
    std::string string;               // also the exact spelling of numbers
    std::vector<JsonNode> items;      // arrays
    std::vector<JsonMember> members;  // objects, in the order written
    SourceLoc loc;                    // of the whole token, quotes included; of the opening brace or bracket

    [[nodiscard]] const JsonNode* find(std::string_view key) const;
};

struct JsonMember {
    std::string key;
    SourceLoc key_loc;
    JsonNode value;
};

// A file that another one includes.
struct IncludedJson {
    uint32_t file = 0;  // index into SourceMap::files
    JsonNode root;
};

struct JsonDoc {
    JsonNode root;
    SourceMap sources;                   // the first file is the root's
    std::vector<IncludedJson> included;  // in the order in which they are merged, under the root
};

// `path` is read through `reader`; a missing file is an error that says so.
[[nodiscard]] Result<JsonDoc> read_json(const std::string& path, const FileReader& reader,
                                        const GraphLimits& limits = {});
[[nodiscard]] const char* json_kind_name(JsonKind kind);
// Adds the file to `sources` and reads it. `includer` is where its name was written, if anywhere.
[[nodiscard]] Result<JsonNode> read_json_file(SourceMap& sources, const std::string& path, std::string text,
                                              const GraphLimits& limits, SourceLoc includer = {});
// RFC 6901 pointer of the value or key written at that place of the file; empty when there is none.
[[nodiscard]] std::string pointer_at(const JsonDoc& document, const std::string& file, uint32_t line,
                                     uint32_t column);

}  // namespace weft
