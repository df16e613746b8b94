#include "graph/resolve/expand/expand_repeat.h"

#include <cmath>
#include <utility>

#include "graph/diagnostics/quantity_text.h"
#include "graph/diagnostics/whole_number.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"
#include "graph/resolve/views/view_lists.h"

namespace weft {
namespace {

// Limits the loop iterations of all repeats, as a multiple of the limit graph.passes. Nested repeats need
// several iterations for each pass, and with an empty inner repeat there are iterations but no passes.
constexpr uint64_t kMostStepsPerPass = 16;

class PassRepeater {
 public:
    PassRepeater(const ResolveInput& input, const Values& values, const Evaluator& evaluator,
                 const Shapes& shapes, const PassDesc& desc, bool unites_views, RepeatCounts& counts,
                 Expansion& expansion, Reporter& reporter)
        : input_(input),
          values_(values),
          evaluator_(evaluator),
          shapes_(shapes),
          desc_(desc),
          unites_views_(unites_views),
          counts_(counts),
          expansion_(expansion),
          reporter_(reporter) {}

    std::vector<PassInstance> run() {
        if (descend(0)) return std::move(found_);
        suspect();
        return {};
    }

 private:
    Evaluator evaluator() const { return evaluator_.in_repeat(indices_, is_later_); }

    // Runs the loop of the repeat at `level`, and inside it the loops of the deeper levels. Returns false
    // after reporting an error.
    bool descend(size_t level) {
        if (level == desc_.repeat.size()) return add();
        const RepeatDesc& repeat = desc_.repeat[level];
        const std::optional<double> first = whole(repeat.first);
        const bool views = desc_.view_target != ViewTarget::one && repeat.index == kViewIndex;
        const std::optional<double> last = views ? last_view() : whole(repeat.last);
        const std::optional<double> step = repeat.step.empty() ? 1.0 : whole(repeat.step);
        if (!first || !last || !step) return false;
        if (*step == 0) {
            Diagnostic& d = reporter_.error(
                repeat.step.loc, "W109",
                "the repeat of pass " + quote(desc_.name) + " has a step of 0, so it would never end");
            add_help(d, "remove \"by\" to count up, or write \"by -1\" to count down");
            return false;
        }
        bool any = false;
        for (double i = *first; *step > 0 ? i <= *last : i >= *last; i += *step) {
            any = true;
            if (++counts_.steps > kMostStepsPerPass * input_.limits.passes)
                return over("passes", "passes", input_.limits.passes);
            indices_[repeat.index] = i;
            if (!descend(level + 1)) return false;
        }
        indices_.erase(repeat.index);
        if (!any) expansion_.dropped[desc_.name] = &desc_;
        return true;
    }

    // Returns the number of the last view of a pass with "views"; -1 if the list is empty. If one pass draws
    // all views, returns 0, because the repeat then has only one pass.
    std::optional<double> last_view() {
        if (unites_views_) return 0;
        const ViewList* list = find_view_list(input_, values_, desc_, reporter_);
        return list != nullptr ? std::optional(list->count - 1.0) : std::nullopt;
    }

    bool add() {
        const GraphLimits& limits = input_.limits;
        if (++counts_.passes > limits.passes) return over("passes", "passes", limits.passes);
        expansion_.tried_ports += desc_.in.size() + written_ports(desc_).size();
        if (expansion_.tried_ports > limits.ports) return over("ports", "ports", limits.ports);
        const std::optional<bool> runs = condition();
        if (!runs) return false;
        is_later_ = true;
        if (!*runs) {
            expansion_.dropped[desc_.name] = &desc_;
            return true;
        }
        found_.push_back({name(), indices_});
        return true;
    }

    // Reports that the graph has too many passes or ports, but only for the first pass that exceeds a limit.
    // `limit` is the name of the limit after "graph.", and `most` its value. Returns false.
    bool over(const char* what, const std::string& limit, uint64_t most) {
        if (std::exchange(expansion_.too_large, true)) return false;
        const SourceLoc loc = desc_.repeat.empty() ? desc_.loc : desc_.repeat.front().range_loc;
        Diagnostic& d = reporter_.error(loc, "W125",
                                        "with pass " + quote(desc_.name) + " the graph has more than " +
                                            std::to_string(most) + " " + what +
                                            "; this number includes passes that \"if\" removes");
        add_help(d, "use a shorter range in \"repeat\", replace many dispatches by one with more groups, " +
                        raise_limit_text("graph." + limit));
        return false;
    }

    std::optional<bool> condition() {
        if (desc_.condition.empty()) return true;
        const std::optional<ExprValue> value = evaluator().value(desc_.condition);
        if (!value) return std::nullopt;
        if (!value->is_size) return value->x != 0;
        report_size(desc_.condition);
        return std::nullopt;
    }

    std::optional<double> whole(const Expr& expression) {
        const std::optional<ExprValue> value = evaluator().value(expression);
        if (!value) return std::nullopt;
        if (value->is_size) {
            report_size(expression);
            return std::nullopt;
        }
        if (whole_number<int32_t>(value->x)) return value->x;
        const bool fraction = value->x != std::floor(value->x);
        Diagnostic& d = reporter_.error(expression.loc, "W109",
                                        quote(expression.text) + " is " + number_text(value->x) +
                                            ", but a repeat needs whole numbers" +
                                            (fraction ? "" : " from -2147483648 to 2147483647"));
        add_help(d, fraction ? "round the value with floor(…) or ceil(…)"
                             : "count from 0, and compute the other number from the index");
        return std::nullopt;
    }

    void report_size(const Expr& expression) {
        Diagnostic& d = reporter_.error(expression.loc, "W106",
                                        quote(expression.text) + " is a size, but must be a number");
        add_help(d, "use .x or .y of the size");
    }

    // Returns the name of one pass of a repeat, made of the author's name and the values of the indices:
    // "blur#2", or "blur#2.0" for two nested repeats. A pass that draws all views keeps the author's name,
    // because it has no other repeat.
    std::string name() const {
        std::string text = desc_.name;
        if (unites_views_) return text;
        for (const RepeatDesc& repeat : desc_.repeat) {
            text += text.size() == desc_.name.size() ? "#" : ".";
            text += std::to_string(saturated<int64_t>(indices_.at(repeat.index)));
        }
        return text;
    }

    // Marks the pass as suspect after an error: it is unknown whether the pass runs and what it writes, so
    // later stages report no consequences.
    void suspect() {
        expansion_.faulty.insert(desc_.name);
        for (const PortDesc* port : written_ports(desc_)) {
            const ResourceId id = resource_id(shapes_.resources, port->ref.name);
            if (id != kNoId) expansion_.suspects.writers[id] = 1;
        }
    }

    const ResolveInput& input_;
    const Values& values_;
    const Evaluator& evaluator_;
    const Shapes& shapes_;
    const PassDesc& desc_;
    bool unites_views_;
    RepeatCounts& counts_;
    Expansion& expansion_;
    Reporter& reporter_;
    std::map<std::string, double> indices_;
    // True after the first pass of the repeat. Errors found again in later passes are not reported again.
    bool is_later_ = false;
    std::vector<PassInstance> found_;
};

}  // namespace

std::vector<PassInstance> repeat_pass(const ResolveInput& input, const Values& values,
                                      const Evaluator& evaluator, const Shapes& shapes, const PassDesc& desc,
                                      bool unites_views, RepeatCounts& counts, Expansion& expansion,
                                      Reporter& reporter) {
    return PassRepeater(input, values, evaluator, shapes, desc, unites_views, counts, expansion, reporter)
        .run();
}

}  // namespace weft
