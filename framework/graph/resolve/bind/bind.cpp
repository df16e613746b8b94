#include "graph/resolve/bind.h"

#include <algorithm>

#include "graph/resolve/bind/bind_pass.h"
#include "graph/resolve/bind/bind_references.h"
#include "graph/resolve/bind/check_array.h"
#include "graph/resolve/bind/check_table.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"

namespace weft {
namespace {

// Checks that each optional port has a boolean specialisation constant HAS_<port> in the shader. Without this
// constant the shader cannot know that the port is absent.
void check_optional_ports(PassBinding& pass) {
    const PassDraft& draft = pass.draft;
    for (const PortDesc& port : draft.desc->in) {
        if (!port.optional) continue;
        const std::string constant = "HAS_" + port.port;
        const bool known =
            draft.shader && std::ranges::any_of(draft.shader->spec_constants, [&](const auto& c) {
                return c.type == ScalarType::boolean && c.name == constant;
            });
        if (known || (has_shader(draft.decl.kind) && !draft.shader)) continue;
        const std::string who =
            draft.shader
                ? "shader " + quote(draft.desc->shader) + " does not declare the constant " + constant
                : draft.decl.type + " passes have no shader that could test for the port";
        Diagnostic& d = pass.error(port.loc, "W168",
                                   "port " + quote(port.port) + " of pass " + quote(draft.decl.name) +
                                       " cannot be optional: " + who);
        add_help(d, draft.shader
                        ? "declare the constant: layout(constant_id = 0) const bool " + constant + " = false;"
                        : "add \"else\" to the port");
    }
}

void bind_pass(PassBinding& pass) {
    const PassKind kind = pass.draft.decl.kind;
    if (kind == PassKind::raster) bind_draws(pass);
    check_optional_ports(pass);
    if (has_shader(kind)) {
        if (!pass.draft.shader) return;
        bind_shader_ports(pass);
        check_shader_fit(pass);
        check_image_count(pass);
        check_table_support(pass);
        bind_constants(pass);
        return;
    }
    for (size_t i = 0; i < pass.bound.uses.size(); ++i)
        if (pass.bound.uses[i].each != EachPart::none)
            report_no_array(pass, pass.bound.uses[i], pass.bound.ports[i]);
    if (kind == PassKind::custom) {
        if (pass.draft.custom) bind_custom_ports(pass);
    } else {
        bind_fixed_ports(pass);
    }
    refuse_tables(pass);
}

void suspect_outputs(PassId id, const BoundPass& pass, Suspects& suspects) {
    if (!suspects.passes[id]) return;
    for (const UseDecl& use : pass.uses) {
        if (use.is_output) suspects.writers[use.resource] = 1;
    }
}

}  // namespace

PassBinding pass_binding(const Declared& declared, PassId id, BoundPasses& bound, PassReporter& report,
                         Reporter& reporter) {
    return {.declared = declared,
            .id = id,
            .draft = declared.expansion.passes[id],
            .evaluator = declared.evaluator(id, bound.suspects, reporter),
            .bound = bound.passes[id],
            .suspects = bound.suspects,
            .report = report,
            .reporter = reporter};
}

BoundPasses bind(const Declared& declared, Reporter& reporter) {
    BoundPasses bound = bind_references(declared, reporter);
    PassReporter report(declared.shapes, declared.expansion, bound.suspects, reporter);
    for (PassId id(0); id < bound.passes.size(); ++id) {
        PassBinding pass = pass_binding(declared, id, bound, report, reporter);
        bind_pass(pass);
    }
    for (PassId id(0); id < bound.passes.size(); ++id) suspect_outputs(id, bound.passes[id], bound.suspects);
    return bound;
}

}  // namespace weft
