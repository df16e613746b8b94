// Parameters, constants and sizes become the names that every later expression may use.
#include <algorithm>
#include <cmath>

#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

std::string allowed_text(const ParamDesc& param) {
    if (param.is_bool) return "it is true or false (1 or 0)";
    if (!param.allowed.empty()) {
        std::string text;
        for (const double value : param.allowed) text += (text.empty() ? "" : ", ") + number_text(value);
        return "allowed are " + text;
    }
    return "its range is " + number_text((*param.range)[0]) + " to " + number_text((*param.range)[1]);
}

bool allows(const ParamDesc& param, double value) {
    if (!std::isfinite(value)) return false;
    if (param.is_bool) return value == 0.0 || value == 1.0;
    if (!param.allowed.empty()) return std::ranges::find(param.allowed, value) != param.allowed.end();
    return !param.range || (value >= (*param.range)[0] && value <= (*param.range)[1]);
}

void add_unknown_params(const GraphDesc& graph, const std::map<std::string, double>& params,
                        Diagnostics& faults) {
    std::vector<std::string> known;
    for (const auto& [name, unused] : graph.params) known.push_back(name);
    for (const auto& [name, unused] : params) {
        if (graph.params.contains(name)) continue;
        Diagnostic& d = faults.emplace_back(
            graph.sources.error({}, "W120", "the graph has no parameter " + quoted(name)));
        const std::string near = did_you_mean_text(name, known);
        if (!near.empty()) {
            add_help(d, near);
        } else {
            add_help(d,
                     known.empty() ? "this graph has no parameters" : "its parameters are " + joined(known));
        }
    }
}

double value_of(const std::string& name, const ParamDesc& param,
                const std::map<std::string, double>& params) {
    const auto given = params.find(name);
    return given != params.end() ? given->second : param.default_value;
}

void resolve_params(ResolveState& state) {
    for (Diagnostic& fault : param_faults(state.input.graph, state.input.params))
        state.add_error(std::move(fault));
    for (const auto& [name, param] : state.input.graph.params) {
        const double value = value_of(name, param, state.input.params);
        state.names.values[name] = number_value(value);
        if (!allows(param, value)) state.faulty_values.insert(name);
        state.graph.params.push_back({name, value, ParamCost::nothing});
    }
}

// Constants and sizes may refer to each other in any order, so each is evaluated when the first one asks for
// it. A chain of them may be as long as the file: it is followed without recursion.
class NamedEvaluator {
 public:
    explicit NamedEvaluator(ResolveState& state) : state_(state) {}

    void evaluate_all() {
        const GraphDesc& graph = state_.input.graph;
        for (const auto& [name, unused] : graph.consts) evaluate_name(name);
        for (const auto& [name, unused] : graph.sizes) evaluate_name(name);
    }

 private:
    // One that waits for the names in its expression.
    struct Waiting {
        const std::string* name;
        const Expr* expression;
        size_t next = 0;  // the part of the expression to look at
    };

    // Null: it is neither a constant nor a size.
    const Expr* find(const std::string& name) const {
        const GraphDesc& graph = state_.input.graph;
        const auto constant = graph.consts.find(name);
        if (constant != graph.consts.end()) return &constant->second;
        const auto size = graph.sizes.find(name);
        return size != graph.sizes.end() ? &size->second : nullptr;
    }

    void evaluate_name(const std::string& name) {
        begin(name);
        while (!path_.empty()) {
            if (begin_next()) continue;
            const Waiting ready = path_.back();
            path_.pop_back();
            on_path_.erase(*ready.name);
            finish(*ready.name, *ready.expression);
        }
    }

    // False: its value is known or never will be.
    bool begin(const std::string& name) {
        const Expr* expression = find(name);
        if (!expression || state_.names.values.contains(name) || is_faulty(name)) return false;
        if (!on_path_.insert(name).second) {
            report_cycle(name, expression->loc);
            return false;
        }
        path_.push_back({&name, expression});
        return true;
    }

    // Begins with the next name that the last one of the path waits for; false: there is none.
    bool begin_next() {
        const std::vector<ExprNode>& parts = path_.back().expression->postfix;
        while (path_.back().next < parts.size()) {
            const ExprNode& part = parts[path_.back().next++];
            if (part.op == ExprOp::name && begin(part.name)) return true;
        }
        return false;
    }

    void finish(const std::string& name, const Expr& expression) {
        if (is_faulty(name)) return;
        if (const auto value = evaluated(name, expression)) {
            state_.names.values[name] = *value;
        } else {
            state_.faulty_values.insert(name);
        }
    }

    std::optional<ExprValue> evaluated(const std::string& name, const Expr& expression) {
        const std::optional<ExprValue> value = state_.evaluate_here(expression);
        if (!value || !value->is_size || !state_.input.graph.consts.contains(name)) return value;
        Diagnostic& d =
            state_.error(expression.loc, "W106", "constant " + quoted(name) + " is a size, not a number");
        add_help(d, "use .x or .y of it, or declare it in \"sizes\"");
        return std::nullopt;
    }

    bool is_faulty(const std::string& name) const { return state_.faulty_values.contains(name); }

    void report_cycle(const std::string& name, SourceLoc loc) {
        constexpr std::ptrdiff_t kMostNamed = 16;
        const auto first = std::ranges::find_if(path_, [&](const Waiting& w) { return *w.name == name; });
        std::string text;
        for (auto it = first; it != path_.end(); ++it) {
            if (it - first < kMostNamed) text += *it->name + " -> ";
            state_.faulty_values.insert(*it->name);
        }
        if (path_.end() - first > kMostNamed)
            text += "… " + std::to_string(path_.end() - first - kMostNamed) + " more … -> ";
        Diagnostic& d = state_.error(loc, "W106", "sizes depend on each other: " + text + name);
        add_help(d, "write one of them in terms of \"output\" or of numbers");
    }

    ResolveState& state_;
    std::vector<Waiting> path_;
    std::set<std::string_view> on_path_;
};

// How long the imported draw lists are: "opaqueDraws". What the author calls so comes first.
void count_draws(ResolveState& state) {
    for (const auto& [list, import] : state.input.graph.imports) {
        if (import.kind != import_kind_name(ImportKind::draw_list)) continue;
        const std::string name = list + "Draws";
        const bool taken = state.input.graph.sizes.contains(name) || state.input.graph.consts.contains(name);
        if (taken || state.names.values.contains(name)) continue;
        const auto offered = state.input.imports.imports.find(list);
        if (offered == state.input.imports.imports.end())
            state.faulty_values.insert(name);  // the import is reported
        else
            state.names.values[name] = number_value(offered->second.draws);
    }
}

// What the catalogue counts for expressions. What the author calls so comes first.
void add_offered_numbers(ResolveState& state) {
    for (const auto& [name, number] : state.input.imports.numbers) {
        const bool taken = state.input.graph.sizes.contains(name) || state.input.graph.consts.contains(name);
        if (!taken) state.names.values.try_emplace(name, number_value(number));
    }
}

}  // namespace

Diagnostics param_faults(const GraphDesc& graph, const std::map<std::string, double>& params) {
    Diagnostics faults;
    add_unknown_params(graph, params, faults);
    for (const auto& [name, param] : graph.params) {
        const double value = value_of(name, param, params);
        if (allows(param, value)) continue;
        const std::string what = params.contains(name) ? "parameter " : "the default of parameter ";
        const std::string finite = std::isfinite(value) ? "" : "not a finite number: ";
        Diagnostic& d = faults.emplace_back(graph.sources.error(
            param.loc, "W120", what + quoted(name) + " can't be " + finite + number_text(value)));
        const bool limited = param.is_bool || !param.allowed.empty() || param.range;
        add_help(d, limited ? allowed_text(param) : "any finite number will do");
    }
    return faults;
}

void resolve_values(ResolveState& state) {
    const Extent3D output = state.input.output_extent;
    state.names.values["output"] = size_value(output.width, output.height);
    resolve_params(state);
    count_draws(state);
    add_offered_numbers(state);
    NamedEvaluator(state).evaluate_all();
    if (const Expr& frames = state.input.graph.frames; !frames.empty())
        state.graph.frames =
            static_cast<uint32_t>(state.number_here(frames, "\"frames\"", 1, kMaxFrames).value_or(1));
}

}  // namespace weft
