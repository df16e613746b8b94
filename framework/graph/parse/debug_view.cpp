#include "graph/parse/debug_view.h"

#include <algorithm>
#include <array>

#include "graph/parse/drawn_view.h"
#include "graph/parse/expression.h"
#include "graph/parse/module_scope.h"
#include "graph/parse/reference.h"
#include "weft/format.h"

namespace weft {
namespace {

// The ways to turn the values of a resource into colours. The shaders in shaders/debug/ get the number of a
// decoder as their specialization constant DECODE, so the order must match the numbers in these shaders.
enum class Decoder : uint8_t {
    color,
    display,
    squared,
    octahedral,
    signed_vector,
    depth,
    vector,
    red,
    green,
    blue,
    alpha,
    heat,
    index,
};
constexpr std::array<const char*, 13> kNames{"color", "display", "squared", "octahedral", "signed",
                                             "depth", "vector",  "red",     "green",      "blue",
                                             "alpha", "heat",    "index"};

// The properties of the shown resource that select its decoder and shader. They come from the description of
// the resource, because debug views are added before the graph is resolved.
struct Shown {
    bool is_buffer = false;
    bool layered = false;
    // True for 3D and multisampled images, which the built-in debug shaders cannot show.
    bool needs_own_shader = false;
    bool float_buffer = false;
    const FormatInfo* format = nullptr;
};

// Returns true if shaders sample the format as floats. Depth formats are sampled as floats too.
bool is_float(NumericClass numeric) {
    return numeric == NumericClass::float_like || numeric == NumericClass::depth;
}

bool is_float_element(const std::string& element) {
    return element == "f32" || element.starts_with("vec") || element == "mat4";
}

Shown to_shown(const ResourceDesc& resource) {
    Shown shown;
    shown.is_buffer = resource.is_buffer;
    shown.float_buffer = is_float_element(resource.element);
    shown.layered = resource.image_kind != ImageKind::d2 && resource.image_kind != ImageKind::d3;
    shown.needs_own_shader = resource.image_kind == ImageKind::d3 || !resource.samples.empty();
    if (!resource.formats.empty())
        if (const std::optional<Format> format = format_from_name(resource.formats.front()))
            shown.format = &format_info(*format);
    return shown;
}

Shown to_shown(const ResourceDecl& import) {
    Shown shown;
    shown.is_buffer = import.kind == ResourceKind::buffer;
    shown.layered = import.layers > 1;
    shown.needs_own_shader = import.image_kind == ImageKind::d3 || import.samples > 1;
    if (!shown.is_buffer) shown.format = &format_info(import.format);
    return shown;
}

Decoder usual_decoder(const Shown& shown) {
    if (shown.is_buffer || !shown.format) return Decoder::heat;
    const FormatInfo& info = *shown.format;
    if (info.depth) return Decoder::depth;
    if (!is_float(info.numeric)) return Decoder::index;
    if (info.components == 1) return Decoder::red;
    const std::string_view name = info.name;
    if (name.find("snorm") != std::string_view::npos) return Decoder::signed_vector;
    const bool wide = name.ends_with("f") || name == "rgb9e5";
    if (wide) return info.components == 2 ? Decoder::vector : Decoder::color;
    return info.srgb ? Decoder::color : Decoder::display;
}

// Returns the values that are shown as black and as white if the view has no "range". For the decoder
// "depth", they are values of log2(1 + distance in metres): 6 stands for 63 m.
std::array<double, 2> usual_range(const Shown& shown, Decoder decoder) {
    const bool counts = shown.is_buffer || !shown.format || !is_float(shown.format->numeric);
    if (decoder == Decoder::depth) return {0, 6};
    if (decoder == Decoder::vector) return {0, 0.05};
    return {0, counts ? 64.0 : 1.0};
}

const char* shader_for(const Shown& shown) {
    if (shown.is_buffer) return shown.float_buffer ? "debug/numbers.frag" : "debug/words.frag";
    if (!shown.format || is_float(shown.format->numeric)) return "debug/image.frag";
    return shown.format->numeric == NumericClass::uint ? "debug/integers.frag" : "debug/signed_integers.frag";
}

bool is_plain_depth(const GraphDesc& graph, const std::string& name) {
    const auto found = graph.resources.find(name);
    if (found == graph.resources.end()) return false;
    const ResourceDesc& depth = found->second;
    return depth.image_kind == ImageKind::d2 && depth.samples.empty() && depth.layers.empty() && !depth.clear;
}

// Returns a reference to the depth attachment that was drawn together with the shown image, so that the view
// can tell the background, where depth is 0, from drawn surfaces. Returns nullopt unless all of this is true:
// - `shown` is the whole image of the current frame.
// - Exactly one pass has the image in "out". It is a raster pass without "if" and "repeat".
// - Its depth attachment is a 2D image without layers and multisampling. Neither the port nor the image has
//   a "clear" value.
std::optional<RefDesc> drawn_depth(const GraphDesc& graph, const RefDesc& shown) {
    if (shown.history > 0 || shown.mip_first || shown.layer_first) return std::nullopt;
    std::optional<RefDesc> depth;
    for (const auto& [name, pass] : graph.passes) {
        if (std::ranges::none_of(pass.out, [&](const PortDesc& out) { return out.ref.name == shown.name; }))
            continue;
        const bool plain = pass.type == "raster" && pass.depth && pass.condition.empty() &&
                           pass.repeat.empty() && !pass.clear_ports.contains(pass.depth->port);
        if (depth || !plain || !is_plain_depth(graph, pass.depth->ref.name)) return std::nullopt;
        depth = pass.depth->ref;
        depth->pass = name;
        depth->text = depth->name + "@" + name;
    }
    return depth;
}

Expr output_size(SourceLoc loc) {
    return {{ExprNode{ExprOp::name, 0, "output", loc}}, "output", loc};
}

ParamValueDesc number_param(const char* name, Expr value, SourceLoc loc) {
    return {name, {std::move(value)}, loc};
}

PortDesc sampled_port(const char* name, RefDesc ref, SourceLoc loc) {
    PortDesc port{.port = name, .ref = std::move(ref), .sampler = {}, .loc = loc};
    port.sampler = SamplerDecl{.filter = SamplerFilter::nearest, .mip_filter = SamplerFilter::nearest};
    return port;
}

PassDesc view_pass(const GraphDesc& graph, const DebugViewDesc& view, const Shown& shown) {
    PassDesc pass;
    pass.name = kDebugView;
    pass.module = module_of(graph, view.name);
    pass.type = "fullscreen";
    pass.observes = true;
    pass.shader = view.shader.empty() ? shader_for(shown) : view.shader;
    pass.loc = pass.shader_loc = view.loc;
    PortDesc in = sampled_port("shown", view.show, view.loc);
    if (shown.layered && !in.ref.layer_first) in.ref.layer_first = number_expression(0, view.loc);
    if (shown.is_buffer) in.sampler.reset();
    pass.in.push_back(std::move(in));
    PortDesc out{.port = "color", .ref = {}, .sampler = {}, .loc = view.loc};
    out.ref.name = out.ref.text = kDebugView;
    out.ref.loc = view.loc;
    pass.out.push_back(std::move(out));
    if (!view.shader.empty()) return pass;
    if (const std::optional<RefDesc> depth = drawn_depth(graph, view.show); depth && !shown.is_buffer)
        pass.in.push_back(sampled_port("surface", *depth, view.loc));
    const auto named = std::ranges::find(kNames, view.decode);
    const Decoder decoder =
        named != kNames.end() ? static_cast<Decoder>(named - kNames.begin()) : usual_decoder(shown);
    if (decoder == Decoder::depth) set_drawn_view(graph, view.show, pass);
    const std::array<double, 2> usual = usual_range(shown, decoder);
    for (size_t i = 0; i < 2; ++i)
        pass.params.push_back(
            number_param(i == 0 ? "black" : "white",
                         view.range ? (*view.range)[i] : number_expression(usual[i], view.loc), view.loc));
    pass.params.push_back(number_param("size_px", output_size(view.loc), view.loc));
    pass.constants.push_back(
        number_param("DECODE", number_expression(static_cast<double>(decoder), view.loc), view.loc));
    return pass;
}

Result<DebugViewDesc> find_view(const GraphDesc& graph, const std::string& name) {
    const auto view = graph.debug.find(name);
    if (view != graph.debug.end()) return view->second;
    Result<RefDesc> ref = parse_reference({.text = name, .literal = {}}, graph.sources);
    DebugViewDesc plain;
    plain.name = name;
    if (ref && (graph.resources.contains(ref->name) || graph.imports.contains(ref->name))) {
        plain.show = std::move(*ref);
        return plain;
    }
    Diagnostic d =
        graph.sources.error({}, "W103", "there is neither a debug view nor a resource \"" + name + "\"");
    std::vector<std::string> known;
    for (const auto& [view_name, unused] : graph.debug) known.push_back(view_name);
    for (const auto& [resource, unused] : graph.resources) known.push_back(resource);
    const std::string near = did_you_mean_text(name, known);
    std::string all;
    for (const auto& [view_name, unused] : graph.debug) all += (all.empty() ? "" : ", ") + view_name;
    d.help.push_back(!near.empty() ? near
                     : all.empty() ? "this graph has no debug views; name a resource to show"
                                   : "debug views are " + all + "; the name of a resource is possible too");
    return d;
}

}  // namespace

std::vector<std::string> debug_decoders() {
    return {kNames.begin(), kNames.end()};
}

Diagnostics debug_view_faults(const GraphDesc& graph) {
    std::vector<std::string> known;
    for (const auto& [name, unused] : graph.resources) known.push_back(name);
    for (const auto& [name, unused] : graph.imports) known.push_back(name);
    Diagnostics faults;
    for (const auto& [name, view] : graph.debug) {
        const std::string& shown = view.show.name;
        if (graph.resources.contains(shown) || graph.imports.contains(shown)) continue;
        Diagnostic& d = faults.emplace_back(graph.sources.error(
            view.show.loc, "W103", "debug view \"" + name + "\" shows unknown resource \"" + shown + "\""));
        const std::string near = did_you_mean_text(shown, known);
        d.help.push_back(near.empty()
                             ? "name a resource of \"resources\" or \"imports\", or remove the debug view"
                             : near);
    }
    return faults;
}

Status add_debug_view(GraphDesc& graph, const ImportCatalog& imports, const std::string& name) {
    const Result<DebugViewDesc> view = find_view(graph, name);
    if (!view) return view.errors();
    if (graph.passes.contains(kDebugView) || graph.resources.contains(kDebugView)) {
        Diagnostic d = graph.sources.error(
            view->loc, "W109",
            "debug views need the name \"debugView\", but the graph already uses this name");
        d.help.emplace_back("rename \"debugView\" in the graph");
        return d;
    }
    Shown shown;
    const auto resource = graph.resources.find(view->show.name);
    const auto import = imports.imports.find(view->show.name);
    if (resource != graph.resources.end())
        shown = to_shown(resource->second);
    else if (import != imports.imports.end())
        shown = to_shown(import->second.resource);
    if (shown.needs_own_shader && view->shader.empty()) {
        Diagnostic d = graph.sources.error(
            view->loc, "W109",
            "\"" + view->show.name + "\" is a 3D or multisampled image, which \"decode\" cannot show");
        d.help.emplace_back(
            "set \"shader\" to your own shader, which samples \"shown\" and writes \"color\"");
        return d;
    }
    ResourceDesc image;
    image.name = kDebugView;
    image.formats = {"rgba8"};
    image.size = output_size(view->loc);
    image.loc = view->loc;
    graph.resources.emplace(kDebugView, std::move(image));
    graph.passes.emplace(kDebugView, view_pass(graph, *view, shown));
    return Unit{};
}

}  // namespace weft
