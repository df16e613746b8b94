#include "check/structure/check_rest_units.h"

#include <algorithm>
#include <string>
#include <vector>

namespace weft::check {
namespace {

// One mip of one layer of one aspect of an image, or one piece of a buffer.
struct Part {
    uint32_t unit = kNoId;  // The rest unit that writes the part.
    // True if several rounds of one group (copies of its passes) write the part. Then the part has content
    // only while a round runs.
    bool shared = false;
    PassId last = kNoId;  // The last live pass of the schedule that writes the part.
    bool home_known = false;
    Layout home = Layout::undefined;  // The layout of the part before and after the steps of its unit.
};

// The parts of one resource. Empty if no rest unit (set of passes that rest together) writes the resource.
class Parts {
 public:
    void create(const ResourceDecl& resource) {
        whole_ = resource.whole();
        parts_.resize(size_t{whole_.mips} * whole_.layers * kAspects);
    }
    [[nodiscard]] bool empty() const { return parts_.empty(); }
    template <class Visit>
    void each(const SubresourceRange& range, Visit visit) {
        if (parts_.empty()) return;
        for (size_t a = 0; a < kAspects; ++a) {
            // If the resource has no aspects, its parts count as parts of the first aspect.
            if (a == 0 ? whole_.aspects != 0 && !(range.aspects & 1u) : !(range.aspects & (1u << a)))
                continue;
            for (uint32_t l = range.layer; l < std::min(range.layer + range.layers, whole_.layers); ++l)
                for (uint32_t m = range.mip; m < std::min(range.mip + range.mips, whole_.mips); ++m)
                    visit(parts_[(a * whole_.layers + l) * whole_.mips + m]);
        }
    }

 private:
    static constexpr size_t kAspects = 3;
    SubresourceRange whole_;
    std::vector<Part> parts_;
};

class RestCheck {
 public:
    RestCheck(const FramePlan& plan, FaultList& faults)
        : plan_(plan), faults_(faults), parts_(plan.graph.resources.size()) {}

    void run() {
        for (PassId id(0); id < plan_.graph.passes.size(); ++id)
            if (unit_of(id) != kNoId) check_pass(id);
        for (PassId id(0); id < plan_.graph.passes.size(); ++id) check_writes(id);
        for (const PassId id : plan_.schedule.order) note_last(id);
        for (const PassId id : plan_.schedule.order) check_reads(id);
        for (const BoundaryState& state : plan_.boundary) note_home(state);
        for (const PassStep& step : plan_.barriers.steps) check_step(step);
        for (const BarrierDecl& barrier : plan_.barriers.epilogue) check_outside(barrier, kNoId);
    }

 private:
    [[nodiscard]] uint32_t unit_of(PassId pass) const { return plan_.graph.passes[pass].rest_unit; }
    [[nodiscard]] const GroupDecl* group_of(uint32_t unit) const { return find_group(plan_.graph, unit); }
    // Returns true if the result of the pass must not depend on its own earlier result.
    [[nodiscard]] bool is_pure(PassId pass) const {
        const GroupDecl* group = group_of(unit_of(pass));
        return group == nullptr || group->rests;
    }
    // Returns true if a port of the pass declares that the pass reads its own earlier result.
    [[nodiscard]] bool declares_own_content(PassId pass, const UseDecl& read) const {
        return std::ranges::any_of(plan_.graph.passes[pass].uses, [&](const UseDecl& use) {
            return !use.wakes && use.resource == read.resource && overlaps(use.range, read.range);
        });
    }

    void fault(const char* code, PassId pass, SourceLoc loc, const std::string& text, const char* help) {
        faults_.add(code, loc, "pass " + faults_.pass_name(pass) + " " + text, help);
    }

    void check_pass(PassId id) {
        const PassDecl& pass = plan_.graph.passes[id];
        const bool known = pass.rest_unit < plan_.graph.rest_unit_count;
        if (!known || pass.frame_slices != 0 || pass.side_effect || pass.kind == PassKind::readback ||
            pass.kind == PassKind::custom)
            fault("C333", id, pass.loc, "cannot rest",
                  "only a pass without effects outside the graph may rest");
        for (const UseDecl& use : pass.uses) {
            if (!writes(use.access)) continue;
            const ResourceDecl& resource = plan_.graph.resources[use.resource];
            if (parts_[use.resource].empty()) parts_[use.resource].create(resource);
            const GroupDecl* group = group_of(pass.rest_unit);
            parts_[use.resource].each(use.range, [&](Part& part) {
                const bool other = part.unit != kNoId && part.unit != pass.rest_unit;
                part.shared |= other && group != nullptr && group->has_unit(part.unit);
                part.unit = pass.rest_unit;
            });
            if (!keeps_content(use.resource))
                fault("C333", id, use.loc,
                      "rests in some frames and writes " + faults_.resource_name(use.resource) +
                          ", but this resource loses its content between frames",
                      "a resource that a rest unit writes must keep its content and its memory");
        }
    }

    // Returns true if the resource keeps its content and its memory between frames. A transient resource does
    // so if it is alive during the whole frame, because then no other resource uses its memory. The result is
    // also true if the resource is not live.
    [[nodiscard]] bool keeps_content(ResourceId id) const {
        const ResourceDecl& resource = plan_.graph.resources[id];
        if (resource.lifetime == ResourceLifetime::persistent) return resource.history == 0;
        if (resource.lifetime == ResourceLifetime::imported) return false;
        if (!plan_.live.live_resources[id]) return true;
        const LifetimeSpan& span = plan_.lifetimes.spans[id];
        return span.first == 0 && span.last + 1u >= plan_.schedule.order.size();
    }

    // Returns true if the pass is in the group whose rounds share the part.
    [[nodiscard]] bool is_shared_with(const Part& part, PassId pass) const {
        return part.shared && unit_of(pass) != kNoId && group_of(part.unit)->has_unit(unit_of(pass));
    }

    void check_writes(PassId id) {
        for (const UseDecl& use : plan_.graph.passes[id].uses) {
            if (!writes(use.access)) continue;
            bool shared = false;
            parts_[use.resource].each(use.range, [&](const Part& part) {
                shared |= part.unit != kNoId && part.unit != unit_of(id) && !is_shared_with(part, id);
            });
            if (shared)
                fault("C333", id, use.loc,
                      "writes " + faults_.part_name(use.resource, use.range) +
                          ", but a rest unit without this pass writes it, too",
                      "all writers of a part must belong to one rest unit");
        }
    }

    void note_last(PassId id) {
        for (const UseDecl& use : plan_.graph.passes[id].uses)
            if (writes(use.access)) parts_[use.resource].each(use.range, [&](Part& part) { part.last = id; });
    }

    void check_reads(PassId id) {
        for (const UseDecl& use : plan_.graph.passes[id].uses)
            for (const VersionSource& source : use.sources) {
                bool own = false, middle = false, lost = false;
                const bool pure = is_pure(id) && !declares_own_content(id, use);
                parts_[use.resource].each(source.range, [&](const Part& part) {
                    if (part.unit == kNoId) return;
                    lost |= part.shared && !is_shared_with(part, id) && !use.latest;
                    if (is_shared_with(part, id)) {
                        own |= source.producer == kNoId || unit_of(source.producer) != unit_of(id);
                        return;
                    }
                    const bool together = part.unit == unit_of(id);
                    own |= together && source.producer == kNoId && pure;
                    middle |= !together && source.producer != kNoId && source.producer != part.last;
                });
                const std::string what = faults_.part_name(use.resource, source.range);
                if (own)
                    fault("C333", id, use.loc, "rests, but needs the earlier content of " + what,
                          "the result of a rest unit must not depend on its own earlier result");
                if (lost)
                    fault("C333", id, use.loc,
                          "reads " + what + ", whose content depends on the order of the rounds of a group",
                          "a part that several rounds write may be read only by these rounds");
                if (middle)
                    fault("C333", id, use.loc,
                          "reads a version of " + what + " that does not exist while the rest unit rests",
                          "a pass outside the unit must read the unit's last version");
            }
    }

    void note_home(const BoundaryState& state) {
        parts_[state.resource].each(state.range, [&](Part& part) {
            part.home = state.state.layout;
            part.home_known = true;
        });
    }

    // A barrier outside the steps of rest units, or a barrier that is recorded in every frame, must not name
    // a part that a rest unit writes. Reports each barrier that breaks this rule.
    void check_outside(const BarrierDecl& barrier, PassId before) {
        bool touches = barrier.if_pass_runs;
        parts_[barrier.resource].each(barrier.range,
                                      [&](const Part& part) { touches |= part.unit != kNoId; });
        if (touches)
            report_barrier(barrier, before, "also in frames in which the unit that writes this part rests");
    }

    void report_barrier(const BarrierDecl& barrier, PassId before, const std::string& when) {
        faults_.add(
            "C334", plan_.graph.resources[barrier.resource].loc,
            "the barrier on " + faults_.part_name(barrier.resource, barrier.range) + " at pass " +
                (before == kNoId ? "(end of frame)" : faults_.pass_name(before)) + " is recorded " + when,
            "a barrier on a part that a rest unit writes must belong to a step of that unit, and only "
            "such a barrier may depend on whether the pass runs");
    }

    void check_step(const PassStep& step) {
        for (const std::vector<BarrierDecl>* list : {&step.barriers, &step.after})
            for (const BarrierDecl& barrier : *list) {
                if (!barrier.if_pass_runs) {
                    check_outside(barrier, step.pass);
                    continue;
                }
                bool own = unit_of(step.pass) != kNoId && !parts_[barrier.resource].empty() &&
                           barrier.src_family == barrier.dst_family && !step.merges_render_pass;
                parts_[barrier.resource].each(barrier.range, [&](const Part& part) {
                    own &= part.unit == unit_of(step.pass) || is_shared_with(part, step.pass);
                });
                if (!own) report_barrier(barrier, step.pass, "only in frames in which that pass runs");
            }
        if (unit_of(step.pass) == kNoId) return;
        for (const UseDecl& use : plan_.graph.passes[step.pass].uses)
            if (writes(use.access) && plan_.graph.resources[use.resource].kind == ResourceKind::image)
                check_home(step, use);
    }

    // After the step, each part that the pass writes must be in the home layout of this part (Part::home).
    // Reports the parts that are not.
    void check_home(const PassStep& step, const UseDecl& use) {
        Layout left = use.state.layout;
        for (const BarrierDecl& barrier : step.after)
            if (barrier.resource == use.resource && overlaps(barrier.range, use.range))
                left = barrier.dst.layout;
        bool wrong = false;
        parts_[use.resource].each(use.range, [&](Part& part) {
            if (!part.home_known) part.home = left;
            part.home_known = true;
            wrong |= part.home != left;
        });
        if (wrong)
            fault("C334", step.pass, use.loc,
                  "leaves " + faults_.part_name(use.resource, use.range) + " in layout " + layout_text(left) +
                      ", which is not its layout while the rest unit rests",
                  "the last barrier of the step must change the layout back");
    }

    const FramePlan& plan_;
    FaultList& faults_;
    std::vector<Parts> parts_;  // Index: ResourceId.
};

}  // namespace

void check_rest_units(const FramePlan& plan, FaultList& faults) {
    const auto rests = [](const PassDecl& pass) { return pass.rest_unit != kNoId; };
    const auto depends = [](const BarrierDecl& barrier) { return barrier.if_pass_runs; };
    const bool any =
        std::ranges::any_of(plan.graph.passes, rests) ||
        std::ranges::any_of(plan.barriers.epilogue, depends) ||
        std::ranges::any_of(plan.barriers.steps, [&](const PassStep& step) {
            return std::ranges::any_of(step.barriers, depends) || std::ranges::any_of(step.after, depends);
        });
    if (any) RestCheck(plan, faults).run();
}

}  // namespace weft::check
