#include "graph/builder/graph_object.h"

#include <algorithm>

#include "graph/builder/json_text.h"

namespace weft {
namespace {

// Number of levels of objects whose keys stand on lines of their own: the root, its sections, and the entries
// of sections.
constexpr uint32_t kLevelsWithLines = 3;

void write_object(const GraphObject& object, uint32_t level, std::string& out) {
    if (object.members.empty()) {
        out += "{}";
        return;
    }
    const bool has_lines = level < kLevelsWithLines;
    out += has_lines ? "{\n" : "{ ";
    for (const GraphMember& member : object.members) {
        if (&member != &object.members.front()) out += has_lines ? ",\n" : ", ";
        if (has_lines) out.append(size_t{2} * (level + 1), ' ');
        out += json_string(member.key) + ": ";
        if (member.object) {
            write_object(*member.object, level + 1, out);
        } else {
            out += member.json;
        }
    }
    out += has_lines ? "\n" + std::string(size_t{2} * level, ' ') + "}" : " }";
}

}  // namespace

void GraphObject::add(const std::string& key, const std::string& json) {
    members.push_back({key, json, nullptr});
}

GraphObject& GraphObject::add_object(const std::string& key) {
    members.push_back({key, {}, std::make_unique<GraphObject>()});
    return *members.back().object;
}

GraphObject& GraphObject::section(const std::string& key) {
    const auto found = std::ranges::find_if(
        members, [&](const GraphMember& member) { return member.object && member.key == key; });
    return found != members.end() ? *found->object : add_object(key);
}

std::string graph_text(const GraphObject& root) {
    std::string text;
    write_object(root, 0, text);
    return text + "\n";
}

}  // namespace weft
