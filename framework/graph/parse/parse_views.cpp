// Parses the section "views", and the keys of a pass that choose its views: "view", "views", "into" and
// "lowering". A pass with "views" is parsed as a repeat: its last index, kViewIndex, counts the views of the
// list.
#include <algorithm>

#include "graph/parse/expression.h"
#include "graph/parse/parse_context.h"

namespace weft {
namespace {

void read_of(ParseContext& context, const JsonNode& node, ViewListDesc& list) {
    list.of_loc = node.loc;
    if (read_string(context, node, list.of)) list.of = context.view_name(list.of, node.loc);
}

// Reads the buffer that contains the views of a list. Each pass that draws a view of the list reads the
// element of this view. So the key must name the whole buffer.
void read_view_buffer(ParseContext& context, const JsonNode& node, ViewListDesc& list) {
    PortDesc port;
    port.port = std::string(kViewPort) + list.name;
    port.loc = node.loc;
    if (!read_reference(context, node, port.ref)) return;
    const RefDesc& ref = port.ref;
    if (ref.element_first || ref.mip_first || ref.layer_first || ref.aspects != aspect::kNone)
        return context.error(node.loc, "W230", "a list of views needs a whole buffer, without a range",
                             "write only the name, \"buffer\": \"" + ref.name +
                                 "\"; a second list with \"of\" and \"first\" can show a part of the views");
    list.buffer = std::move(port);
}

// Reads an array of exactly N expressions.
template <size_t N>
void read_expressions(ParseContext& context, const JsonNode& node, const char* form,
                      std::optional<std::array<Expr, N>>& out) {
    if (!expect_items(context, node, N, std::to_string(N), std::string("write ") + form)) return;
    out.emplace();
    for (size_t i = 0; i < N; ++i) {
        const PointerScope scope(context, std::to_string(i));
        read_expression(context, node.items[i], (*out)[i]);
    }
}

constexpr std::array kCubeKeys{
    KeyRule<ViewListDesc>{"at",
                          [](ParseContext& c, const JsonNode& n, ViewListDesc& list) {
                              read_expressions(c, n, "[x, y, z], the centre of the cube in metres", list.at);
                          }},
    KeyRule<ViewListDesc>{"near", read_member<read_expression, &ViewListDesc::near_m>}};

void read_view_cube(ParseContext& context, const JsonNode& node, ViewListDesc& list) {
    if (!read_object(context, node, "a cube of views", kCubeKeys, list)) return;
    if (node.find("at") == nullptr)
        missing_key(context, node.loc, "a cube of views", "at", "write the centre: \"at\": [x, y, z]");
}

constexpr std::array kViewListKeys{
    KeyRule<ViewListDesc>{"of", read_of},
    KeyRule<ViewListDesc>{"first", read_member<read_expression, &ViewListDesc::first>},
    KeyRule<ViewListDesc>{"count", read_member<read_expression, &ViewListDesc::count>},
    KeyRule<ViewListDesc>{"plane",
                          [](ParseContext& c, const JsonNode& n, ViewListDesc& list) {
                              read_expressions(c, n, "[a, b, c, d] for the plane a x + b y + c z + d = 0",
                                               list.plane);
                          }},
    KeyRule<ViewListDesc>{"cube", read_view_cube},
    KeyRule<ViewListDesc>{"buffer", read_view_buffer},
    KeyRule<ViewListDesc>{"rect", [](ParseContext& c, const JsonNode& n, ViewListDesc& list) {
                              read_expressions(c, n, "[x, y, width, height] in pixels", list.rect);
                          }}};

// Reports each of `keys` that the list has, because a list with `key` must not have these keys.
void refuse_keys(ParseContext& context, const JsonNode& list, const char* key,
                 std::initializer_list<const char*> keys, const char* help) {
    for (const char* other : keys) {
        if (list.find(other) == nullptr) continue;
        const PointerScope scope(context, other);
        context.error(list.find(other)->loc, "W109",
                      std::string("the list has both \"") + key + "\" and \"" + other + "\"", help);
    }
}

// Checks that a list has one of the keys "of", "cube" and "buffer", and no key that belongs to another of
// them.
void check_list_kind(ParseContext& context, const JsonMember& member) {
    const JsonNode& list = member.value;
    if (list.find("cube") != nullptr)
        return refuse_keys(context, list, "cube", {"of", "first", "count", "plane", "buffer"},
                           "remove one of the two; a second list can show the faces of the cube in a mirror");
    if (list.find("buffer") != nullptr) {
        if (list.find("count") == nullptr)
            missing_key(context, member.key_loc, "a list of views in a buffer", "count",
                        "write the number of views, which is at most the number of elements of the buffer");
        return refuse_keys(context, list, "buffer", {"of", "first", "plane"},
                           "remove one of the two; a second list with \"of\" can show a part of the views");
    }
    if (list.find("of") == nullptr)
        missing_key(context, member.key_loc, "a list of views", "of",
                    "name a list or the camera, \"of\": \"camera\"; or write "
                    "\"cube\": { \"at\": [x, y, z] }");
}

constexpr std::array kTargets{Choice<ViewTarget>{"layers", ViewTarget::layers},
                              Choice<ViewTarget>{"rects", ViewTarget::rects}};

constexpr std::array kLowerings{Choice<LoweringDesc>{"multiview", LoweringDesc::multiview},
                                Choice<LoweringDesc>{"layerOutput", LoweringDesc::layer_output},
                                Choice<LoweringDesc>{"passes", LoweringDesc::passes}};

// Checks that the pass draws several views, so that `key` has a meaning.
bool expect_views(ParseContext& context, const JsonNode& node, const PassDesc& pass, const std::string& key) {
    if (pass.view_target != ViewTarget::one) return true;
    context.error(node.loc, "W109", "the pass draws only one view, but has \"" + key + "\"",
                  "remove \"" + key + "\", or draw all views of a list with \"views\"");
    return false;
}

}  // namespace

void list_view_grammar(std::vector<GrammarTable>& lists) {
    list_keys(lists, "viewList", kViewListKeys);
    list_keys(lists, "viewCube", kCubeKeys);
    list_choices(lists, "viewTarget", kTargets);
    list_choices(lists, "lowering", kLowerings);
}

void parse_views(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    read_parts(context, node, "a list of views", [&](const JsonMember& member) {
        ViewListDesc list;
        list.name = member.key;
        list.loc = member.key_loc;
        if (!read_object(context, member.value, "a list of views", kViewListKeys, list)) return;
        check_list_kind(context, member);
        graph.views.emplace(member.key, std::move(list));
    });
}

// Reads the view that a pass is drawn from: "camera", or a name with a number in parentheses, such as
// "sun(i)".
void parse_view(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    pass.view_loc = node.loc;
    if (!read_string(context, node, pass.view)) return;
    const size_t open = pass.view.find('(');
    const std::string name = context.view_name(pass.view.substr(0, open), node.loc);
    if (open == std::string::npos) {
        pass.view = name;
        return;
    }
    const LocatedText text{node.string, node.loc};
    size_t end = open + 1;
    Result<Expr> number = parse_expression_at(text, end, context.sources());
    if (!number) return context.add(number.take_errors());
    if (!context.complete(*number)) return;
    if (text.text.substr(end) != ")")
        return context.error(text.at(end, 1), "W106", "the number of a view needs ')' as its last character",
                             "write the view as \"" + pass.view.substr(0, open) + "(i)\"");
    pass.view = name;
    pass.view_number = std::move(*number);
}

void parse_pass_views(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    if (!read_string(context, node, pass.view)) return;
    pass.view = context.view_name(pass.view, node.loc);
    if (!context.within(pass.repeat.size() + 1, context.limits().repeat_indices, node.loc,
                        "indices in a repeat", "graph.repeatIndices", "combine several indices into one"))
        return;
    if (std::ranges::find(pass.repeat, kViewIndex, &RepeatDesc::index) != pass.repeat.end())
        return context.error(node.loc, "W109",
                             "the pass has \"views\", whose index is \"view\", and a repeat with this index",
                             "choose another name for the index of the repeat");
    pass.view_loc = node.loc;
    pass.view_target = ViewTarget::layers;
    pass.view_number = name_expression(kViewIndex, node.loc);
    RepeatDesc& repeat = pass.repeat.emplace_back();
    repeat.index = kViewIndex;
    repeat.first = number_expression(0, node.loc);
    // The parser does not know the number of views, because for some lists the program gives this number. So
    // it stores 0 as the last index here, and resolve() sets the right value.
    repeat.last = number_expression(0, node.loc);
    repeat.loc = repeat.range_loc = node.loc;
}

void parse_into(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    ViewTarget target = ViewTarget::one;
    if (!read_choice(context, node, kTargets, target) || !expect_views(context, node, pass, "into")) return;
    pass.view_target = target;
    if (target == ViewTarget::rects) pass.partial = true;
}

void parse_lowering(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    LoweringDesc lowering = LoweringDesc::automatic;
    if (!read_choice(context, node, kLowerings, lowering) || !expect_views(context, node, pass, "lowering"))
        return;
    pass.lowering = lowering;
    pass.lowering_loc = node.loc;
}

void check_pass_views(ParseContext& context, const JsonNode& node, const PassDesc& pass) {
    if (pass.view_target == ViewTarget::one) return;
    const auto refuse = [&](const JsonNode& value, std::string_view key, const char* code,
                            const std::string& reason, const char* help) {
        const PointerScope scope(context, key);
        context.error(value.loc, code,
                      "a pass with \"views\" cannot have \"" + std::string(key) + "\"" + reason, help);
    };
    if (const JsonNode* view = node.find("view"))
        refuse(*view, "view", "W109", "", "remove one of the two: \"view\" is for passes that draw one view");
    if (pass.view_target != ViewTarget::rects) return;
    if (pass.lowering == LoweringDesc::multiview || pass.lowering == LoweringDesc::layer_output) {
        const PointerScope scope(context, "lowering");
        context.error(pass.lowering_loc, "W199",
                      "a pass with \"into\": \"rects\" draws each view by a pass of its own, but its "
                      "\"lowering\" is another one",
                      "remove \"lowering\", or use \"into\": \"layers\"");
    }
    const char* const rects = ", because each view has its own rectangle";
    const JsonNode* state = node.find("state");
    for (const char* key : {"viewport", "scissor"})
        if (const JsonNode* rect = state == nullptr ? nullptr : state->find(key)) {
            const PointerScope scope(context, "state");
            refuse(*rect, key, "W192", rects, "remove it, or use \"into\": \"layers\"");
        }
    const bool clears = pass.clear || !pass.clear_ports.empty();
    if (const JsonNode* slices = clears ? node.find("perFrame") : nullptr)
        refuse(
            *slices, "perFrame", "W192", ", \"clear\" and \"into\": \"rects\"",
            "remove \"clear\", because it clears the rectangles of all views; or use \"into\": \"layers\"");
    if (const JsonNode* covers = node.find("covers"))
        refuse(*covers, "covers", "W192", ", because each view writes only its own rectangle", "remove it");
}

}  // namespace weft
