#include <algorithm>

#include "graph/resolve/checks.h"
#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

// A C++ pass that is being checked, with the objects that its checks need.
struct CustomPass {
    PassId id;
    const PassDraft& draft;
    const Evaluator& evaluator;
    PassReporter& report;

    Diagnostic& error(SourceLoc loc, std::string code, std::string message) const {
        return report.error(id, loc, std::move(code), std::move(message));
    }
};

void report_unknown_params(const CustomPass& pass) {
    const PassDraft& draft = pass.draft;
    std::vector<std::string> known;
    for (const ParamDecl& param : draft.custom->params) known.emplace_back(param.name);
    for (const ParamValueDesc& param : draft.desc->params) {
        if (std::ranges::find(known, param.name) != known.end()) continue;
        Diagnostic& d = pass.error(
            param.loc, "W113",
            "passes of type " + quote(draft.desc->type) + " have no parameter " + quote(param.name));
        const std::string near = did_you_mean_text(param.name, known);
        add_help(d, near.empty() ? (known.empty() ? "remove this parameter"
                                                  : "the parameters of this type are " + quote_all(known))
                                 : near);
    }
}

std::optional<double> evaluate_param(const CustomPass& pass, const ParamValueDesc& param) {
    if (param.components.size() == 1) {
        const std::optional<ExprValue> value = pass.evaluator.value(param.components.front());
        if (!value || !value->is_size) return value ? std::optional(value->x) : std::nullopt;
    }
    Diagnostic& d = pass.error(param.loc, "W113", "parameter " + quote(param.name) + " must be one number");
    add_help(d, "write a number, or use .x or .y of a size");
    return std::nullopt;
}

// Returns the values of all parameters of a C++ pass, sorted by name.
std::vector<NamedValue> evaluate_params(const CustomPass& pass) {
    const PassDraft& draft = pass.draft;
    std::vector<NamedValue> params;
    report_unknown_params(pass);
    for (const ParamDecl& declared : draft.custom->params) {
        double value = declared.default_value;
        const auto param = std::ranges::find(draft.desc->params, declared.name, &ParamValueDesc::name);
        if (param != draft.desc->params.end()) {
            const std::optional<double> number = evaluate_param(pass, *param);
            if (!number) continue;
            value = *number;
        }
        const bool given = param != draft.desc->params.end();
        const bool ranged = given && declared.min < declared.max;
        if (ranged && (value < declared.min || value > declared.max)) {
            Diagnostic& d = pass.error(param->loc, "W113",
                                       "parameter " + quote(declared.name) + " of pass " +
                                           quote(draft.desc->name) + " is out of range");
            add_help(d, "choose a value from " + std::to_string(declared.min) + " to " +
                            std::to_string(declared.max) + " " + std::string(declared.unit));
        }
        params.push_back({std::string(declared.name), value});
    }
    std::ranges::sort(params, {}, &NamedValue::name);
    return params;
}

// Calls the check function of the pass type, and reports its errors at the place of the pass in the graph
// file.
void run_type_check(const CustomPass& pass, const ResolvedGraph& graph, const Suspects& suspects) {
    const PassDraft& draft = pass.draft;
    const PassDecl& decl = graph.passes[pass.id];
    if (suspects.passes[pass.id] || !draft.custom->check) return;
    for (const UseDecl& use : decl.uses) {
        if (suspects.shapes[use.resource]) return;
    }
    const Status status = draft.custom->check(decl, graph);
    if (status) return;
    for (const Diagnostic& found : status.errors()) {
        Diagnostic& d = pass.error(draft.desc->loc, found.code, found.message);
        d.help = found.help;
        d.notes = found.notes;
    }
}

}  // namespace

ResolvedGraph check_custom_passes(const Declared& declared, ResolvedGraph graph, Suspects suspects,
                                  Reporter& reporter) {
    PassReporter report(declared.shapes, declared.expansion, suspects, reporter);
    for (PassId id(0); id < declared.expansion.passes.size(); ++id) {
        const PassDraft& draft = declared.expansion.passes[id];
        if (!draft.custom) continue;
        const Evaluator evaluator = declared.evaluator(id, suspects, reporter);
        const CustomPass pass{id, draft, evaluator, report};
        // When change_values() calls this function, the graph may lack carry passes (the passes that copy
        // content of the last frame). So the ids of its passes may differ from the ids in the expansion.
        graph.passes[find_pass(graph, draft.decl.name)].custom_params = evaluate_params(pass);
        run_type_check(pass, graph, suspects);
    }
    return graph;
}

}  // namespace weft
