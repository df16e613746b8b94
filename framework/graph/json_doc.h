// Purpose: JSON with comments and trailing commas, in which every value and key knows where it was written.
// Limits: 8 MiB, depth 64. Duplicate keys are errors. Errors: W001 … W009 with line and column.
#pragma once

#include <string>
#include <vector>

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
    SourceLoc loc;

    [[nodiscard]] const JsonNode* find(std::string_view key) const;
};

struct JsonMember {
    std::string key;
    SourceLoc key_loc;
    JsonNode value;
};

struct JsonDoc {
    JsonNode root;
    SourceMap sources;
};

// `path` is read through `reader`; a missing file is an error that says so.
[[nodiscard]] Result<JsonDoc> read_json(const std::string& path, const FileReader& reader);
[[nodiscard]] const char* json_kind_name(JsonKind kind);

}  // namespace weft
