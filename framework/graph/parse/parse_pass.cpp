#include <algorithm>

#include "graph/parse/expression.h"
#include "graph/parse/parse_context.h"

namespace weft {
namespace {

// A set of pass types, one bit per type. For example, each row of kPassKeys has the set of the pass types
// that accept the key.
using TypeMask = uint32_t;
enum TypeBit : TypeMask {
    kCompute = 1 << 0,
    kFullscreen = 1 << 1,
    kRaster = 1 << 2,
    kClear = 1 << 3,
    kCopy = 1 << 4,
    kReadback = 1 << 5,
    // All pass types that a program implements in C++ share this bit, because the parser does not know their
    // names.
    kCustom = 1 << 6,
    kBlit = 1 << 7,
};
constexpr TypeMask kTransfer = kCopy | kBlit;
constexpr TypeMask kAll = 255;
constexpr TypeMask kDrawing = kFullscreen | kRaster;
constexpr TypeMask kShaded = kCompute | kDrawing;

constexpr std::array kBuiltinTypes{
    Choice<TypeMask>{"compute", kCompute},   Choice<TypeMask>{"fullscreen", kFullscreen},
    Choice<TypeMask>{"raster", kRaster},     Choice<TypeMask>{"clear", kClear},
    Choice<TypeMask>{"copy", kCopy},         Choice<TypeMask>{"blit", kBlit},
    Choice<TypeMask>{"readback", kReadback},
};
constexpr std::array kQueues{Choice<QueueKind>{"graphics", QueueKind::graphics},
                             Choice<QueueKind>{"async", QueueKind::compute},
                             Choice<QueueKind>{"transfer", QueueKind::transfer}};

void read_queue(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    read_choice(context, node, kQueues, pass.queue);
}

void read_draws(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    const auto is_of_a_count = [](const JsonMember& member) {
        const std::vector<std::string> counts{"vertices", "instances"};
        return std::ranges::find(counts, member.key) != counts.end() ||
               !did_you_mean(member.key, counts).empty();
    };
    if (node.kind == JsonKind::object && std::ranges::any_of(node.members, is_of_a_count))
        return parse_procedural_draws(context, node, pass);
    if (node.kind == JsonKind::object) return parse_indirect_draws(context, node, pass);
    read_names(context, node, pass.draws, pass.draw_locs);
    for (std::string& name : pass.draws) name = context.import_name(name, node.loc);
}

// Reads one to three counts, for x, y and z. The JSON value is an array of expressions or a single
// expression. If a single expression has a size as its value, the size sets both x and y.
void read_counts(ParseContext& context, const JsonNode& node, std::vector<Expr>& out) {
    if (node.kind != JsonKind::array) {
        read_expression(context, node, out.emplace_back());
        return;
    }
    if (node.items.empty() || node.items.size() > 3)
        return context.error(node.loc, "W109",
                             "found " + std::to_string(node.items.size()) + " values, wanted 1 to 3",
                             "write [x, y, z]");
    for (size_t i = 0; i < node.items.size(); ++i) {
        const PointerScope scope(context, std::to_string(i));
        read_expression(context, node.items[i], out.emplace_back());
    }
}

void read_groups(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    if (node.kind == JsonKind::object) return parse_indirect(context, node, pass);
    read_counts(context, node, pass.groups);
}

// Reads the parameter that turns the pass on and off. With "name", the pass runs while the parameter is not
// 0. With "!name", the pass runs while the parameter is 0.
void read_live_switch(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    pass.switch_loc = node.loc;
    std::string text;
    if (!read_string(context, node, text)) return;
    pass.switch_inverted = text.starts_with('!');
    if (pass.switch_inverted) text.erase(0, 1);
    if (check_part_name(context, "a parameter", text, node.loc))
        pass.switch_param = context.param_name(text, node.loc);
}

void read_after(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    read_names(context, node, pass.after, pass.after_locs);
    for (size_t i = 0; i < pass.after.size(); ++i)
        pass.after[i] = context.pass_name(pass.after[i], pass.after_locs[i]);
}

constexpr std::array kCostKeys{KeyRule<PassDesc>{"flops", read_member<read_expression, &PassDesc::flops>}};

void read_cost(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    read_object(context, node, "a cost", kCostKeys, pass);
}

struct PassKey {
    std::string_view key;
    TypeMask types;
    void (*read)(ParseContext&, const JsonNode&, PassDesc&);
};
// The keys of a pass and the pass types that accept them. The keys are read in the order of this table, not
// of the file. For example, "out" comes before "state", because the state refers to outputs.
constexpr std::array kPassKeys{
    PassKey{"type", kAll, read_member<read_string, &PassDesc::type>},
    PassKey{"queue", kAll, read_queue},
    PassKey{"shader", kShaded, read_located<read_string, &PassDesc::shader, &PassDesc::shader_loc>},
    PassKey{"in", kShaded | kTransfer | kReadback | kCustom, parse_inputs},
    PassKey{"out", kAll & ~kReadback, parse_outputs},
    PassKey{"depth", kDrawing, parse_depth},
    PassKey{"resolve", kDrawing, parse_resolves},
    PassKey{"draws", kRaster, read_draws},
    PassKey{"view", kShaded, parse_view},
    PassKey{"frustum", kRaster, read_member<read_bool, &PassDesc::frustum>},
    PassKey{"params", kShaded | kCustom, parse_pass_params},
    PassKey{"constants", kShaded, parse_constants},
    PassKey{"if", kAll, read_member<read_switch, &PassDesc::condition>},
    PassKey{"repeat", kAll, parse_repeat},
    PassKey{"views", kDrawing, parse_pass_views},
    PassKey{"into", kDrawing, parse_into},
    PassKey{"lowering", kDrawing, parse_lowering},
    PassKey{"perFrame", kAll & ~kReadback,
            read_located<read_switch, &PassDesc::per_frame, &PassDesc::per_frame_loc>},
    PassKey{"rest", kShaded | kTransfer | kClear,
            read_located<read_bool, &PassDesc::rests, &PassDesc::rest_loc>},
    PassKey{"switch", kAll & ~kReadback, read_live_switch},
    PassKey{"groups", kCompute, read_groups},
    PassKey{"threads", kCompute, read_member<read_counts, &PassDesc::threads>},
    PassKey{"state", kDrawing, parse_state},
    PassKey{"clear", kDrawing | kClear, read_member<read_color, &PassDesc::clear>},
    PassKey{"covers", kDrawing, read_member<read_bool, &PassDesc::covers>},
    PassKey{"partial", kShaded | kTransfer | kCustom, read_member<read_bool, &PassDesc::partial>},
    PassKey{"after", kAll, read_after},
    PassKey{"cost", kShaded | kCustom, read_cost},
};

struct RequiredKey {
    std::string_view key;
    TypeMask types;
    const char* help;
};
constexpr std::array kRequiredKeys{
    RequiredKey{"shader", kShaded, "name the shader, for example \"shader\": \"light.comp\""},
    RequiredKey{"draws", kRaster, "list the draw lists, for example \"draws\": [\"opaque\"]"},
    RequiredKey{"in", kTransfer | kReadback, "list the inputs, for example \"in\": [\"hdr\"]"},
    RequiredKey{"out", kClear | kTransfer, "list the outputs, for example \"out\": [\"hdr\"]"},
};

std::string types_text(TypeMask types) {
    std::vector<std::string> names;
    for (const Choice<TypeMask>& type : kBuiltinTypes)
        if ((types & type.value) != 0) names.emplace_back(type.name);
    return quoted_list(names);
}

std::string article(const std::string& type) {
    return "a \"" + type + "\" pass";
}

const PassKey* find_key(std::string_view key) {
    const auto it =
        std::find_if(kPassKeys.begin(), kPassKeys.end(), [&](const PassKey& k) { return k.key == key; });
    return it == kPassKeys.end() ? nullptr : it;
}

// Reports that a pass has no type. A common cause is a misspelt pass name in a tier or an including file,
// which creates a new pass; so the help suggests similar names.
void missing_type(ParseContext& context, const JsonMember& member, const JsonNode& passes) {
    std::vector<std::string> others;
    for (const JsonMember& other : passes.members)
        if (other.value.find("type") != nullptr) others.push_back(other.key);
    std::string near = did_you_mean_text(member.key, others);
    missing_key(context, member.key_loc, "a pass", "type",
                near.empty() ? "built-in types are " + types_text(kAll) + "; programs can add types in C++"
                             : std::move(near));
}

// Returns the bit of the pass's type. If the type is absent or is reported as wrong, returns kAll, so that no
// key of the pass is reported as misplaced.
TypeMask type_mask(ParseContext& context, const JsonMember& member, const JsonNode& passes) {
    const JsonNode* type = member.value.find("type");
    if (type == nullptr) {
        missing_type(context, member, passes);
        return kAll;
    }
    if (type->kind != JsonKind::string || type->string.empty()) return kAll;
    TypeMask mask = kCustom;
    if (find_choice(std::span<const Choice<TypeMask>>(kBuiltinTypes), type->string, mask)) return mask;
    // The type is not built in. It may be a C++ type, and resolve() checks later that this type exists. But a
    // C++ type does not accept keys such as "shader" or "draws". If the pass has such a key, its type is
    // probably a misspelt built-in type, so it is reported as unknown.
    for (const JsonMember& entry : member.value.members) {
        const PassKey* key = find_key(entry.key);
        if (key == nullptr || (key->types & kCustom) != 0) continue;
        const PointerScope scope(context, "type");
        Diagnostic& error = context.error(type->loc, "W115",
                                          "unknown pass type \"" + type->string +
                                              "\"; only built-in types have the key \"" + entry.key + "\"");
        const std::string near =
            did_you_mean_text(type->string, choice_names(std::span<const Choice<TypeMask>>(kBuiltinTypes)));
        error.help.push_back(near.empty() ? "built-in types are " + types_text(kAll) : near);
        return kAll;
    }
    return kCustom;
}

std::vector<std::string> keys_of(TypeMask types) {
    std::vector<std::string> keys;
    for (const PassKey& key : kPassKeys)
        if ((key.types & types) != 0) keys.emplace_back(key.key);
    return keys;
}

void check_keys(ParseContext& context, const JsonNode& node, TypeMask mask, const std::string& type) {
    for (const JsonMember& member : node.members) {
        if (context.is_full()) break;
        const PointerScope scope(context, member.key);
        const PassKey* key = find_key(member.key);
        if (key == nullptr)
            unknown_key(context, member, mask == kAll ? "a pass" : article(type), keys_of(mask));
        else if ((key->types & mask) == 0)
            context.error(
                member.key_loc, "W101", article(type) + " does not use the key \"" + member.key + "\"",
                "remove it: \"" + member.key + "\" belongs to passes of type " + types_text(key->types));
    }
}

// Returns true if the pass contains a misspelling of `key`. The misspelt key has already been reported as
// unknown, so the correct key is not reported as missing.
bool is_misspelt(const JsonNode& pass, std::string_view key) {
    return std::any_of(pass.members.begin(), pass.members.end(), [&](const JsonMember& member) {
        return find_key(member.key) == nullptr && !did_you_mean(member.key, {std::string(key)}).empty();
    });
}

void check_required(ParseContext& context, const JsonMember& member, TypeMask mask) {
    for (const RequiredKey& required : kRequiredKeys)
        if ((required.types & mask) == mask && member.value.find(required.key) == nullptr &&
            !is_misspelt(member.value, required.key))
            missing_key(context, member.key_loc, article(member.value.find("type")->string), required.key,
                        required.help);
}

void check_dispatch(ParseContext& context, const JsonNode& node) {
    const JsonNode* threads = node.find("threads");
    if (threads == nullptr || node.find("groups") == nullptr) return;
    const PointerScope scope(context, "threads");
    context.error(threads->loc, "W109", "a pass cannot have both \"groups\" and \"threads\"",
                  "remove one of the two");
}

// If a raster pass has a depth attachment but names no depth test, sets the default test for reversed Z:
// "greater" with depth writes. A fullscreen pass has no default, so its missing test is an error. Also
// reports a depth test without a depth attachment.
void complete_depth(ParseContext& context, const JsonMember& member, PassDesc& pass) {
    const JsonNode* state = member.value.find("state");
    const JsonNode* depth = state == nullptr ? nullptr : state->find("depth");
    if (!pass.depth && depth != nullptr && pass.state.depth_test) {
        const PointerScope scope(context, "state");
        const PointerScope key(context, "depth");
        context.error(depth->loc, "W109", "the pass tests depth, but has no depth attachment",
                      "add the key \"depth\" with the name of a depth image to the pass");
    }
    if (!pass.depth || depth != nullptr) return;
    if (pass.type == "fullscreen")
        return missing_key(context, member.key_loc,
                           "the \"state\" of a fullscreen pass with a depth attachment", "depth",
                           "choose a depth test, for example \"state\": { \"depth\": \"equal\" }");
    pass.state.depth_test = true;
    pass.state.depth_write = true;
    pass.state.depth_compare = CompareOp::greater;
}

void check_procedural(ParseContext& context, const JsonNode& node, const PassDesc& pass) {
    if (!pass.draws_without_list() || pass.state.cull != CullMode::material) return;
    const JsonNode* cull = node.find("state")->find("cull");
    const PointerScope scope(context, "state"), key(context, "cull");
    context.error(cull->loc, "W109", "the pass draws no draw list, so no material can determine culling",
                  "write \"none\", \"front\" or \"back\"");
}

void check_port_names(ParseContext& context, const PassDesc& pass) {
    for (const PortDesc& port : pass.in)
        if ((pass.indirect && port.port == "indirect") || (pass.draw_count && port.port == "count"))
            context.error(port.loc, "W109",
                          "the port name \"" + port.port + "\" is reserved for the indirect commands",
                          "give the input another name: { \"name\": \"" + port.ref.text + "\" }");
    for (const PortDesc& port : pass.out)
        if (pass.depth && port.port == "depth")
            context.error(port.loc, "W109", "the pass has a depth attachment and an output called \"depth\"",
                          "give the output another name: { \"name\": \"" + port.ref.text + "\" }");
}

void read_pass(ParseContext& context, const JsonMember& member, const JsonNode& passes, PassDesc& pass) {
    const TypeMask mask = type_mask(context, member, passes);
    const JsonNode* type = member.value.find("type");
    check_keys(context, member.value, mask, type == nullptr ? "" : type->string);
    if (mask != kAll) check_required(context, member, mask);
    for (const PassKey& key : kPassKeys) {
        const JsonNode* value = member.value.find(key.key);
        if (value == nullptr || (key.types & mask) == 0) continue;
        const PointerScope scope(context, key.key);
        key.read(context, *value, pass);
    }
    check_dispatch(context, member.value);
    check_procedural(context, member.value, pass);
    check_port_names(context, pass);
    check_pass_views(context, member.value, pass);
    if ((mask & kDrawing) == mask) complete_depth(context, member, pass);
}

}  // namespace

void list_pass_grammar(std::vector<GrammarTable>& lists) {
    lists.push_back({"anyPass", true, keys_of(kAll)});
    lists.push_back({"customPass", true, keys_of(kCustom), {"type"}, "anyPass"});
    for (const Choice<TypeMask>& type : kBuiltinTypes) {
        GrammarTable& list = lists.emplace_back(
            GrammarTable{std::string(type.name) + "Pass", true, keys_of(type.value), {"type"}, "anyPass"});
        for (const RequiredKey& key : kRequiredKeys)
            if ((key.types & type.value) != 0) list.required.emplace_back(key.key);
    }
    list_choices(lists, "builtinType", kBuiltinTypes);
    list_choices(lists, "queue", kQueues);
    list_keys(lists, "cost", kCostKeys);
}

void parse_passes(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    read_parts(context, node, "a pass", [&](const JsonMember& member) {
        if (!expect(context, member.value, JsonKind::object)) return;
        PassDesc& pass = graph.passes[context.declared_name(member.key)];
        pass.name = context.declared_name(member.key);
        pass.loc = member.key_loc;
        if (const ModuleNames* modules = context.modules()) pass.module = modules->module_of(pass.name);
        if (const GroupDesc* group = context.group()) {
            pass.group = group->name;
            pass.repeat = group->repeat;
        }
        context.set_indices(indices_of(member.value, pass.repeat));
        read_pass(context, member, node, pass);
        context.set_indices({});
    });
}

}  // namespace weft
