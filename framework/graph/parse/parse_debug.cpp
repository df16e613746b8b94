// Parses the section "debug" with its debug views, such as "Normals": { "show": "normal", "decode":
// "octahedral" }.
#include <algorithm>

#include "graph/parse/debug_view.h"
#include "graph/parse/parse_context.h"

namespace weft {
namespace {

void read_show(ParseContext& context, const JsonNode& node, DebugViewDesc& view) {
    read_reference(context, node, view.show);
}

void read_decode(ParseContext& context, const JsonNode& node, DebugViewDesc& view) {
    if (!read_string(context, node, view.decode)) return;
    const std::vector<std::string> known = debug_decoders();
    if (std::ranges::find(known, view.decode) == known.end()) bad_choice(context, node, view.decode, known);
}

void read_view_shader(ParseContext& context, const JsonNode& node, DebugViewDesc& view) {
    read_string(context, node, view.shader);
    if (!view.decode.empty())
        context.error(node.loc, "W109", "a debug view cannot have both \"decode\" and \"shader\"",
                      "remove one of the two");
}

void read_view_range(ParseContext& context, const JsonNode& node, DebugViewDesc& view) {
    if (!expect_items(context, node, 2, "two", "write [value shown as black, value shown as white]")) return;
    std::array<Expr, 2> range;
    bool good = true;
    for (size_t i = 0; i < range.size(); ++i) {
        const PointerScope scope(context, std::to_string(i));
        good = read_expression(context, node.items[i], range[i]) && good;
    }
    if (good) view.range = std::move(range);
}

constexpr std::array kViewKeys{
    KeyRule<DebugViewDesc>{"show", read_show}, KeyRule<DebugViewDesc>{"decode", read_decode},
    KeyRule<DebugViewDesc>{"shader", read_view_shader}, KeyRule<DebugViewDesc>{"range", read_view_range}};

}  // namespace

void list_debug_grammar(std::vector<GrammarTable>& lists) {
    list_keys(lists, "debugView", kViewKeys);
}

void parse_debug(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    if (!expect(context, node, JsonKind::object)) return;
    for (const JsonMember& member : node.members) {
        if (context.is_full()) return;
        if (!context.within(graph.debug.size() + 1, context.limits().debug_views, member.key_loc,
                            "debug views", "graph.debugViews", "remove some debug views"))
            return;
        const PointerScope scope(context, member.key);
        DebugViewDesc view;
        view.name = member.key;
        view.loc = member.key_loc;
        if (!read_object(context, member.value, "a debug view", kViewKeys, view)) continue;
        if (member.value.find("show") == nullptr)
            missing_key(context, member.key_loc, "a debug view", "show",
                        "name the resource to show, for example \"show\": \"hdr\"");
        graph.debug.emplace(member.key, std::move(view));
    }
}

}  // namespace weft
