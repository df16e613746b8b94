#include "graph/builder/json_text.h"

#include <cstdio>

namespace weft {

std::string json_string(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            char escape[8];
            std::snprintf(escape, sizeof(escape), "\\u%04x", static_cast<unsigned>(c));
            out += escape;
        } else {
            out += c;
        }
    }
    return out + '"';
}

std::string json_text(const JsonNode& node) {
    std::string inner;
    switch (node.kind) {
        case JsonKind::null:
            return "null";
        case JsonKind::boolean:
            return node.boolean ? "true" : "false";
        case JsonKind::number:
            return node.string;
        case JsonKind::string:
            return json_string(node.string);
        case JsonKind::array:
            for (const JsonNode& item : node.items) inner += (inner.empty() ? "" : ", ") + json_text(item);
            return "[" + inner + "]";
        case JsonKind::object:
            for (const JsonMember& member : node.members)
                inner +=
                    (inner.empty() ? "" : ", ") + json_string(member.key) + ": " + json_text(member.value);
            return inner.empty() ? "{}" : "{ " + inner + " }";
    }
    return inner;
}

}  // namespace weft
