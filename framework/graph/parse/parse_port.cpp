#include <algorithm>

#include "graph/parse/parse_context.h"
#include "graph/parse/reference.h"

namespace weft {
namespace {

struct PortDraft {
    PortDesc port;
    std::optional<ColorDesc> clear;
    bool has_ref = false;
};

void read_ref(ParseContext& context, const JsonNode& node, PortDraft& draft) {
    draft.has_ref = true;
    read_reference(context, node, draft.port.ref);
}

void read_else(ParseContext& context, const JsonNode& node, PortDraft& draft) {
    RefDesc ref;
    if (read_reference(context, node, ref)) draft.port.otherwise = std::move(ref);
}

void read_wakes(ParseContext& context, const JsonNode& node, PortDraft& draft) {
    read_bool(context, node, draft.port.wakes);
}

void read_optional(ParseContext& context, const JsonNode& node, PortDraft& draft) {
    read_bool(context, node, draft.port.optional);
}

constexpr std::array kEachParts{Choice<EachPart>{"mip", EachPart::mip},
                                Choice<EachPart>{"layer", EachPart::layer}};

void read_each(ParseContext& context, const JsonNode& node, PortDraft& draft) {
    draft.port.each_loc = node.loc;
    read_choice(context, node, kEachParts, draft.port.each);
}

void read_sampler(ParseContext& context, const JsonNode& node, PortDraft& draft) {
    parse_sampler(context, node, draft.port);
}

void read_port_clear(ParseContext& context, const JsonNode& node, PortDraft& draft) {
    read_color(context, node, draft.clear);
}

constexpr std::array kInputKeys{
    KeyRule<PortDraft>{"ref", read_ref},           KeyRule<PortDraft>{"else", read_else},
    KeyRule<PortDraft>{"optional", read_optional}, KeyRule<PortDraft>{"wakes", read_wakes},
    KeyRule<PortDraft>{"each", read_each},         KeyRule<PortDraft>{"sampler", read_sampler}};
constexpr std::array kOutputKeys{KeyRule<PortDraft>{"ref", read_ref}, KeyRule<PortDraft>{"each", read_each},
                                 KeyRule<PortDraft>{"clear", read_port_clear}};

constexpr std::array kGroupsKeys{KeyRule<PortDraft>{"indirect", read_ref}};

struct DrawsDraft {
    PortDraft commands;
    PortDraft count;
    std::string list;
    SourceLoc list_loc;
};
constexpr std::array kDrawsKeys{
    KeyRule<DrawsDraft>{"list", read_located<read_string, &DrawsDraft::list, &DrawsDraft::list_loc>},
    KeyRule<DrawsDraft>{"indirect", read_member<read_ref, &DrawsDraft::commands>},
    KeyRule<DrawsDraft>{"count", read_member<read_ref, &DrawsDraft::count>}};

constexpr std::array kVerticesKeys{
    KeyRule<PassDesc>{"vertices", read_member<read_expression, &PassDesc::vertices>},
    KeyRule<PassDesc>{"instances", read_member<read_expression, &PassDesc::instances>}};

template <size_t N>
PortDraft read_port(ParseContext& context, const JsonNode& node, std::string name, SourceLoc loc,
                    std::string_view what, const std::array<KeyRule<PortDraft>, N>& keys) {
    PortDraft draft;
    draft.port.port = std::move(name);
    draft.port.loc = loc;
    if (node.kind != JsonKind::object)
        wrong_type(context, node, "a reference in a string");
    else if (read_object(context, node, what, keys, draft) && !draft.has_ref)
        missing_key(context, loc, what, "ref", "name the resource: {\"ref\": \"name\"}");
    return draft;
}

// Returns true if `node` is an object of ports. Reports other values as errors. merge() has already replaced
// each valid list, such as ["hdr"], by an object. So a list here contains a value that is not a string.
bool is_port_map(ParseContext& context, const JsonNode& node) {
    if (node.kind == JsonKind::object) return true;
    if (node.kind != JsonKind::array) {
        wrong_type(context, node, "a list of references or an object of ports");
        return false;
    }
    for (size_t i = 0; i < node.items.size() && !context.is_full(); ++i) {
        const PointerScope scope(context, std::to_string(i));
        expect(context, node.items[i], JsonKind::string);
    }
    return false;
}

// Checks the number of ports of one kind against the limit graph.passPorts. Inputs, outputs and resolve
// targets of a pass are counted separately.
bool check_port_count(ParseContext& context, size_t count, SourceLoc loc) {
    return context.within(count, context.limits().pass_ports, loc, "ports of one kind in a pass",
                          "graph.passPorts", "use one image with layers instead of many images");
}

// Returns true if merge() took the name of the port from its reference, as in the shorthand ["hdr"]. Name and
// reference then have the same location in the file. Such a name is not checked: if it is invalid, the
// reference is invalid too, and one error is enough.
bool named_by_reference(const JsonMember& member) {
    const JsonNode* ref = member.value.find("ref");
    return ref != nullptr && ref->loc.line == member.key_loc.line && ref->loc.column == member.key_loc.column;
}

template <class F>
void read_ports(ParseContext& context, const JsonNode& node, F read) {
    if (!is_port_map(context, node)) return;
    size_t count = 0;
    for (const JsonMember& member : node.members) {
        if (context.is_full()) break;
        if (!check_port_count(context, ++count, member.key_loc)) return;
        const PointerScope scope(context, member.key);
        if (named_by_reference(member) || check_identifier(context, "a port", member.key, member.key_loc))
            read(member);
    }
}

}  // namespace

void list_port_grammar(std::vector<GrammarTable>& lists) {
    list_keys(lists, "input", kInputKeys);
    list_keys(lists, "output", kOutputKeys);
    list_choices(lists, "each", kEachParts);
    list_sampler_grammar(lists);
    list_keys(lists, "indirectGroups", kGroupsKeys);
    list_keys(lists, "indirectDraws", kDrawsKeys);
    list_keys(lists, "proceduralDraws", kVerticesKeys);
}

void parse_inputs(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    pass.in.reserve(node.members.size());
    read_ports(context, node, [&](const JsonMember& member) {
        PortDraft draft =
            read_port(context, member.value, member.key, member.key_loc, "an input", kInputKeys);
        pass.in.push_back(std::move(draft.port));
    });
}

void parse_outputs(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    read_ports(context, node, [&](const JsonMember& member) {
        PortDraft draft =
            read_port(context, member.value, member.key, member.key_loc, "an output", kOutputKeys);
        if (draft.clear) pass.clear_ports.emplace(member.key, *draft.clear);
        pass.out.push_back(std::move(draft.port));
    });
}

// Parses "resolve". For example, {"hdr": "hdrMs"} means: at the end of the pass, the samples of the
// multisampled output "hdrMs" are averaged into the image "hdr".
void parse_resolves(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    if (!expect(context, node, JsonKind::object)) return;
    std::vector<std::string> outputs;
    for (const PortDesc& port : pass.out) outputs.push_back(port.port);
    size_t count = 0;
    for (const JsonMember& member : node.members) {
        if (context.is_full() || !check_port_count(context, ++count, member.key_loc)) break;
        const PointerScope scope(context, member.key);
        Result<RefDesc> ref = parse_reference({member.key, member.key_loc}, context.sources());
        if (!ref) {
            context.add(ref.take_errors());
            continue;
        }
        ResolveDesc resolve;
        resolve.target.port = ref->name;
        if (!context.complete(*ref)) return;
        resolve.target.loc = member.key_loc;
        resolve.target.ref = std::move(*ref);
        resolve.output_loc = member.value.loc;
        if (!read_string(context, member.value, resolve.output)) continue;
        if (pass.depth && resolve.output == "depth") {
            context.error(
                member.value.loc, "W109", "depth can't be resolved",
                "read the depth image in another pass as a sampler2DMS, and write the result from there");
            continue;
        }
        if (std::find(outputs.begin(), outputs.end(), resolve.output) == outputs.end())
            bad_choice(context, member.value, resolve.output, outputs);
        else
            pass.resolves.push_back(std::move(resolve));
    }
}

// Parses the group count of an indirect dispatch, for example {"indirect": "args"}: the buffer "args"
// contains the count.
void parse_indirect(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    PortDraft draft;
    draft.port.port = "indirect";
    draft.port.loc = node.loc;
    if (!read_object(context, node, "the size of a dispatch", kGroupsKeys, draft)) return;
    if (node.members.empty())
        missing_key(context, node.loc, "the size of a dispatch", "indirect",
                    "name the buffer that contains the size: { \"indirect\": \"args\" }");
    pass.indirect = std::move(draft.port);
}

// Parses indirect draws, for example {"list": "opaque", "indirect": "commands", "count": "counts"}: the
// buffer "commands" contains the draw commands, and the buffer "counts" the number of draws. "list" and
// "count" are optional.
void parse_indirect_draws(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    constexpr std::string_view kWhat = "indirect draws";
    DrawsDraft draft;
    for (PortDraft* port : {&draft.commands, &draft.count}) port->port.loc = node.loc;
    draft.commands.port.port = "indirect";
    draft.count.port.port = "count";
    if (!read_object(context, node, kWhat, kDrawsKeys, draft)) return;
    // An unknown key, as in {"list": "opaque", "indirct": "commands"}, was already reported.
    const auto is_optional = [](const JsonMember& member) {
        return member.key == "list" || member.key == "count";
    };
    if (std::ranges::all_of(node.members, is_optional))
        missing_key(context, node.loc, kWhat, "indirect",
                    "name the buffer of draw commands, or write \"draws\": [\"opaque\"]");
    if (!draft.list.empty()) {
        pass.draws.push_back(context.import_name(draft.list, draft.list_loc));
        pass.draw_locs.push_back(draft.list_loc);
    }
    if (draft.commands.has_ref) pass.indirect = std::move(draft.commands.port);
    if (draft.count.has_ref) pass.draw_count = std::move(draft.count.port);
}

// Parses draws without a draw list, for example {"vertices": 36, "instances": "maxLights"}. The shader
// computes the vertices.
void parse_procedural_draws(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    constexpr std::string_view kWhat = "draws without a list";
    if (!read_object(context, node, kWhat, kVerticesKeys, pass)) return;
    const auto is_known = [](const JsonMember& member) { return member.key == "instances"; };
    // Reports that "vertices" is missing if the only key is "instances". Any other key is "vertices" itself,
    // or an unknown key that read_object() has already reported.
    if (std::ranges::all_of(node.members, is_known))
        missing_key(context, node.loc, kWhat, "vertices", "give the number: { \"vertices\": 3 }");
}

void parse_depth(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    PortDraft draft = read_port(context, node, "depth", node.loc, "a depth attachment", kOutputKeys);
    if (draft.clear) pass.clear_ports.emplace("depth", *draft.clear);
    pass.depth = std::move(draft.port);
}

}  // namespace weft
