#include "graph/resolve/expand/draft_pass.h"

#include <algorithm>
#include <array>

#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"

namespace weft {
namespace {

struct KindName {
    std::string_view name;
    PassKind kind;
};
constexpr std::array kKinds{
    KindName{"blit", PassKind::blit},
    KindName{"clear", PassKind::clear},
    KindName{"compute", PassKind::compute},
    KindName{"copy", PassKind::copy},
    KindName{"fullscreen", PassKind::fullscreen},
    KindName{"raster", PassKind::raster},
    KindName{"readback", PassKind::readback},
};

// An optional device feature, and the state of a pass that needs this feature.
struct StateNeed {
    bool asked = false;
    bool offered = false;
    SourceLoc loc;
    // The text of the state in the graph file, for messages: `"depthClamp": true`.
    std::string state;
    std::string remedy;
};

std::array<StateNeed, 3> list_needs(const RasterState& state, const StateLocs& locs,
                                    const DeviceProfile& profile) {
    return {
        StateNeed{state.fill != FillMode::fill, profile.non_solid_fill, locs.fill,
                  state.fill == FillMode::line ? "\"fill\": \"line\"" : "\"fill\": \"point\"",
                  "remove \"fill\", or draw lines or points with \"topology\""},
        StateNeed{state.depth_clamp, profile.depth_clamp, locs.depth_clamp, "\"depthClamp\": true",
                  "remove \"depthClamp\", and clamp gl_Position.z to 0..gl_Position.w in the vertex stage"},
        StateNeed{state.depth_bias_clamp != 0, profile.depth_bias_clamp, locs.depth_bias_clamp,
                  "a \"clamp\" of \"depthBias\"", "remove \"clamp\", and choose a smaller \"slope\""}};
}

}  // namespace

RasterState evaluate_state(const PassDesc& desc, const Evaluator& evaluator) {
    RasterState state = desc.state;
    for (const StateNumberDesc& number : desc.state_numbers) {
        const std::optional<double> value =
            evaluator.number(number.value, "a number in the state of pass " + quote(desc.name), number.least,
                             number.most, number.whole);
        if (value) number.set(state, *value);
    }
    return state;
}

void find_kind(const ResolveInput& input, PassId id, PassDraft& draft, PassReporter& report) {
    PassDecl& decl = draft.decl;
    const auto* built_in = std::ranges::find(kKinds, std::string_view(decl.type), &KindName::name);
    if (built_in != kKinds.end()) {
        decl.kind = built_in->kind;
        return;
    }
    decl.kind = PassKind::custom;
    const auto custom = input.passes.find(decl.type);
    if (custom != input.passes.end()) {
        draft.custom = &custom->second;
        return;
    }
    std::vector<std::string> known;
    for (const KindName& kind : kKinds) known.emplace_back(kind.name);
    for (const auto& [name, unused] : input.passes) known.push_back(name);
    Diagnostic& d = report.error(id, decl.loc, "W115",
                                 "pass " + quote(decl.name) + " has unknown type " + quote(decl.type));
    const std::string near = did_you_mean_text(decl.type, known);
    add_help(d, near.empty() ? "the known types are " + quote_all(known) : near);
}

void find_shader(const ResolveInput& input, PassId id, PassDraft& draft, Suspects& suspects,
                 PassReporter& report) {
    const PassDesc& desc = *draft.desc;
    const PassDecl& decl = draft.decl;
    if (!has_shader(decl.kind)) return;
    const auto program = input.shaders.find(desc.shader);
    // A shader program without modules failed to compile, and the shader compiler has already reported the
    // error.
    if (program != input.shaders.end() && program->second.modules.empty()) {
        suspects.passes[id] = 1;
        return;
    }
    if (program == input.shaders.end()) {
        Diagnostic& d = report.error(
            id, desc.shader_loc, "W177",
            desc.shader.empty()
                ? decl.type + " pass " + quote(decl.name) + " has no shader"
                : "shader " + quote(desc.shader) + " of pass " + quote(decl.name) + " was not compiled");
        add_help(d, "name a shader: \"shader\": \"name" +
                        std::string(decl.kind == PassKind::compute      ? ".comp\""
                                    : decl.kind == PassKind::fullscreen ? ".frag\""
                                                                        : "\" for name/name.vert and .frag"));
        return;
    }
    const ShaderStageMask wanted =
        stage_bit(decl.kind == PassKind::compute ? ShaderStage::compute : ShaderStage::fragment);
    draft.shader = &program->second.interface;
    if (draft.shader->stages & wanted) return;
    draft.shader = nullptr;
    Diagnostic& d = report.error(id, desc.shader_loc, "W177",
                                 "shader " + quote(desc.shader) + " does not fit a " + decl.type + " pass");
    add_help(d,
             decl.kind == PassKind::compute ? "name a .comp shader" : "name a shader with a fragment stage");
}

void check_state(const DeviceProfile& profile, PassId id, const PassDraft& draft, PassReporter& report) {
    const PassDecl& decl = draft.decl;
    if (decl.kind != PassKind::raster && decl.kind != PassKind::fullscreen) return;
    const StateLocs& locs = draft.desc->state_locs;
    for (const StateNeed& need : list_needs(decl.state, locs, profile)) {
        if (!need.asked || need.offered) continue;
        Diagnostic& error = report.error(
            id, need.loc.line != 0 ? need.loc : decl.loc, "W187",
            "pass " + quote(decl.name) + " uses " + need.state + ", which the device does not support");
        add_help(error, need.remedy);
    }
}

}  // namespace weft
