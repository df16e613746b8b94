// Whose eyes a pass looks through: one of the views that the program offers.
#include <algorithm>

#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

struct OfferedViews {
    std::vector<std::string> names;  // without numbers, each once
    uint32_t numbered = 0;           // how many of the asked name have a number
    bool is_known = false;
};

OfferedViews offered_views(const ResolveState& state, const std::string& asked) {
    OfferedViews offered;
    for (const std::string& view : state.input.imports.views) {
        const std::string name = view.substr(0, view.find('('));
        if (offered.names.empty() || offered.names.back() != name) offered.names.push_back(name);
        if (name != asked) continue;
        offered.is_known = true;
        offered.numbered += name.size() < view.size() ? 1 : 0;
    }
    return offered;
}

void report_unknown(ResolveState& state, PassId pass, const std::string& view, const OfferedViews& offered) {
    const PassDesc& desc = *state.passes[pass].desc;
    Diagnostic& d =
        state.pass_error(pass, desc.view_loc.line != 0 ? desc.view_loc : desc.loc, "W118",
                         "pass " + quoted(desc.name) + " looks through unknown view " + quoted(view));
    if (offered.is_known && offered.numbered > 0)
        return add_help(d, "say which one by its number, from 0 to " + std::to_string(offered.numbered - 1) +
                               ": \"view\": \"" + desc.view + "(0)\"");
    if (offered.is_known) return add_help(d, "there is one only: \"view\": " + quoted(desc.view));
    const std::string near = did_you_mean_text(desc.view, offered.names);
    add_help(d, near.empty() ? "views are " + joined(state.input.imports.views) : near);
}

}  // namespace

void resolve_view(ResolveState& state, PassId pass) {
    const PassDesc& desc = *state.passes[pass].desc;
    const std::vector<std::string>& views = state.input.imports.views;
    if (views.empty() && desc.view.empty()) return;
    std::string view = desc.view.empty() ? "camera" : desc.view;
    const OfferedViews offered = offered_views(state, view);
    if (!desc.view_number.empty()) {
        const double most = std::max(offered.numbered, 1u) - 1.0;
        const std::optional<double> number =
            offered.numbered == 0
                ? 0.0
                : state.number_here(desc.view_number, "the number of view " + quoted(view), 0, most);
        if (!number) {
            state.passes[pass].faulty = true;
            return;
        }
        view += "(" + std::to_string(static_cast<uint32_t>(*number)) + ")";
    }
    if (std::ranges::find(views, view) == views.end()) return report_unknown(state, pass, view, offered);
    state.graph.passes[pass].view = std::move(view);
}

}  // namespace weft
