// Expands shorthand notation to objects, then merges the included files and the tier into one document.
// Leaves values of an unexpected kind unchanged, because parse() reports such values later.
#include <algorithm>
#include <array>
#include <map>

#include "graph/diagnostics/quoted_list.h"
#include "graph/syntax/json_patch.h"
#include "graph/syntax/merge.h"
#include "graph/syntax/module_names.h"
#include "graph/syntax/port_kinds.h"
#include "graph/syntax/reference_name.h"

namespace weft {
namespace {

JsonNode* find(JsonNode& node, std::string_view key) {
    const auto it = std::find_if(node.members.begin(), node.members.end(),
                                 [&](const JsonMember& member) { return member.key == key; });
    return it == node.members.end() ? nullptr : &it->value;
}

// Replaces `node` by an object {key: node} at the same source location.
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
    Diagnostic error =
        sources.error(port.key_loc, "W003", "two ports would have the name \"" + port.key + "\"");
    error.help.emplace_back("give each port a name: {\"a\": \"" + port.value.string + "\", \"b\": …}");
    const std::string file = error.file;
    error.notes.push_back({file, first.line, first.column, "the first of these ports is here"});
    return error;
}

// Converts a list of references to an object with one named port per reference: ["a", "b.mip(0)"] becomes
// {"a": "a", "b": "b.mip(0)"}. The port gets the name of the resource in the reference.
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

// Expands the shorthand notation in the ports and the depth attachment of one pass.
void expand_pass(JsonNode& pass, const SourceMap& sources, Diagnostics& errors) {
    for (const std::string_view side : {"in", "out"}) {
        JsonNode* ports = find(pass, side);
        if (ports == nullptr) continue;
        if (ports->kind == JsonKind::array) name_ports(*ports, sources, errors);
        wrap_strings(ports, "ref");
    }
    JsonNode* depth = find(pass, "depth");
    if (depth != nullptr && depth->kind == JsonKind::string) wrap(*depth, "ref");
}

// Expands the shorthand notation in the resources and passes of a graph or of a group.
void expand_parts(JsonNode& owner, const SourceMap& sources, Diagnostics& errors) {
    wrap_strings(find(owner, "resources"), "format");
    if (JsonNode* passes = find(owner, "passes"))
        for (JsonMember& pass : passes->members) expand_pass(pass.value, sources, errors);
}

void expand_sections(JsonNode& root, const SourceMap& sources, Diagnostics& errors) {
    wrap_strings(find(root, "imports"), "kind");
    wrap_strings(find(root, "debug"), "show");
    wrap_params(find(root, "params"));
    expand_parts(root, sources, errors);
    if (JsonNode* groups = find(root, "groups"))
        for (JsonMember& group : groups->members) expand_parts(group.value, sources, errors);
}

void expand(JsonNode& root, const SourceMap& sources, Diagnostics& errors) {
    expand_sections(root, sources, errors);
    JsonNode* tiers = find(root, "tiers");
    if (tiers == nullptr) return;
    for (JsonMember& tier : tiers->members)
        if (JsonNode* patch = find(tier.value, "patch")) expand_sections(*patch, sources, errors);
}

// Removes the keys that describe only the file itself, such as "name", because the including file does not
// inherit them.
JsonNode without_own_keys(JsonNode root) {
    std::erase_if(root.members, [](const JsonMember& member) {
        return member.key == "name" || member.key == "$schema" || member.key == "include" ||
               member.key == "ports";
    });
    return root;
}

void merge_files(JsonDoc& document, PatchLog& log) {
    if (document.included.empty()) return;
    JsonNode merged = without_own_keys(std::move(document.included.front().root));
    for (size_t i = 1; i < document.included.size(); ++i)
        apply_patch(merged, without_own_keys(std::move(document.included[i].root)),
                    NullMeaning::remove_outside_tiers, log);
    const SourceLoc loc = document.root.loc;
    apply_patch(merged, std::move(document.root), NullMeaning::remove_outside_tiers, log);
    document.root = std::move(merged);
    document.root.loc = loc;
    document.included.clear();
}

Diagnostic unknown_tier(const JsonDoc& document, const std::string& name) {
    const std::vector<std::string> names = tier_names(document);
    const JsonNode* tiers = document.root.find("tiers");
    const SourceLoc loc = tiers != nullptr ? tiers->loc : document.root.loc;
    Diagnostic d = document.sources.error(loc, "W129", "the graph has no tier \"" + name + "\"");
    const std::string near = did_you_mean_text(name, names);
    if (!near.empty()) d.help.push_back(near);
    d.help.push_back(names.empty() ? "this graph has no tiers: remove the tier name"
                                   : "choose one of its tiers: " + quoted_list(names));
    return d;
}

// Applies the "set" of a tier, which changes the default values of parameters.
void set_params(JsonNode& root, const JsonNode& values, PatchLog& log) {
    JsonNode* params = find(root, "params");
    for (const JsonMember& value : values.members) {
        JsonNode* param = params != nullptr ? find(*params, value.key) : nullptr;
        JsonNode* fallback = param != nullptr ? find(*param, "default") : nullptr;
        if (fallback != nullptr) {
            apply_patch(*fallback, value.value, NullMeaning::remove, log);
            continue;
        }
        std::vector<std::string> names;
        if (params != nullptr)
            for (const JsonMember& member : params->members) names.push_back(member.key);
        Diagnostic& d = log.errors.emplace_back(
            log.sources.error(value.key_loc, "W131",
                              "the tier sets \"" + value.key + "\", which is not a parameter of the graph"));
        const std::string near = did_you_mean_text(value.key, names);
        d.help.push_back(!near.empty()   ? near
                         : names.empty() ? "declare the parameter in \"params\" first"
                                         : "the parameters are " + quoted_list(names) +
                                               "; use \"patch\" to change anything else");
    }
}

// Keeps only the sections of a tier's patch that a tier may change. parse() reports any other section at its
// place in the file.
JsonNode known_sections(JsonNode patch) {
    static constexpr std::array<std::string_view, 11> kSections{"imports",   "consts", "params", "sizes",
                                                                "resources", "passes", "groups", "views",
                                                                "debug",     "frames", "jitter"};
    std::erase_if(patch.members, [](const JsonMember& member) {
        return std::ranges::find(kSections, member.key) == kSections.end();
    });
    return patch;
}

void merge_tier(JsonDoc& document, const std::string& name, PatchLog& log) {
    JsonNode* tiers = find(document.root, "tiers");
    const JsonNode* tier = tiers != nullptr ? tiers->find(name) : nullptr;
    if (tier == nullptr) {
        log.errors.push_back(unknown_tier(document, name));
        return;
    }
    const JsonNode* patch = tier->find("patch");
    const JsonNode* values = tier->find("set");
    const JsonNode set_values = values != nullptr ? *values : JsonNode{};
    if (patch != nullptr && patch->kind == JsonKind::object)
        apply_patch(document.root, known_sections(*patch), NullMeaning::remove, log);
    set_params(document.root, set_values, log);
}

}  // namespace

std::vector<std::string> tier_names(const JsonDoc& document) {
    std::vector<std::string> names;
    const auto gather = [&](const JsonNode& root) {
        const JsonNode* tiers = root.find("tiers");
        if (tiers == nullptr) return;
        for (const JsonMember& tier : tiers->members)
            if (std::ranges::find(names, tier.key) == names.end() && tier.value.kind == JsonKind::object)
                names.push_back(tier.key);
    };
    for (const IncludedJson& included : document.included) gather(included.root);
    gather(document.root);
    // Leaves out each tier that the including file removes with null.
    const JsonNode* last = document.root.find("tiers");
    std::erase_if(names, [&](const std::string& name) {
        const JsonNode* tier = last != nullptr ? last->find(name) : nullptr;
        return tier != nullptr && tier->kind == JsonKind::null;
    });
    return names;
}

Result<JsonDoc> merge(JsonDoc document, const std::string& tier) {
    PatchLog log{document.sources, {}};
    for (IncludedJson& included : document.included) expand(included.root, document.sources, log.errors);
    expand(document.root, document.sources, log.errors);
    PortKinds kinds;
    for (IncludedJson& included : document.included) {
        if (document.modules.empty()) break;
        const uint32_t module = document.module_of_file[included.file];
        find_declared_kinds(included.root, document.modules[module], kinds[module]);
        qualify_names(included.root, document.modules[module]);
    }
    merge_files(document, log);
    if (!document.modules.empty()) {
        find_used_kinds(document, kinds);
        const ModuleNames names(document);
        names.check(document, log.errors);
        check_port_kinds(document, names, kinds, log.errors);
    }
    if (!tier.empty()) merge_tier(document, tier, log);
    if (!log.errors.empty()) return std::move(log.errors);
    return document;
}

}  // namespace weft
