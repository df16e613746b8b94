#include <algorithm>
#include <array>
#include <vector>

#include "graph/report/explain_phrases.h"
#include "graph/report/group_phrases.h"
#include "graph/report/plan_phrases.h"
#include "graph/sync/scopes.h"
#include "weft/report/plan_explain.h"

namespace weft {

const char* describe_reason(BarrierReason reason) {
    // Index: BarrierReason.
    constexpr std::array kReasons{"a read after a write",
                                  "a write after a read",
                                  "a write after a write",
                                  "the layout of the image must change",
                                  "memory passes from one resource to another",
                                  "the frame begins to use an import",
                                  "the frame ends its use of an import or an export",
                                  "one queue family releases the image to another",
                                  "one queue family acquires the image from another",
                                  "the resource gets its first-frame value"};
    static_assert(kReasons.size() == static_cast<size_t>(BarrierReason::prologue) + 1);
    return kReasons.at(static_cast<size_t>(reason));
}

std::vector<const UseDecl*> uses_waited_for(const FramePlan& plan, const BarrierDecl& b, PassId pass) {
    std::vector<const UseDecl*> found;
    for (const UseDecl& use : plan.graph.passes[pass].uses) {
        const bool same = use.resource == b.resource && overlaps(use.range, b.range);
        const bool owner =
            std::find(b.aliased_from.begin(), b.aliased_from.end(), use.resource) != b.aliased_from.end();
        if (b.aliased_from.empty() ? same : owner) found.push_back(&use);
    }
    return found;
}

bool waits_for(const FramePlan& plan, const BarrierDecl& b, PassId pass) {
    if (b.from != kNoId) return b.from == pass;
    const std::vector<const UseDecl*> uses = uses_waited_for(plan, b, pass);
    return std::any_of(uses.begin(), uses.end(),
                       [&](const UseDecl* use) { return (use->state.stages & b.src.stages) != 0; });
}

namespace {

class BarrierAnswer {
 public:
    BarrierAnswer(const FramePlan& plan, PassId first, PassId second)
        : plan_(plan),
          first_(first),
          second_(second),
          from_(plan.schedule.position[first]),
          to_(plan.schedule.position[second]) {}

    std::string text() {
        for (const BarrierDecl& b : plan_.barriers.steps[to_].barriers)
            if (waits_for(plan_, b, first_)) add(b, to_, true);
        const GroupBlock before = block_around(plan_, to_), after = block_around(plan_, from_);
        if (!before.empty() && before.first != to_)
            for (const BarrierDecl& b : plan_.barriers.steps[before.first].barriers)
                if (!b.if_pass_runs && waits_for(plan_, b, first_) && used_by_second(b))
                    add(b, before.first, true);
        if (from_ < to_)
            for (const BarrierDecl& b : plan_.barriers.steps[from_].after)
                if (used_by_second(b)) add(b, from_, false);
        if (!after.empty() && after.last != from_ && after.last < to_)
            for (const BarrierDecl& b : plan_.barriers.steps[after.last].after)
                if (!b.if_pass_runs && used_by_second(b) && !uses_waited_for(plan_, b, first_).empty())
                    add(b, after.last, false);
        if (!text_.empty()) return text_;
        return "There is no barrier between " + describe_pass(plan_, first_) + " and " +
               describe_pass(plan_, second_) + ".\n" + why_none();
    }

 private:
    bool used_by_second(const BarrierDecl& b) const {
        const std::vector<UseDecl>& uses = plan_.graph.passes[second_].uses;
        return std::any_of(uses.begin(), uses.end(), [&](const UseDecl& use) {
            return use.resource == b.resource && overlaps(use.range, b.range);
        });
    }

    // Returns true if the passes belong to two rounds of one group.
    bool is_other_round() const {
        return group_of(plan_, first_) != nullptr && group_of(plan_, first_) == group_of(plan_, second_) &&
               plan_.graph.passes[first_].rest_unit != plan_.graph.passes[second_].rest_unit;
    }

    // Appends the explanation of one barrier. It is recorded directly before or after the pass at `position`.
    void add(const BarrierDecl& b, Position position, bool is_before) {
        const bool image = plan_.graph.resources[b.resource].kind == ResourceKind::image;
        const PassId pass = plan_.schedule.order[position];
        const bool moved = position != (is_before ? to_ : from_);
        const bool other_round = is_other_round();
        const char* when = !other_round && (b.from_previous_frame || from_ >= (is_before ? position : to_))
                               ? " of the previous frame"
                               : "";
        text_ +=
            describe_part(plan_, b.resource, b.range) + ": a barrier " +
            (is_before ? "before " + describe_pass(plan_, pass) + " waits for " + describe_pass(plan_, first_)
                       : "right after " + describe_pass(plan_, pass)) +
            when + ".\n  Reason: " + describe_reason(b.reason) + ".\n";
        if (other_round)
            text_ +=
                "  The rounds of a group run in any order: the barrier orders the two passes, whichever of "
                "them "
                "runs first.\n";
        if (moved)
            text_ += std::string("  It stands ") + (is_before ? "before" : "after") +
                     " all rounds of group \"" + group_of(plan_, pass)->name +
                     "\", because any of them may run, in any order.\n";
        for (const UseDecl* use : uses_waited_for(plan_, b, first_))
            text_ += "  first   " + describe_use(plan_, *use) + ".\n";
        for (const UseDecl& use : plan_.graph.passes[second_].uses)
            if (use.resource == b.resource && overlaps(use.range, b.range))
                text_ += "  second  " + describe_use(plan_, use) + ".\n";
        text_ += "  from    " + describe_state(b.src, image) + "\n  to      " + describe_state(b.dst, image) +
                 "\n";
        if (b.if_pass_runs)
            text_ +=
                "  It is recorded only in frames in which the pass, which may rest or wait for its turn, "
                "runs.\n";
        if (b.src_family != b.dst_family)
            text_ += "  from queue family " + std::to_string(b.src_family) + " to " +
                     std::to_string(b.dst_family) + "\n";
    }

    std::string why_none() const {
        std::string text;
        bool shared = false;
        for (const UseDecl& a : plan_.graph.passes[first_].uses)
            for (const UseDecl& b : plan_.graph.passes[second_].uses) {
                if (a.resource != b.resource || !overlaps(a.range, b.range)) continue;
                shared = true;
                text += why_none_on(a, b);
            }
        if (!shared) text = "  They use no common resource, and neither reuses memory of the other.\n";
        if (from_ > to_)
            text += "  The second pass runs first: " + describe_position(plan_, to_) + " comes before " +
                    describe_position(plan_, from_) + ".\n";
        return text;
    }

    // Returns true if all passes from the first pass to the second draw in one rendering scope.
    bool in_one_scope() const {
        PassId pass = second_;
        while (pass != first_ && pass != kNoId) pass = continued_pass(plan_, plan_.schedule.position[pass]);
        return pass == first_;
    }

    std::string why_none_on(const UseDecl& a, const UseDecl& b) const {
        const std::string part = describe_part(plan_, a.resource, a.range);
        if (first_ != second_ && in_one_scope() && writes(a.access) && writes(b.access))
            return "  " + part +
                   ": both passes draw to this resource in one rendering scope, which keeps the order of "
                   "draws.\n";
        if (!writes(a.access) && !writes(b.access) && a.state.layout == b.state.layout)
            return "  " + part + ": both passes only read this resource, in the same layout.\n";
        if (plan_.schedule.queue[from_] != plan_.schedule.queue[to_])
            return "  " + part + ": the passes run on queues " + std::to_string(plan_.schedule.queue[from_]) +
                   " and " + std::to_string(plan_.schedule.queue[to_]) +
                   ", which synchronize with semaphores: see `weft explain FILE wait " +
                   plan_.graph.passes[second_].name + "`.\n";
        for (Position p(from_ + 1); p < to_ && from_ < to_; ++p)
            for (const BarrierDecl& between : plan_.barriers.steps[p].barriers)
                if (between.resource == a.resource && overlaps(between.range, a.range) &&
                    overlaps(between.range, b.range) && waits_for(plan_, between, first_))
                    return "  " + part + ": " + describe_semaphore_path(p, between, b);
        return "  " + part + ": the first pass " + access_verb(a.access) +
               " this resource, the second pass " + access_verb(b.access) +
               " it; the next frame waits for the first pass, or other passes already order "
               "the two.\n";
    }

    // Explains why the second pass needs no barrier of its own: `barrier` has already waited for the first
    // pass. `barrier` is recorded before the pass at `position`, which runs between the two passes. `b` is
    // the use by the second pass.
    std::string describe_semaphore_path(Position position, const BarrierDecl& barrier,
                                        const UseDecl& b) const {
        const PassId through = plan_.schedule.order[position];
        const std::string waited =
            "the barrier before " + describe_pass(plan_, through) + " has already waited for the first pass";
        for (const UseDecl& use : plan_.graph.passes[through].uses)
            if (use.resource == barrier.resource && overlaps(use.range, b.range) && writes(use.access))
                return waited +
                       "; that pass also writes this resource, so the second pass waits for that pass.\n";
        const bool visible = (b.state.stages & ~barrier.dst.stages) == 0 &&
                             (b.state.access & ~barrier.dst.access) == 0 &&
                             b.state.layout == barrier.dst.layout;
        return waited + (visible ? ", and made the content visible to the second pass as well.\n"
                                 : ", and the second pass waits for that pass.\n");
    }

    const FramePlan& plan_;
    PassId first_, second_;
    Position from_, to_;
    std::string text_;
};

}  // namespace

Result<std::string> explain_barrier(const FramePlan& plan, const std::string& first,
                                    const std::string& second) {
    Result<std::pair<PassId, PassId>> found = both(named_pass(plan, first), named_pass(plan, second));
    if (!found) return found.take_errors();
    const auto [a, b] = *found;
    for (const PassId pass : {a, b})
        if (!plan.live.live_passes[pass])
            return "There is no barrier: " + describe_pass(plan, pass) +
                   " is culled: " + plan.live.details[pass] + ".\n";
    return BarrierAnswer(plan, a, b).text();
}

}  // namespace weft
