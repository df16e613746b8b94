// Passes without a shader: clear, copy and readback, whose ports have fixed meanings, and C++ passes, whose
// type declares them.
#include <algorithm>

#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

void report_port_counts(ResolveState& state, PassId pass, const std::string& wants,
                        const std::string& example) {
    const PassDecl& decl = state.graph.passes[pass];
    Diagnostic& d = state.pass_error(pass, decl.loc, "W175",
                                     decl.type + " pass " + quoted(decl.name) + " needs " + wants);
    add_help(d, example);
}

void check_port_counts(ResolveState& state, PassId pass) {
    const PassDesc& desc = *state.passes[pass].desc;
    const size_t ins = desc.in.size();
    const size_t outs = desc.out.size() + (desc.depth ? 1 : 0);
    switch (state.graph.passes[pass].kind) {
        case PassKind::clear:
            if (ins != 0 || outs == 0) {
                report_port_counts(state, pass, "outputs and no input", "for example \"out\": [\"hdr\"]");
            }
            return;
        case PassKind::copy:
            if (ins != 1 || outs != 1) {
                report_port_counts(state, pass, "one input and one output",
                                   "for example \"in\": { \"src\": \"a\" }, \"out\": { \"dst\": \"b\" }");
            }
            return;
        default:
            if (ins != 1 || outs != 0) {
                report_port_counts(state, pass, "one input and no output", "for example \"in\": [\"hdr\"]");
            }
    }
}

WriteRank fixed_rank(const PassDesc& desc, const PortWork& port, Access access) {
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

// One of the ports is called nearly so and is none of the type's: that was reported.
bool is_misspelt(const PassType& type, const PortDecl& wanted, const std::vector<PortDesc>& ports) {
    const std::vector<std::string> known = port_names(type, wanted.is_output);
    return std::ranges::any_of(ports, [&](const PortDesc& port) {
        return std::ranges::find(known, port.port) == known.end() &&
               !did_you_mean(port.port, {std::string(wanted.name)}).empty();
    });
}

void report_missing_ports(ResolveState& state, PassId pass) {
    const PassWork& work = state.passes[pass];
    for (const PortDecl& port : work.custom->ports) {
        const std::vector<PortDesc>& ports = port.is_output ? work.desc->out : work.desc->in;
        if (std::ranges::find(ports, port.name, &PortDesc::port) != ports.end()) continue;
        if (is_misspelt(*work.custom, port, ports)) continue;
        Diagnostic& d =
            state.pass_error(pass, work.desc->loc, "W176",
                             "pass " + quoted(work.desc->name) + " of type " + quoted(work.desc->type) +
                                 " lacks its port " + quoted(port.name));
        add_help(d, "add it to " + quoted(port.is_output ? "out" : "in") + ": { " + quoted(port.name) +
                        ": \"resource\" }");
    }
}

}  // namespace

void bind_fixed_pass(ResolveState& state, PassId pass) {
    check_port_counts(state, pass);
    PassWork& work = state.passes[pass];
    PassDecl& decl = state.graph.passes[pass];
    const bool blit = decl.type == "blit";
    const Access read = blit ? Access::blit_read : Access::copy_read;
    const Access written = decl.kind == PassKind::clear ? Access::clear_write
                           : blit                       ? Access::blit_write
                                                        : Access::copy_write;
    for (size_t i = 0; i < decl.uses.size(); ++i) {
        decl.uses[i].access = decl.uses[i].is_output ? written : read;
        if (decl.uses[i].is_output) work.ports[i].rank = fixed_rank(*work.desc, work.ports[i], written);
    }
    if (work.desc->clear) decl.clear = state.color_here(*work.desc->clear);
}

void bind_custom_pass(ResolveState& state, PassId pass) {
    PassWork& work = state.passes[pass];
    PassDecl& decl = state.graph.passes[pass];
    for (size_t i = 0; i < decl.uses.size(); ++i) {
        UseDecl& use = decl.uses[i];
        if (const PortDecl* declared = find_declared(*work.custom, use)) {
            use.access = declared->access;
            if (writes(use.access)) work.ports[i].rank = fixed_rank(*work.desc, work.ports[i], use.access);
            continue;
        }
        const std::vector<std::string> names = port_names(*work.custom, use.is_output);
        Diagnostic& d = state.pass_error(pass, use.loc, "W176",
                                         "passes of type " + quoted(decl.type) + " have no " +
                                             (use.is_output ? "output " : "input ") + quoted(use.port));
        add_help(d, did_you_mean_text(use.port, names));
        add_help(d, names.empty() ? "they have none" : "they have " + joined(names));
    }
    report_missing_ports(state, pass);
}

}  // namespace weft
