#include "graph/resolve/evaluate.h"

#include <algorithm>
#include <cmath>

#include "graph/diagnostics/quantity_text.h"
#include "graph/parse/expression.h"
#include "graph/resolve/evaluator.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/views/view_lists.h"
#include "graph/syntax/reference_name.h"

namespace weft {
namespace {

std::string allowed_text(const ParamDesc& param) {
    if (param.is_bool) return "set it to true or false (1 or 0)";
    if (!param.allowed.empty()) {
        std::string text;
        for (const double value : param.allowed) text += (text.empty() ? "" : ", ") + number_text(value);
        return "allowed values are " + text;
    }
    return "choose a value from " + number_text((*param.range)[0]) + " to " + number_text((*param.range)[1]);
}

bool allows(const ParamDesc& param, double value) {
    if (!std::isfinite(value)) return false;
    if (param.is_bool) return value == 0.0 || value == 1.0;
    if (!param.allowed.empty()) return std::ranges::find(param.allowed, value) != param.allowed.end();
    return !param.range || (value >= (*param.range)[0] && value <= (*param.range)[1]);
}

// Returns true if the name has the form of a name of a part of the graph. The part may belong to a module:
// "near::radius".
bool is_part_name(const std::string& name) {
    const size_t owner = name.rfind(kInGroup);
    return is_identifier(owner == std::string::npos ? name : name.substr(owner + kInGroup.size()));
}

// Returns a help text if the name is a port of a module, and "with" replaces this port. Else returns an empty
// text.
std::string replaced_port_help(const GraphDesc& graph, const std::string& name) {
    const size_t owner = name.rfind(kInGroup);
    if (owner == std::string::npos) return {};
    const auto module = graph.modules.find(name.substr(0, owner));
    if (module == graph.modules.end()) return {};
    const auto value = module->second.values.find(name.substr(owner + kInGroup.size()));
    if (value == module->second.values.end()) return {};
    const std::string text = "\"with\" replaces this port of the module by " + quote(value->second);
    return graph.params.contains(value->second) ? text + ": set this parameter"
                                                : text + ", which is not a parameter: change it in the graph";
}

void add_unknown_params(const GraphDesc& graph, const std::map<std::string, double>& params,
                        Diagnostics& faults) {
    std::vector<std::string> known;
    for (const auto& [name, unused] : graph.params) known.push_back(name);
    for (const auto& [name, unused] : params) {
        if (graph.params.contains(name)) continue;
        Diagnostic& d =
            faults.emplace_back(graph.sources.error({}, "W120", "the graph has no parameter " + quote(name)));
        const std::string near = did_you_mean_text(name, known);
        if (const std::string replaced = replaced_port_help(graph, name); !replaced.empty()) {
            add_help(d, replaced);
        } else if (!near.empty()) {
            add_help(d, near);
        } else {
            add_help(d, known.empty() ? "this graph has no parameters"
                                      : "the parameters of this graph are " + quote_all(known));
        }
    }
}

double value_of(const std::string& name, const ParamDesc& param,
                const std::map<std::string, double>& params) {
    const auto given = params.find(name);
    return given != params.end() ? given->second : param.default_value;
}

// Checks the scale of a live size: the parameter by which the size is multiplied. Adds a scale without an
// error to `scales`.
void add_scale(const GraphDesc& graph, const SizeScaleDesc& scale, std::set<std::string>& scales,
               Reporter& reporter) {
    const auto refuse = [&](SourceLoc loc, const std::string& message, const std::string& help) {
        add_help(reporter.error(loc, "W236", message), help);
    };
    const auto param = graph.params.find(scale.param);
    if (param == graph.params.end() && !is_part_name(scale.param))
        return refuse(
            scale.loc, "the scale of a size is an expression: " + quote(scale.param),
            "write only the name of a parameter, whose \"range\" gives the possible scales; a constant "
            "factor belongs to the \"size\"");
    if (param == graph.params.end()) {
        std::vector<std::string> known;
        for (const auto& [name, unused] : graph.params) known.push_back(name);
        const std::string near = did_you_mean_text(scale.param, known);
        return refuse(scale.loc, "the scale of a size names no parameter: " + quote(scale.param),
                      near.empty() ? "add the parameter: \"params\": { " + quote(scale.param) +
                                         ": { \"default\": 1, \"range\": [0.5, 1] } }"
                                   : near);
    }
    const auto& range = param->second.range;
    if (range && (*range)[0] > 0 && (*range)[1] <= 1) {
        scales.insert(scale.param);
        return;
    }
    if (param->second.is_bool)
        return refuse(
            param->second.loc,
            "parameter " + quote(scale.param) + " is the scale of a size, but it is true or false",
            "make it a number: { \"default\": 1, \"range\": [0.5, 1] }; a pass with \"switch\" can be "
            "turned on and off");
    refuse(param->second.loc,
           "parameter " + quote(scale.param) + " is the scale of a size, but " +
               (range ? "its range is from " + number_text((*range)[0]) + " to " + number_text((*range)[1])
                      : "it has no range"),
           "add a range above 0 and at most 1, for example \"range\": [0.5, 1]; for larger images, make the "
           "\"size\" larger");
}

// Returns the parameters that are scales of live sizes. A live size is multiplied by its scale.
std::set<std::string> find_scales(const GraphDesc& graph, Reporter& reporter) {
    std::set<std::string> scales, seen;
    for (const auto& [name, scale] : graph.size_scales)
        if (seen.insert(scale.param).second) add_scale(graph, scale, scales, reporter);
    return scales;
}

void add_params(const ResolveInput& input, Values& values, Reporter& reporter) {
    values.scales = find_scales(input.graph, reporter);
    for (Diagnostic& fault : param_faults(input.graph, input.request.params)) reporter.add(std::move(fault));
    for (const auto& [name, param] : input.graph.params) {
        const double value = value_of(name, param, input.request.params);
        values.by_name[name] = number_value(values.scales.contains(name) ? 1 : value);
        if (!allows(param, value)) values.faulty.insert(name);
        values.params.push_back({name, value, ParamCost::nothing});
    }
}

// Evaluates constants and sizes. They may refer to each other in any order, so a name is evaluated when
// another expression first needs it. A chain of such references can be as long as the file, so the chain is
// kept in a list instead of on the call stack.
class NamedEvaluator {
 public:
    // `counts` has the numbers of views of the lists that the graph describes.
    NamedEvaluator(const GraphDesc& graph, const std::map<std::string, Expr>& counts, Values& values,
                   Reporter& reporter)
        : graph_(graph),
          counts_(counts),
          values_(values),
          evaluator_(values, reporter),
          reporter_(reporter) {}

    void evaluate_all() {
        for (const auto& [name, unused] : graph_.consts) evaluate_name(name);
        for (const auto& [name, unused] : graph_.sizes) evaluate_name(name);
        for (const auto& [name, unused] : counts_) evaluate_name(name);
    }

 private:
    // A constant or size that cannot be evaluated yet, because its expression names other constants or sizes.
    struct Waiting {
        const std::string* name;
        const Expr* expression;
        // Index of the next part of the expression to examine.
        size_t next = 0;
    };

    // Returns the expression of a constant, a size or a number of views, or null if the name is none of them.
    const Expr* find(const std::string& name) const {
        const auto constant = graph_.consts.find(name);
        if (constant != graph_.consts.end()) return &constant->second;
        const auto size = graph_.sizes.find(name);
        if (size != graph_.sizes.end()) return &size->second;
        const auto count = counts_.find(name);
        return count != counts_.end() ? &count->second : nullptr;
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

    // Begins to evaluate a name and adds it to the path of waiting names. Returns false if there is nothing
    // to evaluate: the name is not a constant or size, its value is already known, or its definition has an
    // error, for example a cycle.
    bool begin(const std::string& name) {
        const Expr* expression = find(name);
        if (!expression || values_.by_name.contains(name) || is_faulty(name)) return false;
        if (!on_path_.insert(name).second) {
            report_cycle(name, expression->loc);
            return false;
        }
        path_.push_back({&name, expression});
        return true;
    }

    // Begins to evaluate the next name in the expression of the last element of the path. Returns false if
    // the expression has no more names that need evaluation.
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
        if (const auto value = evaluate_number_or_size(name, expression)) {
            values_.by_name[name] = graph_.size_scales.contains(name) ? whole_pixels(*value) : *value;
        } else {
            values_.faulty.insert(name);
        }
    }

    std::optional<ExprValue> evaluate_number_or_size(const std::string& name, const Expr& expression) {
        const std::optional<ExprValue> value = evaluator_.value(expression);
        if (!value || !value->is_size || !graph_.consts.contains(name)) return value;
        Diagnostic& d = reporter_.error(
            expression.loc, "W106",
            "constant " + quote(name) + " is a size (width and height), but must be a number");
        add_help(d, "use .x or .y of the size, or move the constant to \"sizes\"");
        return std::nullopt;
    }

    // Returns the value of a live size at scale 1, rounded in the same way as the sizes of images. A value of
    // 0 or less is returned unchanged, so that the later check of an image with this size reports the error.
    static ExprValue whole_pixels(const ExprValue& size) {
        const auto side = [](double px) { return px > 0 ? std::max(1.0, std::floor(px)) : px; };
        return size_value(side(size.x), side(size.y));
    }

    bool is_faulty(const std::string& name) const { return values_.faulty.contains(name); }

    void report_cycle(const std::string& name, SourceLoc loc) {
        constexpr std::ptrdiff_t kMostNamed = 16;
        const auto first = std::ranges::find_if(path_, [&](const Waiting& w) { return *w.name == name; });
        std::string text;
        for (auto it = first; it != path_.end(); ++it) {
            if (it - first < kMostNamed) text += *it->name + " -> ";
            values_.faulty.insert(*it->name);
        }
        if (path_.end() - first > kMostNamed)
            text += "… " + std::to_string(path_.end() - first - kMostNamed) + " more … -> ";
        Diagnostic& d = reporter_.error(loc, "W106", "sizes depend on each other: " + text + name);
        add_help(d, "define one of these sizes by \"output\" or by numbers");
    }

    const GraphDesc& graph_;
    const std::map<std::string, Expr>& counts_;
    Values& values_;
    Evaluator evaluator_;
    Reporter& reporter_;
    std::vector<Waiting> path_;
    std::set<std::string_view> on_path_;
};

// Adds the number of draws of each imported draw list, for example as "opaqueDraws" for the list "opaque". If
// the author declares the same name, the author's declaration is used instead.
void count_draws(const ResolveInput& input, Values& values) {
    for (const auto& [list, import] : input.graph.imports) {
        if (import.kind != import_kind_name(ImportKind::draw_list)) continue;
        const std::string name = list + "Draws";
        const bool taken = input.graph.sizes.contains(name) || input.graph.consts.contains(name);
        if (taken || values.by_name.contains(name)) continue;
        const auto offered = input.imports.imports.find(list);
        if (offered == input.imports.imports.end())
            // The missing import itself is reported later, by shape_resources().
            values.faulty.insert(name);
        else
            values.by_name[name] = number_value(offered->second.draws);
    }
}

// Adds the number of textures of each table, for example as "materialTexturesCount" for the table
// "materialTextures". If the author declares the same name, the author's declaration is used instead.
void count_textures(const ResolveInput& input, Values& values) {
    const auto add = [&](const std::string& table, double textures) {
        const std::string name = table + "Count";
        const bool taken = input.graph.sizes.contains(name) || input.graph.consts.contains(name);
        if (!taken) values.by_name.try_emplace(name, number_value(textures));
    };
    for (const auto& [name, import] : input.graph.imports) {
        if (import.kind != import_kind_name(ImportKind::textures)) continue;
        const auto offered = input.imports.imports.find(name);
        if (offered == input.imports.imports.end() || offered->second.kind != ImportKind::textures)
            // If the import is missing or has another kind, shape_resources() reports that later.
            values.faulty.insert(name + "Count");
        else
            add(name, offered->second.resource.textures);
    }
    for (const auto& [name, resource] : input.graph.resources)
        if (!resource.textures.empty()) add(name, static_cast<double>(resource.textures.size()));
}

// Adds the numbers that the program offers to expressions, such as the number of lights. If the author
// declares the same name, the author's declaration is used instead.
void add_offered_numbers(const ResolveInput& input, Values& values) {
    for (const auto& [name, number] : input.imports.numbers) {
        const bool taken = input.graph.sizes.contains(name) || input.graph.consts.contains(name);
        if (!taken) values.by_name.try_emplace(name, number_value(number));
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
            param.loc, "W120", what + quote(name) + " cannot be " + finite + number_text(value)));
        const bool limited = param.is_bool || !param.allowed.empty() || param.range;
        add_help(d, limited ? allowed_text(param) : "choose a finite number");
    }
    return faults;
}

Values evaluate(const ResolveInput& input, Reporter& reporter) {
    Values values;
    const Extent3D output = input.request.size;
    values.by_name["output"] = size_value(output.width, output.height);
    add_params(input, values, reporter);
    count_draws(input, values);
    count_textures(input, values);
    add_offered_numbers(input, values);
    const std::map<std::string, Expr> counts = count_views(input, values, reporter);
    NamedEvaluator(input.graph, counts, values, reporter).evaluate_all();
    values.views = list_views(input, values, reporter);
    if (const Expr& frames = input.graph.frames; !frames.empty())
        values.frames = static_cast<uint32_t>(
            Evaluator(values, reporter).number(frames, "\"frames\"", 1, kMaxFrames).value_or(1));
    return values;
}

}  // namespace weft
