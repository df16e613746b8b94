#include "check/faults/fault_list.h"

#include <algorithm>

namespace weft::check {

void FaultList::add(const char* code, SourceLoc loc, const std::string& message, const std::string& help) {
    if (!seen_.insert(code + message).second) return;
    Diagnostic fault = plan_.graph.sources.error(loc, code, message);
    fault.help = {help};
    faults_.push_back(std::move(fault));
}

bool FaultList::any(const char* code) const {
    return std::any_of(faults_.begin(), faults_.end(), [&](const Diagnostic& d) { return d.code == code; });
}

std::string FaultList::pass_name(PassId pass) const {
    return pass < plan_.graph.passes.size() ? "\"" + plan_.graph.passes[pass].name + "\""
                                            : "outside the graph";
}

std::string FaultList::resource_name(ResourceId resource) const {
    return resource < plan_.graph.resources.size() ? "\"" + plan_.graph.resources[resource].name + "\"" : "?";
}

std::string FaultList::part_name(ResourceId resource, const SubresourceRange& range) const {
    const bool known = resource < plan_.graph.resources.size();
    return resource_name(resource) + (known ? range_text(plan_.graph.resources[resource], range) : "");
}

std::string FaultList::actor_text(const Actor& actor, uint32_t current_frame) const {
    std::string text =
        actor.pass == kNoId ? "the program outside the graph" : "pass " + pass_name(actor.pass);
    if (actor.transition) text = "the layout transition before " + text;
    if (actor.frame != current_frame) text += " of the previous frame";
    return text;
}

}  // namespace weft::check
