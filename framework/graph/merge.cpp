// Shorthand becomes objects. Anything of an unexpected kind is left as it is: parse() says what was wanted.
#include <algorithm>
#include <map>

#include "graph/reference.h"
#include "graph/stages.h"

namespace weft {
namespace {

JsonNode* find(JsonNode& node, std::string_view key) {
    const auto it = std::find_if(node.members.begin(), node.members.end(),
                                 [&](const JsonMember& member) { return member.key == key; });
    return it == node.members.end() ? nullptr : &it->value;
}

// value → {key: value}, standing where the value stood.
void wrap(JsonNode& node, std::string_view key) {
    JsonNode object;
    object.kind = JsonKind::object;
    object.loc = node.loc;
    object.members.push_back({std::string(key), node.loc, std::move(node)});
    node = std::move(object);
}

void wrap_strings(JsonNode* node, std::string_view key) {
    if (node == nullptr) return;
    for (JsonMember& member : node->members)
        if (member.value.kind == JsonKind::string) wrap(member.value, key);
}

void wrap_params(JsonNode* node) {
    if (node == nullptr) return;
    for (JsonMember& member : node->members)
        if (member.value.kind == JsonKind::number || member.value.kind == JsonKind::boolean)
            wrap(member.value, "default");
}

Diagnostic duplicate_port(const JsonMember& port, SourceLoc first, const SourceMap& sources) {
    Diagnostic error = sources.error(port.key_loc, "W003", "two ports would be called \"" + port.key + "\"");
    error.help.emplace_back("name the ports: {\"a\": \"" + port.value.string + "\", \"b\": …}");
    const std::string file = error.file;
    error.notes.push_back({file, first.line, first.column, "the first is here"});
    return error;
}

// ["a", "b.mip(0)"] → {"a": "a", "b": "b.mip(0)"}: a port written as a bare reference is called like its
// resource.
void name_ports(JsonNode& list, const SourceMap& sources, Diagnostics& errors) {
    const auto is_string = [](const JsonNode& item) { return item.kind == JsonKind::string; };
    if (!std::all_of(list.items.begin(), list.items.end(), is_string)) return;
    std::map<std::string, SourceLoc> first;
    JsonNode object;
    object.kind = JsonKind::object;
    object.loc = list.loc;
    for (JsonNode& item : list.items) {
        JsonMember member{reference_name(item.string), item.loc, std::move(item)};
        const auto [it, is_new] = first.emplace(member.key, member.key_loc);
        if (is_new)
            object.members.push_back(std::move(member));
        else
            errors.push_back(duplicate_port(member, it->second, sources));
    }
    list = std::move(object);
}

void merge_pass(JsonNode& pass, const SourceMap& sources, Diagnostics& errors) {
    for (const std::string_view side : {"in", "out"}) {
        JsonNode* ports = find(pass, side);
        if (ports == nullptr) continue;
        if (ports->kind == JsonKind::array) name_ports(*ports, sources, errors);
        wrap_strings(ports, "ref");
    }
    JsonNode* depth = find(pass, "depth");
    if (depth != nullptr && depth->kind == JsonKind::string) wrap(*depth, "ref");
}

}  // namespace

Result<JsonDoc> merge(JsonDoc document) {
    Diagnostics errors;
    wrap_strings(find(document.root, "imports"), "kind");
    wrap_strings(find(document.root, "resources"), "format");
    wrap_params(find(document.root, "params"));
    if (JsonNode* passes = find(document.root, "passes"))
        for (JsonMember& pass : passes->members) merge_pass(pass.value, document.sources, errors);
    if (!errors.empty()) return errors;
    return document;
}

}  // namespace weft
