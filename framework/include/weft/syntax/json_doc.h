// Purpose: JSON with comments and trailing commas; every value and key has its place in the file. Limits:
// bytes, depth, values and strings, as given. Errors: W001 syntax, W002 no such file, W003 duplicate key (all
// are reported), W004 too large or too deep, W005 not UTF-8; each with its line and column and a remedy.
// Source: RFC 8259, plus // and /* */ comments and a comma after the last value.
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
    std::string string;               // also the exact text of numbers
    std::vector<JsonNode> items;      // for arrays
    std::vector<JsonMember> members;  // for objects, in the order written
    SourceLoc loc;                    // place of the whole token, including quotes; of the opening brace or
                                      // bracket

    [[nodiscard]] const JsonNode* find(std::string_view key) const;
};

struct JsonMember {
    std::string key;
    SourceLoc key_loc;
    JsonNode value;
};

// A file included by another one.
struct IncludedJson {
    uint32_t file = 0;  // index into SourceMap::files
    JsonNode root;
};

struct JsonDoc {
    JsonNode root;
    SourceMap sources;                   // the first file is that of the root
    std::vector<IncludedJson> included;  // in merge order, below the root
};

// Reads `path` with `reader`; a missing file is an error.
[[nodiscard]] Result<JsonDoc> read_json(const std::string& path, const FileReader& reader,
                                        const GraphLimits& limits = {});
[[nodiscard]] const char* json_kind_name(JsonKind kind);
// Adds the file to `sources` and reads it. `includer` is the place of the include, if there is one.
[[nodiscard]] Result<JsonNode> read_json_file(SourceMap& sources, const std::string& path, std::string text,
                                              const GraphLimits& limits, SourceLoc includer = {});
// RFC 6901 pointer of the value or key at that place of the file; empty if there is none.
[[nodiscard]] std::string pointer_at(const JsonDoc& document, const std::string& file, uint32_t line,
                                     uint32_t column);

}  // namespace weft
