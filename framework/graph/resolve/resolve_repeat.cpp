// One description may stand for several passes (`repeat`) or none (`if`).
#include <cmath>
#include <utility>

#include "graph/diagnostics/whole_number.h"
#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

// Nested repeats take some steps for each pass; empty inner ones take steps for none.
constexpr uint64_t kMostStepsPerPass = 16;

class RepeatStep {
 public:
    RepeatStep(ResolveState& state, const PassDesc& desc) : state_(state), desc_(desc) {}

    std::vector<PassInstance> run() {
        state_.names.indices = &indices_;
        const bool good = descend(0);
        state_.names.indices = nullptr;
        state_.repeats_itself = false;
        if (!good) suspect();
        return good ? std::move(found_) : std::vector<PassInstance>{};
    }

 private:
    // False: reported.
    bool descend(size_t level) {
        if (level == desc_.repeat.size()) return add();
        const RepeatDesc& repeat = desc_.repeat[level];
        const std::optional<double> first = whole(repeat.first);
        const std::optional<double> last = whole(repeat.last);
        const std::optional<double> step = repeat.step.empty() ? 1.0 : whole(repeat.step);
        if (!first || !last || !step) return false;
        if (*step == 0) {
            Diagnostic& d = state_.error(repeat.step.loc, "W109",
                                         "the repeat of pass " + quoted(desc_.name) + " stands still");
            add_help(d, "count up without \"by\", or down \"by -1\"");
            return false;
        }
        bool any = false;
        for (double i = *first; *step > 0 ? i <= *last : i >= *last; i += *step) {
            any = true;
            if (++state_.repeat_steps > kMostStepsPerPass * state_.input.limits.passes)
                return over("passes", "passes", state_.input.limits.passes);
            indices_[repeat.index] = i;
            if (!descend(level + 1)) return false;
        }
        indices_.erase(repeat.index);
        if (!any) state_.dropped[desc_.name] = &desc_;
        return true;
    }

    bool add() {
        const GraphLimits& limits = state_.input.limits;
        if (++state_.tried_passes > limits.passes) return over("passes", "passes", limits.passes);
        state_.tried_ports += desc_.in.size() + written_ports(desc_).size();
        if (state_.tried_ports > limits.ports) return over("ports", "ports", limits.ports);
        const std::optional<bool> runs = condition();
        if (!runs) return false;
        state_.repeats_itself = true;
        if (!*runs) {
            state_.dropped[desc_.name] = &desc_;
            return true;
        }
        found_.push_back({name(), indices_});
        return true;
    }

    // Reported once: the first pass too many is as good as any.
    bool over(const char* what, const std::string& limit, uint64_t most) {
        if (std::exchange(state_.over_limit, true)) return false;
        const SourceLoc loc = desc_.repeat.empty() ? desc_.loc : desc_.repeat.front().range_loc;
        Diagnostic& d =
            state_.error(loc, "W125",
                         "with pass " + quoted(desc_.name) + " the graph has more than " +
                             std::to_string(most) + " " + what + ", those counted that \"if\" leaves out");
        add_help(d, "let one dispatch do the work of many: use layers, or the third side of \"groups\"; " +
                        raise_limit_text("graph." + limit));
        return false;
    }

    std::optional<bool> condition() {
        if (desc_.condition.empty()) return true;
        const std::optional<ExprValue> value = state_.evaluate_here(desc_.condition);
        if (!value) return std::nullopt;
        if (!value->is_size) return value->x != 0;
        report_size(desc_.condition);
        return std::nullopt;
    }

    std::optional<double> whole(const Expr& expression) {
        const std::optional<ExprValue> value = state_.evaluate_here(expression);
        if (!value) return std::nullopt;
        if (value->is_size) {
            report_size(expression);
            return std::nullopt;
        }
        if (whole_number<int32_t>(value->x)) return value->x;
        const bool fraction = value->x != std::floor(value->x);
        Diagnostic& d = state_.error(expression.loc, "W109",
                                     quoted(expression.text) + " is " + number_text(value->x) +
                                         ", and a repeat counts in whole numbers" +
                                         (fraction ? "" : " from -2147483648 to 2147483647"));
        add_help(d, fraction ? "round it: floor(…) or ceil(…)"
                             : "count from 0, and compute what you need from the index");
        return std::nullopt;
    }

    void report_size(const Expr& expression) {
        Diagnostic& d = state_.error(expression.loc, "W106",
                                     quoted(expression.text) + " is a size where a number is wanted");
        add_help(d, "use .x or .y of it");
    }

    // "blur#2", of nested ones "blur#2.0": the author's own indices, so that messages can be followed.
    std::string name() const {
        std::string text = desc_.name;
        for (const RepeatDesc& repeat : desc_.repeat) {
            text += text.size() == desc_.name.size() ? "#" : ".";
            text += std::to_string(saturated<int64_t>(indices_.at(repeat.index)));
        }
        return text;
    }

    // Nobody knows whether and where it writes.
    void suspect() {
        state_.faulty_passes.insert(desc_.name);
        for (const PortDesc* port : written_ports(desc_)) {
            const ResourceId id = state_.resource_id(port->ref.name);
            if (id != kNoId) state_.resources[id].suspect_writers = true;
        }
    }

    ResolveState& state_;
    const PassDesc& desc_;
    std::map<std::string, double> indices_;
    std::vector<PassInstance> found_;
};

}  // namespace

std::vector<PassInstance> pass_instances(ResolveState& state, const PassDesc& desc) {
    return RepeatStep(state, desc).run();
}

}  // namespace weft
