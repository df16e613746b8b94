#include <algorithm>

#include "graph/resolve/bind/bind_pass.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/views/view_lists.h"

namespace weft {
namespace {

// Reports a list without a number, or a single view with a number.
void report_number(PassBinding& pass, const ViewList& list) {
    const PassDesc& desc = *pass.draft.desc;
    Diagnostic& d = pass.error(desc.view_loc, "W118",
                               "pass " + quote(desc.name) + " uses view " + quote(desc.view) +
                                   ", but there is no view of exactly this name");
    if (list.single)
        return add_help(
            d, "remove the number, because there is only one such view: \"view\": " + quote(desc.view));
    if (list.count == 0) return add_help(d, "the list has no views: add an \"if\" to the pass");
    add_help(d, "add the number of the view, from 0 to " + std::to_string(list.count - 1) + ": \"view\": \"" +
                    desc.view + "(0)\"");
}

}  // namespace

void bind_view(PassBinding& pass) {
    const PassDesc& desc = *pass.draft.desc;
    if (desc.view.empty()) return;
    const ViewList* list = find_view_list(pass.declared.input, pass.declared.values, desc, pass.reporter);
    if (list == nullptr) {
        pass.suspects.passes[pass.id] = 1;
        return;
    }
    const bool all = desc.view_target != ViewTarget::one;
    double number = 0;
    if (!list->single || !all) {
        const bool one_of_many = desc.view_number.empty() && !list->single && list->count != 1;
        const bool numbered_single = !desc.view_number.empty() && list->single;
        if (one_of_many || numbered_single || list->count == 0) return report_number(pass, *list);
        if (!desc.view_number.empty()) {
            const std::optional<double> found =
                pass.evaluator.number(desc.view_number, "the index of view " + quote(desc.view), 0,
                                      std::max(list->count, 1u) - 1.0);
            if (!found) {
                pass.suspects.passes[pass.id] = 1;
                return;
            }
            number = *found;
        }
    }
    pass.bound.view = view_name(*list, static_cast<uint32_t>(number));
    for (uint32_t view = 0; view < pass.draft.views; ++view)
        pass.bound.views.push_back(view_name(*list, view));
}

}  // namespace weft
