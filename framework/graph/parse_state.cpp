#include "graph/parse_context.h"

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
constexpr std::array kCompares{
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

// "none", "greater" (tested only) or "greater_write".
void read_depth(ParseContext& context, const JsonNode& node, RasterState& state) {
    constexpr std::string_view kWrite = "_write";
    if (!expect(context, node, JsonKind::string)) return;
    std::string_view name = node.string;
    if (name == "none") return;
    const bool write = name.ends_with(kWrite);
    if (write) name.remove_suffix(kWrite.size());
    if (find_choice(std::span<const Choice<CompareOp>>(kCompares), name, state.depth_compare)) {
        state.depth_test = true;
        state.depth_write = write;
        return;
    }
    std::vector<std::string> allowed{"none"};
    for (const Choice<CompareOp>& compare : kCompares) {
        allowed.emplace_back(compare.name);
        allowed.push_back(std::string(compare.name) + "_write");
    }
    bad_choice(context, node, node.string, allowed);
}

constexpr std::array kBiasKeys{
    KeyRule<RasterState>{"constant", [](ParseContext& c, const JsonNode& n,
                                        RasterState& s) { read_float(c, n, s.depth_bias_constant); }},
    KeyRule<RasterState>{"slope", [](ParseContext& c, const JsonNode& n,
                                     RasterState& s) { read_float(c, n, s.depth_bias_slope); }},
    KeyRule<RasterState>{"clamp", [](ParseContext& c, const JsonNode& n,
                                     RasterState& s) { read_float(c, n, s.depth_bias_clamp); }},
};

void read_bias(ParseContext& context, const JsonNode& node, RasterState& state) {
    read_object(context, node, "a depth bias", kBiasKeys, state);
}

using Face = StencilFaceState;
constexpr std::array kFaceKeys{
    KeyRule<Face>{"compare", [](ParseContext& c, const JsonNode& n,
                                Face& f) { read_choice(c, n, kCompares, f.compare); }},
    KeyRule<Face>{
        "fail", [](ParseContext& c, const JsonNode& n, Face& f) { read_choice(c, n, kStencilOps, f.fail); }},
    KeyRule<Face>{"depthFail", [](ParseContext& c, const JsonNode& n,
                                  Face& f) { read_choice(c, n, kStencilOps, f.depth_fail); }},
    KeyRule<Face>{
        "pass", [](ParseContext& c, const JsonNode& n, Face& f) { read_choice(c, n, kStencilOps, f.pass); }},
    KeyRule<Face>{"readMask",
                  [](ParseContext& c, const JsonNode& n, Face& f) { read_byte(c, n, f.read_mask); }},
    KeyRule<Face>{"writeMask",
                  [](ParseContext& c, const JsonNode& n, Face& f) { read_byte(c, n, f.write_mask); }},
    KeyRule<Face>{"reference",
                  [](ParseContext& c, const JsonNode& n, Face& f) { read_byte(c, n, f.reference); }},
};

void read_face(ParseContext& context, const JsonNode& node, Face& face) {
    read_object(context, node, "a stencil state", kFaceKeys, face);
}

constexpr std::array kFacesKeys{
    KeyRule<RasterState>{"front", [](ParseContext& c, const JsonNode& n,
                                     RasterState& s) { read_face(c, n, s.stencil_front); }},
    KeyRule<RasterState>{
        "back", [](ParseContext& c, const JsonNode& n, RasterState& s) { read_face(c, n, s.stencil_back); }},
};

// {"front": {…}, "back": {…}}, or one state for both faces.
void read_stencil(ParseContext& context, const JsonNode& node, RasterState& state) {
    state.stencil_test = true;
    if (node.find("front") != nullptr || node.find("back") != nullptr) {
        read_object(context, node, "a stencil state with two faces", kFacesKeys, state);
        return;
    }
    read_face(context, node, state.stencil_front);
    state.stencil_back = state.stencil_front;
}

void read_rect(ParseContext& context, const JsonNode& node, std::optional<RectPx>& out) {
    std::array<double, 4> numbers{};
    if (!read_numbers(context, node, numbers)) return;
    std::array<int64_t, 4> whole{};
    for (size_t i = 0; i < whole.size(); ++i) {
        const PointerScope scope(context, std::to_string(i));
        if (!read_integer(context, node.items[i], i < 2 ? -kMaxRectPx : 1, kMaxRectPx, whole[i])) return;
    }
    out = RectPx{static_cast<int32_t>(whole[0]), static_cast<int32_t>(whole[1]),
                 static_cast<uint32_t>(whole[2]), static_cast<uint32_t>(whole[3])};
}

// Pixels before the attachment's corner don't exist; a viewport may begin there all the same.
void read_scissor(ParseContext& context, const JsonNode& node, RasterState& state) {
    read_rect(context, node, state.scissor);
    if (state.scissor && (state.scissor->x < 0 || state.scissor->y < 0)) {
        context.error(node.loc, "W109", "a scissor begins at 0 or above",
                      "write [x, y, width, height] within the image");
    }
}

// Blending is read apart, by parse_blend(): it belongs to the outputs.
void skip_blend(ParseContext&, const JsonNode&, RasterState&) {}

constexpr std::array kStateKeys{
    KeyRule<RasterState>{"cull", [](ParseContext& c, const JsonNode& n,
                                    RasterState& s) { read_choice(c, n, kCulls, s.cull); }},
    KeyRule<RasterState>{"frontFace", [](ParseContext& c, const JsonNode& n,
                                         RasterState& s) { read_choice(c, n, kFrontFaces, s.front_face); }},
    KeyRule<RasterState>{"fill", [](ParseContext& c, const JsonNode& n,
                                    RasterState& s) { read_choice(c, n, kFills, s.fill); }},
    KeyRule<RasterState>{"topology", [](ParseContext& c, const JsonNode& n,
                                        RasterState& s) { read_choice(c, n, kTopologies, s.topology); }},
    KeyRule<RasterState>{"depth", read_depth},
    KeyRule<RasterState>{"depthClamp", [](ParseContext& c, const JsonNode& n,
                                          RasterState& s) { read_bool(c, n, s.depth_clamp); }},
    KeyRule<RasterState>{"depthBias", read_bias},
    KeyRule<RasterState>{"stencil", read_stencil},
    KeyRule<RasterState>{"blend", skip_blend},
    KeyRule<RasterState>{"writeMask", skip_blend},
    KeyRule<RasterState>{"scissor", read_scissor},
    KeyRule<RasterState>{
        "viewport", [](ParseContext& c, const JsonNode& n, RasterState& s) { read_rect(c, n, s.viewport); }},
    KeyRule<RasterState>{"alphaToCoverage", [](ParseContext& c, const JsonNode& n,
                                               RasterState& s) { read_bool(c, n, s.alpha_to_coverage); }},
};

}  // namespace

void parse_state(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    if (!read_object(context, node, "a state", kStateKeys, pass.state)) return;
    parse_blend(context, node.find("blend"), node.find("writeMask"), pass);
}

}  // namespace weft
