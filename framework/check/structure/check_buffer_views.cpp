#include "check/structure/check_buffer_views.h"

#include <string>

namespace weft::check {
namespace {

// Returns the list of views that contains the view of the pass, if a buffer stores the views of this list.
// Otherwise returns null.
const ViewListDecl* find_buffer_list(const FramePlan& plan, const PassDecl& pass) {
    for (const ViewListDecl& list : plan.graph.views)
        if (list.source == ViewSource::buffer && pass.view.starts_with(list.name + "(")) return &list;
    return nullptr;
}

// Returns true if the use is the buffer element whose number is in the name of the pass's view. Example:
// element 2 for the view "fitted(2)".
bool is_element(const ResourceDecl& buffer, const UseDecl& use, const PassDecl& pass,
                const ViewListDecl& list) {
    if (buffer.name != list.of || buffer.kind != ResourceKind::buffer || !use.bytes) return false;
    const uint64_t stride = buffer.stride_bytes;
    const uint64_t number = stride == 0 ? 0 : use.bytes->offset_bytes / stride;
    return stride > 0 && use.bytes->size_bytes == stride && use.bytes->offset_bytes == number * stride &&
           number < list.count && pass.view == list.name + "(" + std::to_string(number) + ")";
}

bool is_sound(const FramePlan& plan, const PassDecl& pass, const ViewListDecl& list) {
    if (pass.view_use >= pass.uses.size()) return false;
    const UseDecl& use = pass.uses[pass.view_use];
    return is_element(plan.graph.resources[use.resource], use, pass, list) && !use.is_output &&
           (use.state.access & access::kUniformRead) != 0;
}

}  // namespace

void check_buffer_views(const FramePlan& plan, FaultList& faults) {
    for (const PassDecl& pass : plan.graph.passes) {
        // A pass without `view_use` does not read its view.
        if (pass.view_use == kNoId) continue;
        const ViewListDecl* list = find_buffer_list(plan, pass);
        const bool sound = list != nullptr && is_sound(plan, pass, *list) && !pass.culls_draws;
        if (sound) continue;
        faults.add(
            "C347", pass.loc,
            "pass \"" + pass.name + "\" reads view \"" + pass.view +
                "\" from other bytes than those of the view, or leaves out draws although the CPU does "
                "not know the view",
            "this is an error of Weft, not of the graph: please report it");
    }
}

}  // namespace weft::check
