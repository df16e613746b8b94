#include "graph/builder/graph_text.h"

#include <cstdio>

namespace weft {
namespace {

// The root, its sections, and the entries of sections.
constexpr uint32_t kLevelsWithLines = 3;

void write_string(const std::string& text, std::string& out) {
    out += '"';
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
    out += '"';
}

void write_value(const JsonNode& node, uint32_t level, std::string& out);

void write_object(const JsonNode& node, uint32_t level, std::string& out) {
    if (node.members.empty()) {
        out += "{}";
        return;
    }
    const bool has_lines = level < kLevelsWithLines;
    out += has_lines ? "{\n" : "{ ";
    bool is_first = true;
    for (const JsonMember& member : node.members) {
        if (!is_first) out += has_lines ? ",\n" : ", ";
        is_first = false;
        if (has_lines) out.append(size_t{2} * (level + 1), ' ');
        write_string(member.key, out);
        out += ": ";
        write_value(member.value, level + 1, out);
    }
    if (has_lines) {
        out += '\n';
        out.append(size_t{2} * level, ' ');
        out += '}';
    } else {
        out += " }";
    }
}

void write_value(const JsonNode& node, uint32_t level, std::string& out) {
    switch (node.kind) {
        case JsonKind::null:
            out += "null";
            break;
        case JsonKind::boolean:
            out += node.boolean ? "true" : "false";
            break;
        case JsonKind::number:
            out += node.string;
            break;
        case JsonKind::string:
            write_string(node.string, out);
            break;
        case JsonKind::array:
            out += '[';
            for (size_t i = 0; i < node.items.size(); ++i) {
                if (i > 0) out += ", ";
                write_value(node.items[i], kLevelsWithLines, out);
            }
            out += ']';
            break;
        case JsonKind::object:
            write_object(node, level, out);
            break;
    }
}

}  // namespace

std::string graph_text(const JsonNode& root) {
    std::string text;
    write_value(root, 0, text);
    return text + "\n";
}

}  // namespace weft
