#include <map>
#include <set>

#include "graph/parse/parse_context.h"

namespace weft {
namespace {

constexpr uint8_t kAllChannels = 0xF;
constexpr std::string_view kChannels = "rgba";

constexpr std::array kFactors{
    Choice<BlendFactor>{"zero", BlendFactor::zero},
    Choice<BlendFactor>{"one", BlendFactor::one},
    Choice<BlendFactor>{"src_color", BlendFactor::src_color},
    Choice<BlendFactor>{"one_minus_src_color", BlendFactor::one_minus_src_color},
    Choice<BlendFactor>{"dst_color", BlendFactor::dst_color},
    Choice<BlendFactor>{"one_minus_dst_color", BlendFactor::one_minus_dst_color},
    Choice<BlendFactor>{"src_alpha", BlendFactor::src_alpha},
    Choice<BlendFactor>{"one_minus_src_alpha", BlendFactor::one_minus_src_alpha},
    Choice<BlendFactor>{"dst_alpha", BlendFactor::dst_alpha},
    Choice<BlendFactor>{"one_minus_dst_alpha", BlendFactor::one_minus_dst_alpha},
};
constexpr std::array kOps{Choice<BlendOp>{"add", BlendOp::add},
                          Choice<BlendOp>{"subtract", BlendOp::subtract},
                          Choice<BlendOp>{"reverse_subtract", BlendOp::reverse_subtract},
                          Choice<BlendOp>{"min", BlendOp::min}, Choice<BlendOp>{"max", BlendOp::max}};

struct Equation {
    BlendFactor src = BlendFactor::one;
    BlendOp op = BlendOp::add;
    BlendFactor dst = BlendFactor::zero;
};

constexpr BlendState blend_state(bool enabled, Equation color, Equation alpha) {
    return {enabled, color.src, color.dst, color.op, alpha.src, alpha.dst, alpha.op, kAllChannels};
}

// The blend equations of the presets below. kOver and kStraightOver are the operator "over" for premultiplied
// and for straight alpha (T. Porter and T. Duff, "Compositing Digital Images", 1984).
constexpr Equation kReplace{BlendFactor::one, BlendOp::add, BlendFactor::zero};
constexpr Equation kAdd{BlendFactor::one, BlendOp::add, BlendFactor::one};
constexpr Equation kOver{BlendFactor::one, BlendOp::add, BlendFactor::one_minus_src_alpha};
constexpr Equation kStraightOver{BlendFactor::src_alpha, BlendOp::add, BlendFactor::one_minus_src_alpha};
constexpr Equation kMultiplyColor{BlendFactor::dst_color, BlendOp::add, BlendFactor::zero};
constexpr Equation kMultiplyAlpha{BlendFactor::dst_alpha, BlendOp::add, BlendFactor::zero};
constexpr std::array kPresets{
    Choice<BlendState>{"none", blend_state(false, kReplace, kReplace)},
    Choice<BlendState>{"add", blend_state(true, kAdd, kAdd)},
    Choice<BlendState>{"alpha", blend_state(true, kStraightOver, kOver)},
    Choice<BlendState>{"premultiplied", blend_state(true, kOver, kOver)},
    Choice<BlendState>{"multiply", blend_state(true, kMultiplyColor, kMultiplyAlpha)},
};

struct BlendDraft {
    std::optional<Equation> color, alpha;
};

void read_equation(ParseContext& context, const JsonNode& node, std::optional<Equation>& out) {
    if (!expect_items(context, node, 3, "three", "write [source factor, operation, destination factor]"))
        return;
    Equation equation;
    read_choice(context, node.items[0], kFactors, equation.src);
    read_choice(context, node.items[1], kOps, equation.op);
    read_choice(context, node.items[2], kFactors, equation.dst);
    out = equation;
}

constexpr std::array kBlendKeys{
    KeyRule<BlendDraft>{"color", read_member<read_equation, &BlendDraft::color>},
    KeyRule<BlendDraft>{"alpha", read_member<read_equation, &BlendDraft::alpha>},
};

// Returns true if an object is one blend for all outputs, such as {"color": ["one", "add", "one"]}: it has an
// array under "color" or "alpha". Any other object, such as {"hdr": "add"}, maps the names of outputs to
// their blends.
bool is_equation(const JsonNode& node) {
    for (const std::string_view key : {"color", "alpha"}) {
        const JsonNode* part = node.find(key);
        if (part != nullptr && part->kind == JsonKind::array) return true;
    }
    return false;
}

void read_blend(ParseContext& context, const JsonNode& node, BlendState& out) {
    if (node.kind == JsonKind::string) {
        read_choice(context, node, kPresets, out);
        return;
    }
    if (node.kind != JsonKind::object) return wrong_type(context, node, "the name of a blend or an object");
    BlendDraft draft;
    read_object(context, node, "a blend", kBlendKeys, draft);
    const Equation color = draft.color.value_or(kReplace);
    out = blend_state(true, color, draft.alpha.value_or(draft.color ? color : kReplace));
}

// Reads the write mask of an output: the letters of the written channels, such as "rgb", or "none". No letter
// may occur twice.
void read_mask(ParseContext& context, const JsonNode& node, uint8_t& out) {
    if (!expect(context, node, JsonKind::string)) return;
    uint8_t mask = 0;
    bool good = !node.string.empty();
    for (const char c : node.string) {
        const size_t channel = kChannels.find(c);
        good = good && channel != std::string_view::npos && (mask & (1u << channel)) == 0;
        if (good) mask = static_cast<uint8_t>(mask | (1u << channel));
    }
    if (node.string == "none")
        out = 0;
    else if (good)
        out = mask;
    else
        context.error(node.loc, "W109", "\"" + node.string + "\" is not a set of channels",
                      "write letters of \"rgba\", for example \"rgb\", or write \"none\"");
}

void check_output(ParseContext& context, const JsonMember& member, const PassDesc& pass) {
    std::vector<std::string> outputs;
    for (const PortDesc& port : pass.out) {
        if (port.port == member.key) return;
        outputs.push_back(port.port);
    }
    Diagnostic& error =
        context.error(member.key_loc, "W101", "the pass has no output \"" + member.key + "\"");
    const std::string near = did_you_mean_text(member.key, outputs);
    error.help.push_back(!near.empty()     ? near
                         : outputs.empty() ? "add this output to \"out\""
                                           : "the outputs of the pass are " + quoted_list(outputs));
}

// Reads a value that is either the same for all outputs of the pass (stored under the empty name) or an
// object with one value per output (stored under the name of the output).
template <class T, class IsMap, class Read>
std::map<std::string, T> read_by_output(ParseContext& context, const JsonNode* node, std::string_view key,
                                        const PassDesc& pass, T initial, IsMap is_map, Read read) {
    std::map<std::string, T> values;
    if (node == nullptr) return values;
    const PointerScope scope(context, key);
    if (!is_map(*node)) {
        read(context, *node, values.emplace("", initial).first->second);
        return values;
    }
    for (const JsonMember& member : node->members) {
        const PointerScope inner(context, member.key);
        check_output(context, member, pass);
        read(context, member.value, values.emplace(member.key, initial).first->second);
    }
    return values;
}

template <class T>
T lookup(const std::map<std::string, T>& values, const std::string& port, T otherwise) {
    if (const auto it = values.find(port); it != values.end()) return it->second;
    if (const auto it = values.find(""); it != values.end()) return it->second;
    return otherwise;
}

}  // namespace

void list_blend_grammar(std::vector<GrammarTable>& lists) {
    list_keys(lists, "blendEquations", kBlendKeys);
    list_choices(lists, "blendName", kPresets);
    list_choices(lists, "blendFactor", kFactors);
    list_choices(lists, "blendOperation", kOps);
}

void parse_blend(ParseContext& context, const JsonNode* blend, const JsonNode* write_mask, PassDesc& pass) {
    const auto maps_blends = [](const JsonNode& node) {
        return node.kind == JsonKind::object && !is_equation(node);
    };
    const auto maps_masks = [](const JsonNode& node) { return node.kind == JsonKind::object; };
    const auto blends = read_by_output(context, blend, "blend", pass, BlendState{}, maps_blends, read_blend);
    const auto masks =
        read_by_output(context, write_mask, "writeMask", pass, kAllChannels, maps_masks, read_mask);
    std::set<std::string> ports;
    for (const auto& entry : blends) ports.insert(entry.first);
    for (const auto& entry : masks) ports.insert(entry.first);
    for (const std::string& port : ports) {
        BlendState state = lookup(blends, port, BlendState{});
        state.write_mask = lookup(masks, port, kAllChannels);
        pass.blend.emplace(port, state);
    }
}

}  // namespace weft
