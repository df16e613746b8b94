#include "graph/resolve/bind/find_role.h"

#include <algorithm>

#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"
#include "graph/resolve/rings.h"

namespace weft {

// Returns true if any pass, even a removed one, writes the resource `name`. Also returns true if a pass
// writes an unknown resource with a similar name, because that is probably a misspelling of `name`.
bool RoleFinder::written_by_any_pass(const std::string& name) {
    if (const auto known = is_written_.find(name); known != is_written_.end()) return known->second;
    const auto names = [&](const PortDesc* port) {
        reporter_.spend(1, port->loc);
        if (port->ref.name == name) return true;
        return resource_id(declared_.shapes.resources, port->ref.name) == kNoId &&
               !did_you_mean(port->ref.name, {name}).empty();
    };
    return is_written_[name] = std::ranges::any_of(declared_.input.graph.passes, [&](const auto& entry) {
               return std::ranges::any_of(written_ports(entry.second), names);
           });
}

void RoleFinder::report_no_history(PassId pass, const RefDesc& ref, const ResourceDecl& resource) {
    const std::string wanted = std::to_string(ref.history);
    const bool kept = resource.lifetime == ResourceLifetime::persistent;
    Diagnostic& d = report_.error(
        pass, ref.loc, "W121",
        quote(ref.text) + " reads an earlier frame, but " + quote(ref.name) +
            (resource.history > 0 ? " keeps only " + std::to_string(resource.history) + " of them"
                                  : " has no history"));
    if (resource.lifetime == ResourceLifetime::imported) {
        add_help(d, "remove [-" + wanted +
                        "], because imports have no history; or copy the import to a resource with " +
                        "\"history\": " + wanted);
    } else if (kept && resource.history == 0) {
        add_help(d, "read " + quote(ref.name) +
                        " before a pass writes it, to get the old content: a resource with \"keep\" has one "
                        "copy, and new content replaces the old content");
    } else {
        add_help(d, "add \"history\": " + wanted + " to resource " + quote(ref.name));
    }
}

ResourceId RoleFinder::find(PassId pass, const RefDesc& ref, ResourceId resource, bool is_output) {
    if (ref.history == 0) return resource;
    const ResourceDecl& decl = declared_.shapes.resources[resource];
    const std::string who = "pass " + quote(declared_.pass_name(pass));
    if (ref.history > decl.history && declared_.shapes.suspect_histories.contains(ref.name)) return kNoId;
    if (ref.history > decl.history) {
        report_no_history(pass, ref, decl);
        return kNoId;
    }
    if (is_output) {
        Diagnostic& d =
            report_.error(pass, ref.loc, "W122",
                          who + " writes " + quote(ref.text) + ", but a pass cannot write an earlier frame");
        add_help(d, "write " + quote(ref.name) + ": the next frame reads this content as " +
                        quote(role_name(ref.name, 1)));
        return kNoId;
    }
    if (!ref.pass.empty()) {
        Diagnostic& d = report_.error(
            pass, ref.loc, "W122",
            quote(ref.text) + " names a pass with @, but only the last version of an earlier frame is kept");
        add_help(d, "read " + quote(role_name(ref.name, ref.history)) +
                        " without @ and the name of a pass, or copy this version to another resource that "
                        "has a history");
        return kNoId;
    }
    const bool keeps = declared_.shapes.origins[resource].desc->keep != KeepMode::none;
    if (!keeps && !written_by_any_pass(ref.name)) {
        Diagnostic& d =
            report_.error(pass, ref.loc, "W110",
                          who + " reads " + quote(ref.text) + ", but no pass writes " + quote(ref.name));
        add_help(d, "add " + quote(ref.name) + " to \"out\" of a pass");
        return kNoId;
    }
    return resource_id(declared_.shapes.resources, role_name(ref.name, ref.history));
}

}  // namespace weft
