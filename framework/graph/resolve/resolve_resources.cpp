// Images and buffers: extents, mips, layers, bytes. Formats come later, when the usages are known.
#include <algorithm>
#include <bit>
#include <cmath>

#include "graph/diagnostics/whole_number.h"
#include "graph/parse/format_words.h"
#include "graph/parse/reference.h"
#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

constexpr uint32_t kCubeFaces = 6;

bool uses_mips_of(const ResourceDesc& desc) {
    const auto asks = [](const Expr& e) {
        return std::ranges::any_of(e.postfix, [](const ExprNode& n) { return n.op == ExprOp::mips_of; });
    };
    return asks(desc.size) || asks(desc.mips) || asks(desc.layers) || asks(desc.count);
}

// Rounded down, but a part of 1 is 1: halving ends there. Anything the device could not hold is capped here
// and reported by the limits' check.
uint32_t at_least_one(double value) {
    constexpr double kMost = 1u << 30;
    return saturated<uint32_t>(std::clamp(std::floor(value), 1.0, kMost));
}

ExprValue default_size(const ResolveState& state) {
    const auto render = state.names.values.find("render");
    return render != state.names.values.end() ? render->second : state.names.values.at("output");
}

bool default_size_is_faulty(const ResolveState& state) {
    return state.faulty_values.contains("render");
}

struct Element {
    std::string_view name;
    uint32_t bytes;
};
constexpr std::array kElements{Element{"u32", 4},   Element{"i32", 4},    Element{"f32", 4},
                               Element{"vec2", 8},  Element{"uvec2", 8},  Element{"ivec2", 8},
                               Element{"vec4", 16}, Element{"uvec4", 16}, Element{"ivec4", 16},
                               Element{"mat4", 64}};

class ResourceStep {
 public:
    ResourceStep(ResolveState& state, ResourceId id, const ResourceDesc& desc)
        : state_(state), decl_(state.graph.resources[id]), work_(state.resources[id]), desc_(desc) {}

    void run() {
        decl_.pre_exposed = desc_.pre_exposed;
        if (desc_.clear) decl_.clear = state_.color_here(*desc_.clear);
        if (desc_.is_buffer) {
            resolve_buffer();
        } else {
            resolve_image();
        }
    }

 private:
    // `fallback` when absent; marks the resource suspect when wrong.
    std::optional<ExprValue> value(const Expr& expression, ExprValue fallback) {
        if (expression.empty()) return fallback;
        const std::optional<ExprValue> found = state_.evaluate_here(expression);
        if (!found) work_.suspect_shape = true;
        return found;
    }

    std::optional<double> number(const Expr& expression, double fallback, const char* what) {
        const std::optional<ExprValue> found = value(expression, number_value(fallback));
        if (!found) return std::nullopt;
        if (!found->is_size && found->x > 0) return found->x;
        if (!found->is_size) {
            report_nothing(expression,
                           std::string(what) + " of " + quoted(desc_.name) + " is " + number_text(found->x));
            return std::nullopt;
        }
        work_.suspect_shape = true;
        Diagnostic& d =
            state_.error(expression.loc, "W106",
                         std::string(what) + " of " + quoted(desc_.name) + " is a size, not a number");
        add_help(d, "use .x or .y of it, or their product");
        return std::nullopt;
    }

    // Zero and less: unlike a part of 1, nothing that halving gives.
    void report_nothing(const Expr& expression, const std::string& message) {
        work_.suspect_shape = true;
        add_help(state_.error(expression.empty() ? desc_.loc : expression.loc, "W109", message),
                 "keep it above zero, for example with max(…, 1)");
    }

    bool check_size(const ExprValue& size) {
        if (size.x > 0 && size.y > 0) return true;
        report_nothing(desc_.size, "the size of " + quoted(desc_.name) + " is " + number_text(size.x) +
                                       " x " + number_text(size.y));
        return false;
    }

    void resolve_image() {
        decl_.kind = ResourceKind::image;
        decl_.image_kind = desc_.image_kind;
        if (!resolve_samples()) return;
        if (desc_.size.empty() && default_size_is_faulty(state_)) {
            work_.suspect_shape = true;
            return;
        }
        const std::optional<ExprValue> size = value(desc_.size, default_size(state_));
        const std::optional<double> layers = number(desc_.layers, 1, "the layer count");
        if (!size || !layers || !check_size(*size)) return;
        decl_.extent = {at_least_one(size->x), at_least_one(size->y), 1};
        resolve_layers(at_least_one(*layers));
        check_cube();
        const uint32_t largest = std::max({decl_.extent.width, decl_.extent.height, decl_.extent.depth});
        const uint32_t full = static_cast<uint32_t>(std::bit_width(largest));
        const std::optional<double> mips = number(desc_.mips, 1, "the mip count");
        if (!mips) return;
        decl_.mips = desc_.full_mips ? full : std::min(full, at_least_one(*mips));
        check_image_limits();
        state_.names.mip_counts[desc_.name] = decl_.mips;
    }

    bool resolve_samples() {
        if (desc_.samples.empty()) return true;
        const std::optional<double> samples =
            state_.number_here(desc_.samples, "the number of samples of " + quoted(desc_.name), 1, 8);
        if (samples) decl_.samples = static_cast<uint32_t>(*samples);
        work_.suspect_shape = work_.suspect_shape || !samples;
        return samples.has_value();
    }

    bool is_cube() const {
        return desc_.image_kind == ImageKind::cube || desc_.image_kind == ImageKind::cube_array;
    }

    void check_cube() {
        if (!is_cube() || decl_.extent.width == decl_.extent.height) return;
        work_.suspect_shape = true;
        Diagnostic& d = state_.error(desc_.size.empty() ? desc_.loc : desc_.size.loc, "W109",
                                     "the faces of cube " + quoted(desc_.name) + " are " +
                                         extent_text(decl_.extent) + ", which is no square");
        add_help(d, "give the side: \"size\": 128");
    }

    void resolve_layers(uint32_t layers) {
        const bool cube = is_cube();
        if (desc_.image_kind == ImageKind::d3) {
            decl_.extent.depth = layers;
        } else {
            decl_.layers = cube ? kCubeFaces * layers : layers;
            if (layers > 1 && desc_.image_kind == ImageKind::d2) decl_.image_kind = ImageKind::d2_array;
        }
    }

    void check_image_limits() {
        const GraphLimits& limits = state_.input.limits;
        const DeviceProfile& device = state_.input.profile;
        const Extent3D& e = decl_.extent;
        check_limit("image " + quoted(desc_.name) + " is " + extent_text(e) + " px",
                    std::max({e.width, e.height, e.depth}), device.max_image_2d_px, limits.image_side_px,
                    "graph.imageSidePx", " px a side");
        check_limit("image " + quoted(desc_.name) + " has " + std::to_string(decl_.layers) + " layers",
                    decl_.layers, device.max_image_layers, limits.layers, "graph.layers", " layers");
        check_limit("image " + quoted(desc_.name) + " has " + std::to_string(decl_.mips) + " mips",
                    decl_.mips, UINT32_MAX, limits.mips, "graph.mips", " mips");
        if (decl_.samples != 1 && (decl_.mips != 1 || !std::has_single_bit(decl_.samples))) {
            Diagnostic& d =
                state_.error(desc_.loc, "W119",
                             "image " + quoted(desc_.name) + " can't have these samples and mips together");
            add_help(d, "multisampled images have one mip and 2, 4 or 8 samples");
        }
    }

    // What the device offers first: no limit can be raised beyond it.
    void check_limit(const std::string& what, uint32_t value, uint32_t device, uint64_t limit,
                     const std::string& name, const std::string& unit) {
        if (value > device) return over_limit(what, std::to_string(device) + unit);
        if (value <= limit) return;
        work_.suspect_shape = true;
        Diagnostic& d =
            state_.error(desc_.loc, "W125", what + "; the limit is " + std::to_string(limit) + unit);
        add_help(d, "make it smaller, " + raise_limit_text(name));
    }

    void over_limit(const std::string& what, const std::string& limit) {
        work_.suspect_shape = true;
        Diagnostic& d = state_.error(desc_.loc, "W119", what + "; the device offers at most " + limit);
        add_help(d, "the limit comes from the device profile " + quoted(state_.input.profile.name));
    }

    std::optional<uint32_t> element_bytes() {
        const auto plain = std::ranges::find(kElements, desc_.element, &Element::name);
        if (plain != kElements.end()) return plain->bytes;
        const auto& strides = state_.input.imports.strides;
        const auto known = strides.find(desc_.element);
        if (known != strides.end()) return known->second;
        work_.suspect_shape = true;
        std::vector<std::string> names = plain_elements();
        for (const auto& [name, unused] : strides) names.push_back(name);
        Diagnostic& d = state_.error(
            desc_.loc, "W116",
            "buffer " + quoted(desc_.name) + " has elements of unknown type " + quoted(desc_.element));
        const std::string near = did_you_mean_text(desc_.element, names);
        add_help(d, near.empty() ? "known types are " + joined(names) : near);
        return std::nullopt;
    }

    void resolve_buffer() {
        decl_.kind = ResourceKind::buffer;
        decl_.aspects = aspect::kColor;
        const std::optional<uint32_t> stride = element_bytes();
        const std::optional<double> count = number(desc_.count, 1, "the element count");
        if (!stride || !count) return;
        const uint64_t limit = state_.input.profile.max_storage_buffer_bytes;
        const double elements = std::max(1.0, std::floor(*count));
        decl_.stride_bytes = *stride;
        // Compared as numbers before the product is formed: it could pass 2^64.
        if (elements * *stride > static_cast<double>(limit)) {
            over_limit(
                "buffer " + quoted(desc_.name) + " holds more than " + std::to_string(limit) + " bytes",
                std::to_string(limit) + " bytes a buffer");
            return;
        }
        decl_.size_bytes = saturated<uint64_t>(elements) * *stride;
    }

    ResolveState& state_;
    ResourceDecl& decl_;
    ResourceWork& work_;
    const ResourceDesc& desc_;
};

bool becomes_resource(const ImportDesc& import) {
    return import.kind != import_kind_name(ImportKind::draw_list);
}

// Once all have their ids.
void tie_rings(ResolveState& state) {
    for (ResourceId id = 0; id < state.resources.size(); ++id) {
        const ResourceDesc* desc = state.resources[id].desc;
        if (!desc) continue;
        const auto history = state.histories.find(desc->name);
        const uint32_t copies = history != state.histories.end() ? history->second : 0;
        if (copies == 0 && desc->keep == KeepMode::none) continue;
        ResourceDecl& decl = state.graph.resources[id];
        decl.lifetime = ResourceLifetime::persistent;
        decl.history = copies;
        decl.ring = state.resource_id(desc->name);
        if (desc->first_frame && decl.age == 0) decl.first_frame = state.color_here(*desc->first_frame);
        decl.on_resize = desc->on_resize;
        state.resources[id].has_content = decl.age > 0 || copies == 0;
    }
}

// How many earlier frames it keeps.
uint32_t history_of(ResolveState& state, const ResourceDesc& desc) {
    if (desc.history.empty()) return 0;
    const std::optional<double> frames =
        state.number_here(desc.history, "the history of " + quoted(desc.name), 0, kMaxHistory);
    const auto copies = static_cast<uint32_t>(frames.value_or(0));
    if (copies > 0) state.histories.emplace(desc.name, copies);
    if (!frames) state.suspect_histories.insert(desc.name);
    return copies;
}

void name_resources(ResolveState& state) {
    struct Role {
        const ResourceDesc* desc = nullptr;  // null: an import
        uint32_t age = 0;
    };
    std::map<std::string, Role> names;
    for (const auto& [name, import] : state.input.graph.imports) {
        if (becomes_resource(import)) names[name] = {};
    }
    for (const auto& [name, desc] : state.input.graph.resources) {
        if (state.input.graph.imports.contains(name)) {
            Diagnostic& d = state.error(desc.loc, "W118", quoted(name) + " is both an import and a resource");
            add_help(d, "rename one of them");
        }
        names[name] = {&desc, 0};
        const uint32_t copies = history_of(state, desc);
        for (uint32_t age = 1; age <= copies; ++age) names[role_name(name, age)] = {&desc, age};
    }
    if (names.size() > state.input.limits.resources) {
        state.over_limit = true;
        Diagnostic& d =
            state.error(state.input.graph.resources.empty() ? SourceLoc{}
                                                            : state.input.graph.resources.begin()->second.loc,
                        "W125",
                        "the graph has " + std::to_string(names.size()) +
                            " resources, each copy of a history counted; the limit is " +
                            std::to_string(state.input.limits.resources));
        add_help(d, "use layers or mips of fewer images, " + raise_limit_text("graph.resources"));
    }
    for (const auto& [name, role] : names) {
        ResourceDecl decl;
        decl.name = name;
        decl.age = role.age;
        decl.loc = role.desc ? role.desc->loc : state.input.graph.imports.at(name).loc;
        state.graph.resources.push_back(std::move(decl));
        state.resources.push_back({.desc = role.desc});
    }
    tie_rings(state);
}

}  // namespace

std::vector<std::string> plain_elements() {
    std::vector<std::string> names;
    for (const Element& element : kElements) names.emplace_back(element.name);
    return names;
}

void resolve_resources(ResolveState& state) {
    name_resources(state);
    check_draw_list_imports(state);
    const auto count = static_cast<ResourceId>(state.graph.resources.size());
    for (ResourceId id = 0; id < count; ++id) {
        ResourceDecl& decl = state.graph.resources[id];
        if (state.resources[id].desc) continue;
        resolve_import(state, state.input.graph.imports.at(decl.name), decl, state.resources[id]);
        if (decl.lifetime == ResourceLifetime::imported && decl.kind == ResourceKind::image) {
            state.names.mip_counts[decl.name] = decl.mips;
        }
    }
    // Those that ask for another's mips come second.
    for (const bool second : {false, true}) {
        for (ResourceId id = 0; id < count; ++id) {
            const ResourceDesc* desc = state.resources[id].desc;
            if (!desc || state.graph.resources[id].age > 0) continue;
            if (uses_mips_of(*desc) == second) ResourceStep(state, id, *desc).run();
        }
    }
    spread_over_rings(state);
    const auto output = std::ranges::find_if(state.input.graph.imports, [](const auto& import) {
        return import.second.kind == import_kind_name(ImportKind::output);
    });
    if (output != state.input.graph.imports.end()) state.graph.output = state.resource_id(output->first);
}

}  // namespace weft
