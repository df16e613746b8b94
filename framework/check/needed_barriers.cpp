#include "check/needed_barriers.h"

#include <utility>
#include <vector>

#include "weft/check/check_plan.h"

namespace weft {
namespace {

// Returns how many of `barriers` are necessary. `barriers` must be a list inside `plan`. The function removes
// one barrier at a time, checks the plan, and restores the barrier.
uint32_t needed_of(const FramePlan& plan, std::vector<BarrierDecl>& barriers) {
    uint32_t needed = 0;
    for (size_t i = 0; i < barriers.size(); ++i) {
        const auto at = barriers.begin() + static_cast<std::ptrdiff_t>(i);
        BarrierDecl without = std::move(*at);
        barriers.erase(at);
        if (has_errors(check_plan(plan))) ++needed;
        barriers.insert(barriers.begin() + static_cast<std::ptrdiff_t>(i), std::move(without));
    }
    return needed;
}

}  // namespace

std::optional<uint32_t> count_needed_barriers(FramePlan plan, uint64_t most_work) {
    if (uint64_t{plan.barriers.emitted} * plan.barriers.steps.size() > most_work) return std::nullopt;
    uint32_t needed = needed_of(plan, plan.barriers.epilogue);
    for (PassStep& step : plan.barriers.steps)
        needed += needed_of(plan, step.barriers) + needed_of(plan, step.after);
    return needed;
}

}  // namespace weft
