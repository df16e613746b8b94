#include "graph/parse/parse_context.h"

namespace weft {
namespace {

constexpr int64_t kMaxRectPx = 1 << 20;

constexpr std::array kCulls{
    Choice<CullMode>{"none", CullMode::none}, Choice<CullMode>{"front", CullMode::front},
    Choice<CullMode>{"back", CullMode::back}, Choice<CullMode>{"material", CullMode::material}};
constexpr std::array kFrontFaces{Choice<FrontFace>{"ccw", FrontFace::counter_clockwise},
                                 Choice<FrontFace>{"cw", FrontFace::clockwise}};
constexpr std::array kFills{Choice<FillMode>{"fill", FillMode::fill},
                            Choice<FillMode>{"line", FillMode::line},
                            Choice<FillMode>{"point", FillMode::point}};
constexpr std::array kTopologies{
    Choice<Topology>{"triangles", Topology::triangles},
    Choice<Topology>{"triangle_strip", Topology::triangle_strip}, Choice<Topology>{"lines", Topology::lines},
    Choice<Topology>{"line_strip", Topology::line_strip}, Choice<Topology>{"points", Topology::points}};
constexpr std::array kDepthCompares{
    Choice<CompareOp>{"never", CompareOp::never},
    Choice<CompareOp>{"less", CompareOp::less},
    Choice<CompareOp>{"equal", CompareOp::equal},
    Choice<CompareOp>{"less_equal", CompareOp::less_equal},
    Choice<CompareOp>{"greater", CompareOp::greater},
    Choice<CompareOp>{"not_equal", CompareOp::not_equal},
    Choice<CompareOp>{"greater_equal", CompareOp::greater_equal},
    Choice<CompareOp>{"always", CompareOp::always},
};
constexpr std::array kStencilOps{
    Choice<StencilOp>{"keep", StencilOp::keep},
    Choice<StencilOp>{"zero", StencilOp::zero},
    Choice<StencilOp>{"replace", StencilOp::replace},
    Choice<StencilOp>{"increment_clamp", StencilOp::increment_clamp},
    Choice<StencilOp>{"decrement_clamp", StencilOp::decrement_clamp},
    Choice<StencilOp>{"invert", StencilOp::invert},
    Choice<StencilOp>{"increment_wrap", StencilOp::increment_wrap},
    Choice<StencilOp>{"decrement_wrap", StencilOp::decrement_wrap},
};

constexpr std::string_view kWrite = "_write";

std::vector<std::string> depth_choices() {
    std::vector<std::string> choices{"none"};
    for (const Choice<CompareOp>& compare : kDepthCompares) {
        choices.emplace_back(compare.name);
        choices.push_back(std::string(compare.name) + std::string(kWrite));
    }
    return choices;
}

// Reads the depth test: "none", a comparison such as "greater" (test without writing depth), or the same with
// writing, such as "greater_write".
void read_depth(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    RasterState& state = pass.state;
    if (!expect(context, node, JsonKind::string)) return;
    std::string_view name = node.string;
    if (name == "none") return;
    const bool write = name.ends_with(kWrite);
    if (write) name.remove_suffix(kWrite.size());
    if (find_choice(std::span<const Choice<CompareOp>>(kDepthCompares), name, state.depth_compare)) {
        state.depth_test = true;
        state.depth_write = write;
        return;
    }
    bad_choice(context, node, node.string, depth_choices());
}

// The allowed range of a number in the state of a pass. A literal number is checked when it is parsed. The
// result of an expression is checked in resolve().
struct NumberRule {
    double least, most;
    bool whole;
};
constexpr NumberRule kByte{0, 255, true};
constexpr NumberRule kPlace{-kMaxRectPx, kMaxRectPx, true};
constexpr NumberRule kInsidePlace{0, kMaxRectPx, true};
constexpr NumberRule kSide{1, kMaxRectPx, true};
constexpr NumberRule kFloat{-3.4e38, 3.4e38, false};

void read_state_number(ParseContext& context, const JsonNode& node, const NumberRule& rule, PassDesc& pass,
                       StateSetter set, std::optional<RectSideDesc> rect = {}) {
    if (node.kind == JsonKind::number) {
        int64_t whole = 0;
        float number = 0;
        if (rule.whole ? read_integer(context, node, static_cast<int64_t>(rule.least),
                                      static_cast<int64_t>(rule.most), whole)
                       : read_float(context, node, number))
            set(pass.state, node.number);
        return;
    }
    StateNumberDesc late{{}, rule.least, rule.most, rule.whole, set, rect};
    if (read_expression(context, node, late.value)) pass.state_numbers.push_back(std::move(late));
}

template <float RasterState::*Member>
void read_bias_number(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    read_state_number(context, node, kFloat, pass,
                      [](RasterState& s, double v) { s.*Member = static_cast<float>(v); });
}

constexpr std::array kBiasKeys{
    KeyRule<PassDesc>{"constant", read_bias_number<&RasterState::depth_bias_constant>},
    KeyRule<PassDesc>{"slope", read_bias_number<&RasterState::depth_bias_slope>},
    KeyRule<PassDesc>{"clamp", [](ParseContext& c, const JsonNode& n, PassDesc& p) {
                          p.state_locs.depth_bias_clamp = n.loc;
                          read_bias_number<&RasterState::depth_bias_clamp>(c, n, p);
                      }}};

void read_bias(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    read_object(context, node, "a depth bias", kBiasKeys, pass);
}

// The pass that is being parsed, and the triangle faces (front, back or both) that the stencil state applies
// to.
struct FaceDraft {
    PassDesc& pass;
    std::vector<StencilFaceState RasterState::*> faces;
};

template <auto Member, const auto& Choices>
void read_face_choice(ParseContext& context, const JsonNode& node, FaceDraft& draft) {
    std::remove_reference_t<decltype(std::declval<StencilFaceState>().*Member)> value{};
    if (!read_choice(context, node, Choices, value)) return;
    for (const auto face : draft.faces) (draft.pass.state.*face).*Member = value;
}

template <uint8_t StencilFaceState::*Member, StencilFaceState RasterState::*... Faces>
void set_face_byte(RasterState& state, double value) {
    (((state.*Faces).*Member = static_cast<uint8_t>(value)), ...);
}

template <uint8_t StencilFaceState::*Member>
void read_face_byte(ParseContext& context, const JsonNode& node, FaceDraft& draft) {
    constexpr auto kFront = &RasterState::stencil_front, kBack = &RasterState::stencil_back;
    const StateSetter set = draft.faces.size() == 2         ? set_face_byte<Member, kFront, kBack>
                            : draft.faces.front() == kFront ? set_face_byte<Member, kFront>
                                                            : set_face_byte<Member, kBack>;
    read_state_number(context, node, kByte, draft.pass, set);
}

using Face = StencilFaceState;
constexpr std::array kFaceKeys{
    KeyRule<FaceDraft>{"compare", read_face_choice<&Face::compare, kDepthCompares>},
    KeyRule<FaceDraft>{"fail", read_face_choice<&Face::fail, kStencilOps>},
    KeyRule<FaceDraft>{"depthFail", read_face_choice<&Face::depth_fail, kStencilOps>},
    KeyRule<FaceDraft>{"pass", read_face_choice<&Face::pass, kStencilOps>},
    KeyRule<FaceDraft>{"readMask", read_face_byte<&Face::read_mask>},
    KeyRule<FaceDraft>{"writeMask", read_face_byte<&Face::write_mask>},
    KeyRule<FaceDraft>{"reference", read_face_byte<&Face::reference>}};

void read_face(ParseContext& context, const JsonNode& node, FaceDraft draft) {
    read_object(context, node, "a stencil state", kFaceKeys, draft);
}

constexpr std::array kFacesKeys{
    KeyRule<PassDesc>{"front",
                      [](ParseContext& c, const JsonNode& n, PassDesc& p) {
                          read_face(c, n, {p, {&RasterState::stencil_front}});
                      }},
    KeyRule<PassDesc>{"back", [](ParseContext& c, const JsonNode& n, PassDesc& p) {
                          read_face(c, n, {p, {&RasterState::stencil_back}});
                      }}};

// Reads the stencil state: an object {"front": {…}, "back": {…}} with one or two states, or one state that
// applies to both faces.
void read_stencil(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    pass.state.stencil_test = true;
    if (node.find("front") != nullptr || node.find("back") != nullptr) {
        read_object(context, node, "a stencil state with two faces", kFacesKeys, pass);
        return;
    }
    read_face(context, node, {pass, {&RasterState::stencil_front, &RasterState::stencil_back}});
}

template <std::optional<RectPx> RasterState::*Rect>
void read_rect(ParseContext& context, const JsonNode& node, const NumberRule& place, PassDesc& pass) {
    if (!expect_items(context, node, 4, "4", "write [x, y, width, height]")) return;
    pass.state.*Rect = RectPx{};
    constexpr std::array<StateSetter, 4> kSet{
        [](RasterState& s, double v) { (s.*Rect)->x = static_cast<int32_t>(v); },
        [](RasterState& s, double v) { (s.*Rect)->y = static_cast<int32_t>(v); },
        [](RasterState& s, double v) { (s.*Rect)->width = static_cast<uint32_t>(v); },
        [](RasterState& s, double v) { (s.*Rect)->height = static_cast<uint32_t>(v); }};
    constexpr bool kScissor = Rect == &RasterState::scissor;
    for (uint32_t i = 0; i < kSet.size(); ++i) {
        const PointerScope scope(context, std::to_string(i));
        read_state_number(context, node.items[i], i < 2 ? place : kSide, pass, kSet[i],
                          RectSideDesc{kScissor, i});
    }
}

// Reads the scissor rectangle. In Vulkan a viewport may begin at negative coordinates, but a scissor
// rectangle must not.
void read_scissor(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    read_rect<&RasterState::scissor>(context, node, kInsidePlace, pass);
}

void read_viewport(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    read_rect<&RasterState::viewport>(context, node, kPlace, pass);
}

// Skips the keys "blend" and "writeMask". parse_state() passes both keys to parse_blend() at the end, because
// the blend state of an output combines them.
void skip_blend(ParseContext&, const JsonNode&, PassDesc&) {}

constexpr std::array kStateKeys{
    KeyRule<PassDesc>{"cull", [](ParseContext& c, const JsonNode& n,
                                 PassDesc& p) { read_choice(c, n, kCulls, p.state.cull); }},
    KeyRule<PassDesc>{"frontFace", [](ParseContext& c, const JsonNode& n,
                                      PassDesc& p) { read_choice(c, n, kFrontFaces, p.state.front_face); }},
    KeyRule<PassDesc>{"fill",
                      [](ParseContext& c, const JsonNode& n, PassDesc& p) {
                          p.state_locs.fill = n.loc;
                          read_choice(c, n, kFills, p.state.fill);
                      }},
    KeyRule<PassDesc>{"topology", [](ParseContext& c, const JsonNode& n,
                                     PassDesc& p) { read_choice(c, n, kTopologies, p.state.topology); }},
    KeyRule<PassDesc>{"depth", read_depth},
    KeyRule<PassDesc>{"depthClamp",
                      [](ParseContext& c, const JsonNode& n, PassDesc& p) {
                          p.state_locs.depth_clamp = n.loc;
                          read_bool(c, n, p.state.depth_clamp);
                      }},
    KeyRule<PassDesc>{"depthBias", read_bias},
    KeyRule<PassDesc>{"stencil", read_stencil},
    KeyRule<PassDesc>{"blend", skip_blend},
    KeyRule<PassDesc>{"writeMask", skip_blend},
    KeyRule<PassDesc>{"scissor", read_scissor},
    KeyRule<PassDesc>{"viewport", read_viewport},
    KeyRule<PassDesc>{"alphaToCoverage", [](ParseContext& c, const JsonNode& n,
                                            PassDesc& p) { read_bool(c, n, p.state.alpha_to_coverage); }},
};

}  // namespace

void list_state_grammar(std::vector<GrammarTable>& lists) {
    list_keys(lists, "state", kStateKeys);
    list_choices(lists, "cull", kCulls);
    list_choices(lists, "frontFace", kFrontFaces);
    list_choices(lists, "fill", kFills);
    list_choices(lists, "topology", kTopologies);
    lists.push_back({"depthTest", false, depth_choices()});
    list_keys(lists, "depthBias", kBiasKeys);
    list_keys(lists, "stencilFace", kFaceKeys);
    list_keys(lists, "stencilFaces", kFacesKeys);
    list_choices(lists, "compare", kDepthCompares);
    list_choices(lists, "stencilOperation", kStencilOps);
}

void parse_state(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    if (!read_object(context, node, "a state", kStateKeys, pass)) return;
    parse_blend(context, node.find("blend"), node.find("writeMask"), pass);
}

}  // namespace weft
