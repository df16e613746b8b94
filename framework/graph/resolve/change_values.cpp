#include "graph/resolve/change_values.h"

#include <algorithm>

#include "graph/resolve/checks.h"
#include "graph/resolve/fill/member_value.h"

namespace weft {
namespace {

bool is_value(const std::string& param, const std::vector<GraphParam>& params) {
    const auto found = std::ranges::find(params, param, &GraphParam::name);
    return found != params.end() && found->cost <= ParamCost::live;
}

// Returns true if the graph need not be resolved again because of the parameters of `a` that are missing or
// different in `b`. This is true if the cost of a change is at most ParamCost::live for each of these
// parameters.
bool differ_in_values(const std::map<std::string, double>& a, const std::map<std::string, double>& b,
                      const std::vector<GraphParam>& params) {
    return std::ranges::all_of(a, [&](const auto& param) {
        const auto other = b.find(param.first);
        return (other != b.end() && other->second == param.second) || is_value(param.first, params);
    });
}

// Gives the members of a shader's block `Params` their new values. Returns false if a value has an error.
bool change_block(const Declared& declared, const PassDraft& draft, const Evaluator& evaluator,
                  std::vector<ParamWrite>& block) {
    for (ParamWrite& write : block) {
        if (write.builtin != Builtin::none) continue;
        const std::optional<MemberValue> value = member_value(declared, draft, evaluator, write.member);
        // The graph gives this member no value. Example: the size of an image, which stays the same.
        if (!value) continue;
        const std::vector<double>& components = value->components;
        const auto fits = [&](double component) { return fits_member(write.scalar, component); };
        if (components.size() != write.components || !std::ranges::all_of(components, fits)) return false;
        write.value = {};
        std::ranges::copy(components, write.value.begin());
    }
    return true;
}

// Returns the pass of the known graph for each pass of the expansion. A carry pass (it copies content of the
// last frame) is not in the known graph if no pass needs it; its entry in the result is kNoId. Returns
// nullopt if the passes differ otherwise.
std::optional<std::vector<PassId>> find_known(const Expansion& expansion, const ResolvedGraph& known) {
    std::vector<PassId> ids;
    PassId next(0);
    for (const PassDraft& draft : expansion.passes) {
        const bool found = next < known.passes.size() && known.passes[next].name == draft.decl.name;
        if (!found && !draft.decl.carries) return std::nullopt;
        ids.push_back(found ? next : kNoId);
        if (found) ++next;
    }
    if (next != known.passes.size()) return std::nullopt;
    return ids;
}

// If a value has an error, returns nullopt or reports the error. The caller must check both.
std::optional<ResolvedGraph> with_new_values(const ResolveInput& input, const ResolvedGraph& known,
                                             Reporter& reporter) {
    const Values values = evaluate(input, reporter);
    const Shapes shapes = shape_resources(input, values, reporter);
    const Expansion expansion = expand(input, values, shapes, reporter);
    const std::optional<std::vector<PassId>> ids = find_known(expansion, known);
    if (reporter.has_errors() || !ids) return std::nullopt;
    const Declared declared{input, values, shapes, expansion};
    ResolvedGraph graph = known;
    for (size_t i = 0; i < graph.params.size(); ++i) graph.params[i].value = values.params[i].value;
    graph.frames = values.frames;
    for (PassId id(0); id < expansion.passes.size(); ++id) {
        if ((*ids)[id] == kNoId) continue;
        const PassDraft& draft = expansion.passes[id];
        PassDecl& pass = graph.passes[(*ids)[id]];
        pass.flops = draft.decl.flops;
        const Evaluator evaluator = declared.evaluator(id, expansion.suspects, reporter);
        if (!change_block(declared, draft, evaluator, pass.params)) return std::nullopt;
        for (PassVariant& variant : pass.variants)
            if (!change_block(declared, draft, evaluator, variant.params)) return std::nullopt;
    }
    return check_custom_passes(declared, std::move(graph), expansion.suspects, reporter);
}

}  // namespace

bool only_values_differ(const GraphRequest& a, const GraphRequest& b, const std::vector<GraphParam>& params) {
    GraphRequest same = a;
    same.params = b.params;
    return same == b && differ_in_values(a.params, b.params, params) &&
           differ_in_values(b.params, a.params, params);
}

std::optional<ResolvedGraph> change_values(const ResolveInput& input, const ResolvedGraph& known) {
    Diagnostics ignored;
    Reporter reporter(input.graph, input.limits.steps, ignored);
    std::optional<ResolvedGraph> graph;
    try {
        graph = with_new_values(input, known, reporter);
    } catch (const ResolveStopped&) {
        // Nothing to do: the reporter already has the error.
    }
    return reporter.has_errors() ? std::nullopt : std::move(graph);
}

}  // namespace weft
