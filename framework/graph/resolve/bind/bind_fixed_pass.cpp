// Binds the ports of passes without a shader: clear, copy, blit, readback and C++ passes.
#include <algorithm>

#include "graph/resolve/bind/bind_pass.h"
#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

void report_port_counts(PassBinding& pass, const std::string& wants, const std::string& example) {
    const PassDecl& decl = pass.draft.decl;
    Diagnostic& d = pass.error(decl.loc, "W175", decl.type + " pass " + quote(decl.name) + " needs " + wants);
    add_help(d, example);
}

void check_port_counts(PassBinding& pass) {
    const PassDesc& desc = *pass.draft.desc;
    const size_t ins = desc.in.size();
    const size_t outs = desc.out.size() + (desc.depth ? 1 : 0);
    switch (pass.draft.decl.kind) {
        case PassKind::clear:
            if (ins != 0 || outs == 0) {
                report_port_counts(pass, "outputs and no input", "write for example \"out\": [\"hdr\"]");
            }
            return;
        case PassKind::copy:
        case PassKind::blit:
            if (ins != 1 || outs != 1) {
                report_port_counts(
                    pass, "one input and one output",
                    "write for example \"in\": { \"src\": \"a\" }, \"out\": { \"dst\": \"b\" }");
            }
            return;
        default:
            if (ins != 1 || outs != 0) {
                report_port_counts(pass, "one input and no output", "write for example \"in\": [\"hdr\"]");
            }
    }
}

WriteRank rank_of(const PassDesc& desc, const PortDraft& port, Access access) {
    if (desc.partial || port.pinned()) return WriteRank::in_place;
    return reads(access) ? WriteRank::resumes : WriteRank::fresh;
}

std::vector<std::string> port_names(const PassType& type, bool outputs) {
    std::vector<std::string> names;
    for (const PortDecl& port : type.ports) {
        if (port.is_output == outputs) names.emplace_back(port.name);
    }
    return names;
}

const PortDecl* find_declared(const PassType& type, const UseDecl& use) {
    const auto found = std::ranges::find_if(
        type.ports, [&](const PortDecl& p) { return p.name == use.port && p.is_output == use.is_output; });
    return found == type.ports.end() ? nullptr : &*found;
}

// Returns true if the author has probably misspelt the name of the port `wanted`. In this case, `ports` (the
// ports of the pass in the graph file) contains a port with a similar name that the pass type does not
// declare. An error about that port was already reported.
bool is_misspelt(const PassType& type, const PortDecl& wanted, const std::vector<PortDesc>& ports) {
    const std::vector<std::string> known = port_names(type, wanted.is_output);
    return std::ranges::any_of(ports, [&](const PortDesc& port) {
        return std::ranges::find(known, port.port) == known.end() &&
               !did_you_mean(port.port, {std::string(wanted.name)}).empty();
    });
}

void report_missing_ports(PassBinding& pass) {
    const PassDraft& draft = pass.draft;
    for (const PortDecl& port : draft.custom->ports) {
        const std::vector<PortDesc>& ports = port.is_output ? draft.desc->out : draft.desc->in;
        if (std::ranges::find(ports, port.name, &PortDesc::port) != ports.end()) continue;
        if (is_misspelt(*draft.custom, port, ports)) continue;
        Diagnostic& d = pass.error(draft.desc->loc, "W176",
                                   "pass " + quote(draft.desc->name) + " of type " + quote(draft.desc->type) +
                                       " has no port " + quote(port.name) + ", but needs it");
        add_help(d, add_port_text(port.is_output ? "out" : "in", port.name));
    }
}

}  // namespace

void bind_fixed_ports(PassBinding& pass) {
    check_port_counts(pass);
    const PassDraft& draft = pass.draft;
    const bool blit = draft.decl.kind == PassKind::blit;
    const Access read = blit ? Access::blit_read : Access::copy_read;
    const Access written = draft.decl.kind == PassKind::clear ? Access::clear_write
                           : blit                             ? Access::blit_write
                                                              : Access::copy_write;
    for (size_t i = 0; i < pass.bound.uses.size(); ++i) {
        pass.bound.uses[i].access = pass.bound.uses[i].is_output ? written : read;
        if (pass.bound.uses[i].is_output)
            pass.bound.ports[i].rank = rank_of(*draft.desc, pass.bound.ports[i], written);
    }
    if (draft.desc->clear) pass.bound.clear = pass.evaluator.color(*draft.desc->clear);
}

void bind_custom_ports(PassBinding& pass) {
    const PassDraft& draft = pass.draft;
    for (size_t i = 0; i < pass.bound.uses.size(); ++i) {
        UseDecl& use = pass.bound.uses[i];
        if (const PortDecl* declared = find_declared(*draft.custom, use)) {
            use.access = declared->access;
            if (writes(use.access))
                pass.bound.ports[i].rank = rank_of(*draft.desc, pass.bound.ports[i], use.access);
            continue;
        }
        const std::vector<std::string> names = port_names(*draft.custom, use.is_output);
        Diagnostic& d = pass.error(use.loc, "W176",
                                   "passes of type " + quote(draft.decl.type) + " have no " +
                                       (use.is_output ? "output " : "input ") + quote(use.port));
        add_help(d, did_you_mean_text(use.port, names));
        add_help(d, names.empty() ? "remove this port" : "the ports of this type are " + quote_all(names));
    }
    report_missing_ports(pass);
}

}  // namespace weft
