// Parameters of C++ passes and their own checks.
#include <algorithm>

#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

void report_unknown_params(ResolveState& state, PassId pass) {
    const PassWork& work = state.passes[pass];
    std::vector<std::string> known;
    for (const ParamDecl& param : work.custom->params) known.emplace_back(param.name);
    for (const ParamValueDesc& param : work.desc->params) {
        if (std::ranges::find(known, param.name) != known.end()) continue;
        Diagnostic& d = state.pass_error(
            pass, param.loc, "W113",
            "passes of type " + quoted(work.desc->type) + " have no parameter " + quoted(param.name));
        const std::string near = did_you_mean_text(param.name, known);
        add_help(d, near.empty() ? (known.empty() ? "they have none" : "they have " + joined(known)) : near);
    }
}

std::optional<double> given_value(ResolveState& state, PassId pass, const ParamValueDesc& param) {
    if (param.components.size() == 1) {
        const std::optional<ExprValue> value = state.evaluate_here(param.components.front());
        if (!value || !value->is_size) return value ? std::optional(value->x) : std::nullopt;
    }
    Diagnostic& d =
        state.pass_error(pass, param.loc, "W113", "parameter " + quoted(param.name) + " must be one number");
    add_help(d, "use .x or .y of a size");
    return std::nullopt;
}

void resolve_custom_params(ResolveState& state, PassId pass) {
    const PassWork& work = state.passes[pass];
    report_unknown_params(state, pass);
    for (const ParamDecl& declared : work.custom->params) {
        double value = declared.default_value;
        const auto param = std::ranges::find(work.desc->params, declared.name, &ParamValueDesc::name);
        if (param != work.desc->params.end()) {
            const std::optional<double> number = given_value(state, pass, *param);
            if (!number) continue;
            value = *number;
        }
        const bool given = param != work.desc->params.end();
        const bool ranged = given && declared.min < declared.max;
        if (ranged && (value < declared.min || value > declared.max)) {
            Diagnostic& d = state.pass_error(pass, param->loc, "W113",
                                             "parameter " + quoted(declared.name) + " of pass " +
                                                 quoted(work.desc->name) + " is out of range");
            add_help(d, "its range is " + std::to_string(declared.min) + " to " +
                            std::to_string(declared.max) + " " + std::string(declared.unit));
        }
        state.graph.passes[pass].custom_params.push_back({std::string(declared.name), value});
    }
    std::ranges::sort(state.graph.passes[pass].custom_params, {}, &NamedValue::name);
}

// What the pass type finds is shown at the pass.
void run_type_check(ResolveState& state, PassId pass) {
    const PassWork& work = state.passes[pass];
    if (work.faulty || !work.custom->check) return;
    for (const UseDecl& use : state.graph.passes[pass].uses) {
        if (state.resources[use.resource].suspect_shape) return;
    }
    const Status status = work.custom->check(state.graph.passes[pass], state.graph);
    if (status) return;
    for (const Diagnostic& found : status.errors()) {
        Diagnostic& d = state.pass_error(pass, work.desc->loc, found.code, found.message);
        d.help = found.help;
        d.notes = found.notes;
    }
}

}  // namespace

void check_custom_passes(ResolveState& state) {
    for (PassId pass = 0; pass < state.passes.size(); ++pass) {
        const IndexScope scope(state, pass);
        if (!state.passes[pass].custom) continue;
        resolve_custom_params(state, pass);
        run_type_check(state, pass);
    }
}

}  // namespace weft
