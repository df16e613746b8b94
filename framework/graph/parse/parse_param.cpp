#include <algorithm>

#include "graph/parse/parse_context.h"

namespace weft {
namespace {

constexpr size_t kMaxComponents = 4;

void read_default(ParseContext& context, const JsonNode& node, ParamDesc& param) {
    if (node.kind != JsonKind::number && node.kind != JsonKind::boolean)
        return wrong_type(context, node, "a number, or true or false");
    param.is_bool = node.kind == JsonKind::boolean;
    param.default_value = param.is_bool ? (node.boolean ? 1 : 0) : node.number;
}

void read_param_range(ParseContext& context, const JsonNode& node, ParamDesc& param) {
    std::array<double, 2> range{};
    if (!read_numbers(context, node, range)) return;
    if (range[0] > range[1])
        return context.error(node.loc, "W109", "the first value of the range is greater than the second",
                             "write [smallest, largest]");
    param.range = range;
}

void read_allowed(ParseContext& context, const JsonNode& node, ParamDesc& param) {
    if (!expect(context, node, JsonKind::array)) return;
    if (node.items.empty())
        context.error(node.loc, "W109", "the list is empty", "list the allowed values of the parameter");
    param.allowed.resize(node.items.size());
    read_numbers(context, node, param.allowed);
}

void read_step(ParseContext& context, const JsonNode& node, ParamDesc& param) {
    if (read_number(context, node, param.step) && param.step <= 0)
        context.error(node.loc, "W109", "a step must be above zero",
                      "remove \"step\" for a continuous parameter");
}

constexpr std::array kParamKeys{
    KeyRule<ParamDesc>{"default", read_default},
    KeyRule<ParamDesc>{"range", read_param_range},
    KeyRule<ParamDesc>{"enum", read_allowed},
    KeyRule<ParamDesc>{"step", read_step},
    KeyRule<ParamDesc>{"unit", read_member<read_string, &ParamDesc::unit>},
    KeyRule<ParamDesc>{"ui", read_member<read_string, &ParamDesc::ui>},
};

void check_default(ParseContext& context, const JsonNode& node, const ParamDesc& param) {
    const JsonNode* value = node.find("default");
    const PointerScope scope(context, "default");
    if (param.is_bool) {
        for (const std::string_view key : {"range", "enum", "step"})
            if (const JsonNode* extra = node.find(key))
                context.error(extra->loc, "W109",
                              "a parameter with true or false cannot have \"" + std::string(key) + "\"",
                              "remove this key, or make \"default\" a number");
        return;
    }
    if (param.range && (param.default_value < (*param.range)[0] || param.default_value > (*param.range)[1]))
        context.error(value->loc, "W109", "the default " + value->string + " is outside \"range\"",
                      "choose a default in this range, or extend the range");
    const bool listed =
        std::find(param.allowed.begin(), param.allowed.end(), param.default_value) != param.allowed.end();
    if (!param.allowed.empty() && !listed)
        context.error(value->loc, "W109", "the default " + value->string + " is not in the list \"enum\"",
                      "choose a default from this list, or add the value to the list");
}

bool read_component(ParseContext& context, const JsonNode& node, ParamValueDesc& param) {
    Expr& component = param.components.emplace_back();
    if (node.kind != JsonKind::boolean) return read_expression(context, node, component);
    JsonNode number = node;
    number.kind = JsonKind::number;
    number.number = node.boolean ? 1 : 0;
    return read_expression(context, number, component);
}

void read_param_value(ParseContext& context, const JsonNode& node, ParamValueDesc& param) {
    if (node.kind != JsonKind::array) {
        read_component(context, node, param);
        return;
    }
    if (node.items.empty() || node.items.size() > kMaxComponents)
        return context.error(node.loc, "W109",
                             "found " + std::to_string(node.items.size()) + " values, wanted 1 to 4",
                             "write 1 to 4 numbers: a vector has at most four components");
    for (size_t i = 0; i < node.items.size(); ++i) {
        const PointerScope scope(context, std::to_string(i));
        read_component(context, node.items[i], param);
    }
}

void read_values(ParseContext& context, const JsonNode& node, std::string_view what,
                 std::vector<ParamValueDesc>& out) {
    read_named(context, node, what, [&](const JsonMember& member) {
        ParamValueDesc param{member.key, {}, member.key_loc};
        read_param_value(context, member.value, param);
        out.push_back(std::move(param));
    });
}

}  // namespace

void list_param_grammar(std::vector<GrammarTable>& lists) {
    list_keys(lists, "parameter", kParamKeys);
}

bool read_switch(ParseContext& context, const JsonNode& node, Expr& out) {
    ParamValueDesc value;
    if (!read_component(context, node, value)) return false;
    out = std::move(value.components.front());
    return true;
}

void parse_params(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    read_parts(context, node, "a parameter", [&](const JsonMember& member) {
        if (!check_value_count(context, graph, member.key_loc)) return;
        ParamDesc param;
        param.name = member.key;
        param.loc = member.key_loc;
        if (!read_object(context, member.value, "a parameter", kParamKeys, param)) return;
        const JsonNode* value = member.value.find("default");
        if (value == nullptr)
            missing_key(context, member.key_loc, "a parameter", "default",
                        "write \"default\": 0, or true or false");
        else if (value->kind == JsonKind::number || value->kind == JsonKind::boolean)
            check_default(context, member.value, param);
        graph.params.emplace(member.key, std::move(param));
    });
}

void parse_pass_params(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    read_values(context, node, "a parameter", pass.params);
}

void parse_constants(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    read_values(context, node, "a specialisation constant", pass.constants);
    for (const ParamValueDesc& constant : pass.constants) {
        if (constant.components.size() == 1) continue;
        const PointerScope scope(context, constant.name);
        context.error(constant.loc, "W109", "a specialisation constant must be one value, not a list",
                      "write a number, an expression, true or false");
    }
}

}  // namespace weft
