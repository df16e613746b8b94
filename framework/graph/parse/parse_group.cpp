// Parses "groups": { "relight": { "repeat": { "m": "0..5" }, "resources": { "raw": … }, "passes": { … } } }.
// The passes and resources of a group become passes and resources of the graph, with names such as
// "relight::raw".
#include <algorithm>
#include <map>

#include "graph/parse/module_scope.h"
#include "graph/parse/parse_context.h"
#include "graph/syntax/reference_name.h"

namespace weft {
namespace {

// Skips the sections "resources" and "passes" of a group. They need the other keys of the group, so
// parse_groups() reads them later.
void skip_section(ParseContext&, const JsonNode&, GroupDesc&) {}

void read_rounds_per_frame(ParseContext& context, const JsonNode& node, GroupDesc& group) {
    group.per_frame_loc = node.loc;
    // As in the "perFrame" of a pass, false means no limit: all rounds may run in each frame. The number 0
    // means that no round runs.
    const bool is_all = node.kind == JsonKind::boolean && !node.boolean;
    if (!is_all) read_switch(context, node, group.per_frame);
}

void read_turns(ParseContext& context, const JsonNode& node, GroupDesc& group) {
    group.turns_loc = node.loc;
    if (read_string(context, node, group.turns)) group.turns = context.import_name(group.turns, node.loc);
}

constexpr std::array kGroupKeys{
    KeyRule<GroupDesc>{"repeat", read_member<read_repeat, &GroupDesc::repeat>},
    KeyRule<GroupDesc>{"perFrame", read_rounds_per_frame},
    KeyRule<GroupDesc>{"turns", read_turns},
    KeyRule<GroupDesc>{"warmUp", read_located<read_expression, &GroupDesc::warm_up, &GroupDesc::warm_up_loc>},
    KeyRule<GroupDesc>{"rest", read_located<read_bool, &GroupDesc::rests, &GroupDesc::rest_loc>},
    KeyRule<GroupDesc>{"settle", read_located<read_expression, &GroupDesc::settle, &GroupDesc::settle_loc>},
    KeyRule<GroupDesc>{"resources", skip_section},
    KeyRule<GroupDesc>{"passes", skip_section},
};
constexpr std::array<std::string_view, 4> kKeysOfRounds{"perFrame", "turns", "warmUp", "settle"};
constexpr std::array<std::string_view, 2> kKeysOfGroups{"perFrame", "rest"};
constexpr std::array<std::string_view, 6> kKeysOfLasting{"keep",     "history", "firstFrame",
                                                         "onResize", "file",    "textures"};

// Reports keys that a group may have only together with "repeat" or "rest", if that other key is missing.
void check_needs(ParseContext& context, const JsonNode& node) {
    const JsonNode* rest = node.find("rest");
    const bool rests = rest != nullptr && (rest->kind != JsonKind::boolean || rest->boolean);
    for (const JsonMember& member : node.members) {
        if (std::ranges::find(kKeysOfRounds, member.key) == kKeysOfRounds.end()) continue;
        const PointerScope scope(context, member.key);
        if (node.find("repeat") == nullptr)
            context.error(member.key_loc, "W109", "\"" + member.key + "\" is only for groups with \"repeat\"",
                          "remove this key, or add rounds, for example \"repeat\": { \"i\": \"0..3\" }");
        else if (member.key == "settle" && !rests)
            context.error(member.key_loc, "W109", "\"settle\" is only for groups with \"rest\": true",
                          "remove \"settle\", or add \"rest\": true");
    }
}

// Calls refuse(member) for each member of a pass or resource in `section` whose key is one of `keys`.
template <class F>
void for_each_key(ParseContext& context, const JsonNode& section, std::span<const std::string_view> keys,
                  F refuse) {
    for (const JsonMember& member : section.members) {
        const PointerScope scope(context, member.key);
        for (const JsonMember& entry : member.value.members) {
            const PointerScope key(context, entry.key);
            if (std::ranges::find(keys, entry.key) != keys.end()) refuse(entry);
        }
    }
}

void parse_own_resources(ParseContext& context, const JsonNode& section, GraphDesc& graph) {
    const PointerScope scope(context, "resources");
    for_each_key(context, section, kKeysOfLasting, [&](const JsonMember& entry) {
        context.error(entry.key_loc, "W109",
                      "a resource of a group cannot have \"" + entry.key +
                          "\", because its content lasts only for one round",
                      "move the resource to the \"resources\" of the graph, or remove this key");
    });
    parse_resources(context, section, graph);
}

void parse_own_passes(ParseContext& context, const JsonNode& section, GraphDesc& graph) {
    const PointerScope scope(context, "passes");
    for_each_key(context, section, kKeysOfGroups, [&](const JsonMember& entry) {
        context.error(entry.key_loc, "W109", "a pass of a group cannot have \"" + entry.key + "\"",
                      "move the key to the group: it then applies to all passes of the group");
    });
    static constexpr std::array<std::string_view, 1> kType{"type"};
    for_each_key(context, section, kType, [&](const JsonMember& entry) {
        if (entry.value.string == "readback")
            context.error(entry.value.loc, "W109", "a readback pass cannot be in a group",
                          "move the pass to the \"passes\" of the graph");
    });
    parse_passes(context, section, graph);
}

void parse_parts(ParseContext& context, const JsonMember& member, GraphDesc& graph) {
    if (const JsonNode* resources = member.value.find("resources"))
        parse_own_resources(context, *resources, graph);
    const JsonNode* passes = member.value.find("passes");
    if (passes == nullptr)
        return missing_key(context, member.key_loc, "a group", "passes", "write \"passes\": { … }");
    if (passes->kind == JsonKind::object && passes->members.empty())
        context.error(passes->loc, "W109", "the group has no passes", "add a pass, or remove the group");
    parse_own_passes(context, *passes, graph);
}

void add_keys(const JsonNode& group, std::string_view section, std::set<std::string, std::less<>>& names) {
    if (const JsonNode* node = group.find(section))
        for (const JsonMember& member : node->members) names.insert(member.key);
}

// Checks that the key "turns" names an import of kind "turns". An import whose kind is unknown has an error
// already.
void check_turns(ParseContext& context, const GroupDesc& group, const JsonNode* imports) {
    if (group.turns.empty()) return;
    const PointerScope scope(context, "turns");
    const std::string name = "\"" + group.turns + "\"";
    const JsonNode* import = imports == nullptr ? nullptr : imports->find(group.turns);
    if (import == nullptr)
        return context.error(group.turns_loc, "W109", "the graph has no import " + name,
                             "add it to the graph: \"imports\": { " + name + ": \"turns\" }");
    const JsonNode* kind = import->find("kind");
    if (kind == nullptr || kind->kind != JsonKind::string || kind->string == "turns") return;
    context.error(group.turns_loc, "W109",
                  "the import " + name + " is of kind \"" + kind->string + "\", not \"turns\"",
                  "name an import of kind \"turns\"");
}

// Key: a name that the graph declares. Value: the place of this name in the file.
using Places = std::map<std::string, SourceLoc, std::less<>>;

void add_places(const JsonNode& root, std::string_view section, Places& places) {
    if (const JsonNode* node = root.find(section))
        for (const JsonMember& member : node->members) places.emplace(member.key, member.key_loc);
}

// Reports each name in a section of a group that is also a name of the graph, or of the module `module` to
// which the group belongs.
void check_own_names(ParseContext& context, const JsonNode& group, std::string_view section,
                     std::string_view module, const Places& places) {
    const JsonNode* node = group.find(section);
    if (node == nullptr) return;
    const PointerScope section_scope(context, section);
    for (const JsonMember& member : node->members) {
        const auto first = places.find(name_in_group(module, member.key));
        if (first == places.end()) continue;
        const PointerScope scope(context, member.key);
        Diagnostic& error =
            context.error(member.key_loc, "W109", "the name \"" + member.key + "\" is already used");
        error.help.emplace_back("choose another name, because the group could not use the one outside");
        const SourceLoc place = first->second;
        const std::string& file = context.sources().files.at(place.file).path;
        error.notes.push_back({file, place.line, place.column, "first used here"});
    }
}

}  // namespace

void list_group_grammar(std::vector<GrammarTable>& lists) {
    list_keys(lists, "group", kGroupKeys);
}

void parse_groups(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    read_parts(context, node, "a group", [&](const JsonMember& member) {
        GroupDesc group;
        group.name = member.key;
        group.loc = member.key_loc;
        GroupNames names{group, {}, {}};
        add_keys(member.value, "resources", names.resources);
        add_keys(member.value, "passes", names.passes);
        context.set_group(&names);
        context.set_indices(indices_of(member.value, {}));
        if (read_object(context, member.value, "a group", kGroupKeys, group)) {
            check_needs(context, member.value);
            parse_parts(context, member, graph);
        }
        context.set_group(nullptr);
        context.set_indices({});
        graph.groups.emplace(member.key, std::move(group));
    });
}

void check_groups(ParseContext& context, const JsonNode& root, const GraphDesc& graph) {
    const JsonNode* groups = root.find("groups");
    if (groups == nullptr) return;
    Places resources, passes;
    add_places(root, "imports", resources);
    add_places(root, "resources", resources);
    add_places(root, "passes", passes);
    const PointerScope section(context, "groups");
    for (const JsonMember& member : groups->members) {
        const PointerScope scope(context, member.key);
        const std::string_view module = module_of(graph, member.key);
        check_own_names(context, member.value, "resources", module, resources);
        check_own_names(context, member.value, "passes", module, passes);
        if (const auto group = graph.groups.find(member.key); group != graph.groups.end())
            check_turns(context, group->second, root.find("imports"));
    }
}

}  // namespace weft
