// The fixed-function state of a pass: its numbers are evaluated, and the device can do what it asks for.
#include <array>

#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

// An ability that not every device has, and the state that needs it.
struct StateNeed {
    bool asked = false;
    bool offered = false;
    SourceLoc loc;
    std::string state;  // `"depthClamp": true`
    std::string remedy;
};

std::array<StateNeed, 3> needs_of(const RasterState& state, const StateLocs& locs,
                                  const DeviceProfile& profile) {
    return {
        StateNeed{state.fill != FillMode::fill, profile.non_solid_fill, locs.fill,
                  state.fill == FillMode::line ? "\"fill\": \"line\"" : "\"fill\": \"point\"",
                  "leave \"fill\" out, or draw a list of lines or points with \"topology\""},
        StateNeed{state.depth_clamp, profile.depth_clamp, locs.depth_clamp, "\"depthClamp\": true",
                  "leave it out, and let the vertex stage keep gl_Position.z between 0 and gl_Position.w"},
        StateNeed{state.depth_bias_clamp != 0, profile.depth_bias_clamp, locs.depth_bias_clamp,
                  "a \"clamp\" of \"depthBias\"", "leave \"clamp\" out, and choose a smaller \"slope\""}};
}

}  // namespace

// The numbers may depend on the indices of a repeat.
void set_state(ResolveState& state, PassId id) {
    PassDecl& decl = state.graph.passes[id];
    const PassDesc& desc = *state.passes[id].desc;
    decl.state = desc.state;
    for (const StateNumberDesc& number : desc.state_numbers) {
        const std::optional<double> value =
            state.number_here(number.value, "a number in the state of pass " + quoted(desc.name),
                              number.least, number.most, number.whole);
        if (value) number.set(decl.state, *value);
    }
}

void check_state(ResolveState& state, PassId id) {
    const PassDecl& decl = state.graph.passes[id];
    if (decl.kind != PassKind::raster && decl.kind != PassKind::fullscreen) return;
    const StateLocs& locs = state.passes[id].desc->state_locs;
    for (const StateNeed& need : needs_of(decl.state, locs, state.input.profile)) {
        if (!need.asked || need.offered) continue;
        Diagnostic& error = state.pass_error(
            id, need.loc.line != 0 ? need.loc : decl.loc, "W187",
            "pass " + quoted(decl.name) + " asks for " + need.state + ", which the device can't do");
        add_help(error, need.remedy);
    }
}

}  // namespace weft
