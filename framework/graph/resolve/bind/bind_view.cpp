#include <algorithm>

#include "graph/resolve/bind/bind_pass.h"
#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

struct OfferedViews {
    // Names of the offered views without their numbers, each name once: "sun" for "sun(0)" and "sun(1)".
    std::vector<std::string> names;
    // Number of offered views that have the requested name and a number, such as "sun(0)" and "sun(1)" for
    // "sun".
    uint32_t numbered = 0;
    bool is_known = false;
};

OfferedViews count_views(const ImportCatalog& imports, const std::string& asked) {
    OfferedViews offered;
    for (const std::string& view : imports.views) {
        const std::string name = view.substr(0, view.find('('));
        if (offered.names.empty() || offered.names.back() != name) offered.names.push_back(name);
        if (name != asked) continue;
        offered.is_known = true;
        offered.numbered += name.size() < view.size() ? 1 : 0;
    }
    return offered;
}

void report_unknown(PassBinding& pass, const std::string& view, const OfferedViews& offered) {
    const PassDesc& desc = *pass.draft.desc;
    Diagnostic& d = pass.error(
        desc.view_loc.line != 0 ? desc.view_loc : desc.loc, "W118",
        "pass " + quote(desc.name) +
            (offered.is_known ? " uses view " + quote(view) + ", but there is no view of exactly this name"
                              : " uses unknown view " + quote(view)));
    if (offered.is_known && offered.numbered > 0)
        return add_help(d, "add the number of the view, from 0 to " + std::to_string(offered.numbered - 1) +
                               ": \"view\": \"" + desc.view + "(0)\"");
    if (offered.is_known)
        return add_help(
            d, "remove the number, because there is only one such view: \"view\": " + quote(desc.view));
    const std::string near = did_you_mean_text(desc.view, offered.names);
    add_help(d, near.empty() ? "the views are " + quote_all(pass.declared.input.imports.views) : near);
}

}  // namespace

void bind_view(PassBinding& pass) {
    const PassDesc& desc = *pass.draft.desc;
    const std::vector<std::string>& views = pass.declared.input.imports.views;
    if (views.empty() && desc.view.empty()) return;
    std::string view = desc.view.empty() ? "camera" : desc.view;
    const OfferedViews offered = count_views(pass.declared.input.imports, view);
    if (!desc.view_number.empty()) {
        const double most = std::max(offered.numbered, 1u) - 1.0;
        const std::optional<double> number =
            offered.numbered == 0
                ? 0.0
                : pass.evaluator.number(desc.view_number, "the index of view " + quote(view), 0, most);
        if (!number) {
            pass.suspects.passes[pass.id] = 1;
            return;
        }
        view += "(" + std::to_string(static_cast<uint32_t>(*number)) + ")";
    }
    if (std::ranges::find(views, view) == views.end()) return report_unknown(pass, view, offered);
    pass.bound.view = std::move(view);
}

}  // namespace weft
