#include "scene/loading/field_reader.h"

#include <algorithm>
#include <cmath>

#include "graph/diagnostics/quantity_text.h"

namespace weft::scene {

void FieldReader::fault(const SourceLoc& loc, const char* code, std::string message, std::string help) {
    Diagnostic d = document_.sources.error(loc, code, std::move(message));
    d.pointer = pointer_at(document_, d.file, d.line, d.column);
    d.help.push_back(std::move(help));
    faults_.push_back(std::move(d));
}

bool FieldReader::expect(const JsonNode& node, JsonKind kind) {
    if (node.kind == kind) return true;
    fault(node.loc,
          std::string("the value has the type ") + json_kind_name(node.kind) + "; wanted " +
              json_kind_name(kind),
          std::string("write a value of the type ") + json_kind_name(kind) + "; " + page_ +
              " describes the file");
    return false;
}

void FieldReader::check_keys(const JsonNode& object, const std::vector<std::string>& known) {
    for (const JsonMember& member : object.members) {
        if (std::ranges::find(known, member.key) != known.end()) continue;
        std::string names;
        for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
        const std::string guess = did_you_mean_text(member.key, known);
        fault(member.key_loc, "unknown key \"" + member.key + "\"",
              guess.empty() ? "remove it, or use one of the keys " + names : guess);
    }
}

const JsonNode* FieldReader::required(const JsonNode& object, const char* key) {
    const JsonNode* found = object.find(key);
    if (found == nullptr)
        fault(object.loc, std::string("the key \"") + key + "\" is missing",
              std::string("add \"") + key + "\"");
    return found;
}

void FieldReader::check_version(const JsonNode& root) {
    const JsonNode* version = required(root, "version");
    if (version != nullptr && (version->kind != JsonKind::number || version->number != 1))
        fault(version->loc, "\"version\" is not 1", "write \"version\": 1");
}

bool FieldReader::number(const JsonNode& node, const Range& range, bool whole, double& out) {
    if (!expect(node, JsonKind::number)) return false;
    const bool fits = node.number >= range.least && node.number <= range.most;
    if (!fits || (whole && node.number != std::floor(node.number))) {
        fault(node.loc, node.string + " is out of range",
              std::string("write a ") + (whole ? "whole number" : "number") + " from " +
                  number_text(range.least) + " to " + number_text(range.most));
        return false;
    }
    out = node.number;
    return true;
}

std::vector<double> FieldReader::numbers(const JsonNode& node, size_t count, const Range& range, bool whole) {
    if (!expect(node, JsonKind::array)) return {};
    if (node.items.size() != count) {
        fault(
            node.loc,
            "this list has " + count_text(node.items.size(), "number") + "; wanted " + std::to_string(count),
            "write " + std::to_string(count) + " numbers");
        return {};
    }
    std::vector<double> values(count);
    for (size_t i = 0; i < count; ++i)
        if (!number(node.items[i], range, whole, values[i])) return {};
    return values;
}

glm::vec3 FieldReader::vector(const JsonNode* node, const Range& range, const glm::vec3& usual) {
    if (node == nullptr) return usual;
    const std::vector<double> v = numbers(*node, 3, range, false);
    return v.empty() ? usual : glm::vec3(v[0], v[1], v[2]);
}

std::optional<glm::ivec3> FieldReader::whole_vector(const JsonNode& node, const Range& range) {
    const std::vector<double> v = numbers(node, 3, range, true);
    return v.empty() ? std::nullopt : std::optional(glm::ivec3(v[0], v[1], v[2]));
}

}  // namespace weft::scene
