// Resources with history become rings of roles, "x" and "x[-1]" and so on, which differ in name and age only.
// References to earlier frames are settled here too.
#include <algorithm>

#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

// Whether any pass has it among its outputs, or something misspelt that may be meant for it.
bool written_by_any_pass(ResolveState& state, const std::string& name) {
    if (const auto known = state.is_written.find(name); known != state.is_written.end()) return known->second;
    const auto names = [&](const PortDesc* port) {
        state.spend(1, port->loc);
        if (port->ref.name == name) return true;
        return state.resource_id(port->ref.name) == kNoId && !did_you_mean(port->ref.name, {name}).empty();
    };
    return state.is_written[name] = std::ranges::any_of(state.input.graph.passes, [&](const auto& entry) {
               return std::ranges::any_of(written_ports(entry.second), names);
           });
}

void report_no_history(ResolveState& state, PassId pass, const RefDesc& ref, const ResourceDecl& resource) {
    const std::string wanted = std::to_string(ref.history);
    const bool kept = resource.lifetime == ResourceLifetime::persistent;
    Diagnostic& d = state.pass_error(
        pass, ref.loc, "W121",
        quoted(ref.text) + " asks for an earlier frame, but " + quoted(ref.name) +
            (resource.history > 0 ? " keeps only " + std::to_string(resource.history) : " keeps no history"));
    if (resource.lifetime == ResourceLifetime::imported) {
        add_help(d, "leave out [-" + wanted + "]: imports have no history. Copy it into a resource with " +
                        "\"history\": " + wanted);
    } else if (kept && resource.history == 0) {
        add_help(d,
                 "a resource with \"keep\" is one copy: read " + quoted(ref.name) + " before it is written");
    } else {
        add_help(d, "add \"history\": " + wanted + " to resource " + quoted(ref.name));
    }
}

}  // namespace

std::string role_name(const std::string& name, uint32_t age) {
    return age == 0 ? name : name + "[-" + std::to_string(age) + "]";
}

void spread_over_rings(ResolveState& state) {
    for (ResourceId id = 0; id < state.resources.size(); ++id) {
        ResourceDecl& role = state.graph.resources[id];
        if (role.age == 0) continue;
        std::string name = std::move(role.name);
        const uint32_t age = role.age;
        const ResourceId ring = role.ring;
        role = state.graph.resources[ring];
        role.name = std::move(name);
        role.age = age;
        state.resources[id].suspect_shape = state.resources[ring].suspect_shape;
    }
}

ResourceId find_role(ResolveState& state, PassId pass, const RefDesc& ref, ResourceId resource,
                     bool is_output) {
    if (ref.history == 0) return resource;
    const ResourceDecl& decl = state.graph.resources[resource];
    const std::string who = "pass " + quoted(state.pass_name(pass));
    if (ref.history > decl.history && state.suspect_histories.contains(ref.name)) return kNoId;
    if (ref.history > decl.history) {
        report_no_history(state, pass, ref, decl);
        return kNoId;
    }
    if (is_output) {
        Diagnostic& d = state.pass_error(
            pass, ref.loc, "W122", who + " writes " + quoted(ref.text) + ", which is of an earlier frame");
        add_help(d, "write " + quoted(ref.name) + ": the next frame finds it as " +
                        quoted(role_name(ref.name, 1)));
        return kNoId;
    }
    if (!ref.pass.empty()) {
        Diagnostic& d = state.pass_error(
            pass, ref.loc, "W122", quoted(ref.text) + " pins a version, but only a frame's last one is kept");
        add_help(d, "write " + quoted(role_name(ref.name, ref.history)) +
                        ", or copy that version into a resource with a history of its own");
        return kNoId;
    }
    if (!written_by_any_pass(state, ref.name)) {
        Diagnostic& d =
            state.pass_error(pass, ref.loc, "W110",
                             who + " reads " + quoted(ref.text) + ", but no pass writes " + quoted(ref.name));
        add_help(d, "write " + quoted(ref.name) + " in the \"out\" of a pass");
        return kNoId;
    }
    return state.resource_id(role_name(ref.name, ref.history));
}

}  // namespace weft
