#include "check/structure/check_groups.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "check/structure/effective_state.h"

namespace weft::check {
namespace {

class GroupCheck {
 public:
    GroupCheck(const FramePlan& plan, const GroupDecl& group, FaultList& faults)
        : plan_(plan), group_(group), faults_(faults) {
        for (Position position(0); position < plan.schedule.order.size(); ++position)
            if (is_member(plan.schedule.order[position])) members_.push_back(position);
    }

    void run() {
        const uint64_t end = uint64_t{group_.first_unit} + group_.rounds;
        if (end > plan_.graph.rest_unit_count) fault("has more rounds than the plan has units for them");
        if (members_.empty()) return;
        check_order();
        for (const Position position : members_) check_step(position);
        if (group_.rounds == 1) return;
        find_part_uses();
        for (const Position position : members_)
            for (const UseDecl& use : pass_at(position).uses)
                if (writes(use.access)) check_write(plan_.barriers.steps[position], use);
    }

 private:
    [[nodiscard]] const PassDecl& pass_at(Position position) const {
        return plan_.graph.passes[plan_.schedule.order[position]];
    }
    [[nodiscard]] bool is_member(PassId pass) const {
        const uint32_t unit = plan_.graph.passes[pass].rest_unit;
        return unit != kNoId && group_.has_unit(unit);
    }

    void fault(const std::string& text) {
        faults_.add(
            "C335", group_.loc, "group \"" + group_.name + "\" " + text,
            "the rounds of a group must be able to run in any order, without other passes between them");
    }

    void check_order() {
        const auto starts = [&](const Batch& batch) {
            return std::ranges::find(batch.positions, members_.front()) != batch.positions.end();
        };
        const auto batch = std::ranges::find_if(plan_.submissions.batches, starts);
        for (size_t i = 1; i < members_.size(); ++i) {
            const Position before = members_[i - 1], position = members_[i];
            if (position != before + 1) return fault("has another pass between its passes");
            if (pass_at(position).rest_unit < pass_at(before).rest_unit)
                return fault("runs passes of one round after the next round has begun");
            if (batch == plan_.submissions.batches.end() ||
                std::ranges::find(batch->positions, position) == batch->positions.end())
                return fault("is divided into several batches");
        }
    }

    void check_step(Position position) {
        const PassStep& step = plan_.barriers.steps[position];
        const auto shared = [](const BarrierDecl& barrier) { return !barrier.if_pass_runs; };
        const bool before = position != members_.front() && std::ranges::any_of(step.barriers, shared);
        const bool after = position != members_.back() && std::ranges::any_of(step.after, shared);
        if (before || after)
            fault("has a barrier at pass " + faults_.pass_name(step.pass) +
                  " that is recorded in every frame. Such a barrier may stand only before the first round or "
                  "after the last round");
    }

    // The accesses of all rounds to one part of a resource that the group writes, and all other reads of the
    // result of the round that ran last. The rounds run in any order. So each write of the part must wait for
    // all of these accesses, and all reads must wait for each write.
    struct PartUse {
        StageMask readers = stage::kNone;
        AccessMask reads = access::kNone;
        // Writes that have no barrier after their pass. So the next write must wait for them.
        StageMask writers = stage::kNone;
        AccessMask writes = access::kNone;
    };

    // One mip of one layer of one aspect of an image, or one piece of a buffer.
    using Part = std::pair<ResourceId, SubresourceRange>;

    template <class Visit>
    static void each_part(const UseDecl& use, Visit visit) {
        const SubresourceRange& r = use.range;
        for (unsigned bit = 1; bit <= r.aspects; bit <<= 1)
            for (uint32_t layer = r.layer; (r.aspects & bit) != 0 && layer < r.layer + r.layers; ++layer)
                for (uint32_t mip = r.mip; mip < r.mip + r.mips; ++mip)
                    visit(Part{use.resource, {mip, 1, layer, 1, static_cast<AspectMask>(bit)}});
    }

    // Returns the barrier on the part that has the mark `if_pass_runs`: it is recorded only in frames in
    // which the round runs. Returns null if the list has no such barrier.
    [[nodiscard]] static const BarrierDecl* find(const std::vector<BarrierDecl>& list, const Part& part) {
        const auto found = std::ranges::find_if(list, [&](const BarrierDecl& barrier) {
            return barrier.if_pass_runs && barrier.resource == part.first &&
                   contains(barrier.range, part.second);
        });
        return found == list.end() ? nullptr : &*found;
    }

    void find_part_uses() {
        for (const Position position : members_)
            for (const UseDecl& use : pass_at(position).uses)
                if (writes(use.access)) add_write(plan_.barriers.steps[position], use);
        const QueueIndex queue = plan_.schedule.queue[members_.front()];
        for (Position position(0); position < plan_.schedule.order.size(); ++position) {
            const bool member = is_member(plan_.schedule.order[position]);
            // Accesses on other queues are ordered by semaphores, so this check ignores them.
            if (plan_.schedule.queue[position] != queue) continue;
            for (const UseDecl& use : pass_at(position).uses)
                if (use.access != Access::none && !writes(use.access) && (member || use.latest))
                    add_read(use);
        }
        if (queue == kGraphicsQueue) add_reads_between();
    }

    // Adds the reads by the program on queue 0 between two frames. Any of the rounds may be the last that ran
    // before these reads.
    void add_reads_between() {
        for (auto& [part, all] : parts_) {
            const std::optional<AccessState>& between = plan_.graph.resources[part.first].between;
            if (!between) continue;
            all.readers |= between->stages;
            all.reads |= between->access;
        }
    }

    void add_write(const PassStep& step, const UseDecl& use) {
        each_part(use, [&](const Part& part) {
            PartUse& all = parts_[part];
            if (find(step.after, part) != nullptr) return;
            all.writers |= state_of(step, use).stages;
            all.writes |= state_of(step, use).access & access::kAllWrites;
        });
    }

    void add_read(const UseDecl& use) {
        each_part(use, [&](const Part& part) {
            const auto found = parts_.find(part);
            if (found == parts_.end()) return;
            found->second.readers |= use.state.stages;
            found->second.reads |= use.state.access;
        });
    }

    // Returns the stages and accesses of a use, together with those of the attachment's load and store
    // operations.
    [[nodiscard]] AccessState state_of(const PassStep& step, const UseDecl& use) const {
        const PassDecl& pass = plan_.graph.passes[step.pass];
        return effective_state(use, ops_of(step, static_cast<uint32_t>(&use - pass.uses.data())));
    }

    // Returns true if this write waits for all accesses of all rounds, and if all readers wait for this
    // write.
    [[nodiscard]] bool is_guarded(const PassStep& step, const UseDecl& use, const Part& part) const {
        const PartUse& all = parts_.at(part);
        const BarrierDecl* before = find(step.barriers, part);
        const BarrierDecl* after = find(step.after, part);
        if (before == nullptr || ((all.readers | all.writers) & ~before->src.stages) != 0 ||
            (all.writes & ~before->src.access) != 0)
            return false;
        const AccessState own = state_of(step, use);
        const AccessMask written = own.access & access::kAllWrites;
        if ((own.stages & ~before->dst.stages) != 0 || (own.access & ~before->dst.access) != 0) return false;
        if (after == nullptr) return all.readers == stage::kNone;
        return (own.stages & ~after->src.stages) == 0 && (written & ~after->src.access) == 0 &&
               (all.readers & ~after->dst.stages) == 0 && (all.reads & ~after->dst.access) == 0 &&
               (after->dst.stages & before->src.stages) != 0;
    }

    void check_write(const PassStep& step, const UseDecl& use) {
        bool guarded = true;
        each_part(use, [&](const Part& part) { guarded = guarded && is_guarded(step, use, part); });
        if (guarded) return;
        fault("writes " + faults_.part_name(use.resource, use.range) + " in pass " +
              faults_.pass_name(step.pass) +
              ". Other rounds access the same part, and the barriers of this pass do not order all of these "
              "accesses before or after the write");
    }

    const FramePlan& plan_;
    const GroupDecl& group_;
    FaultList& faults_;
    std::vector<Position> members_;  // Positions of the passes of the group, in schedule order.
    std::map<Part, PartUse> parts_;  // The parts that the group writes.
};

}  // namespace

void check_groups(const FramePlan& plan, FaultList& faults) {
    for (const GroupDecl& group : plan.graph.groups) GroupCheck(plan, group, faults).run();
    std::vector<uint8_t> by_group(plan.graph.resources.size(), 0);
    for (const PassDecl& pass : plan.graph.passes)
        for (const GroupDecl& group : plan.graph.groups)
            for (const UseDecl& use : pass.uses)
                if (writes(use.access) && pass.rest_unit != kNoId && group.has_unit(pass.rest_unit))
                    by_group[use.resource] = 1;
    for (const PassDecl& pass : plan.graph.passes)
        for (const UseDecl& use : pass.uses)
            if (use.latest && by_group[use.resource] == 0)
                faults.add("C335", use.loc,
                           "pass \"" + pass.name + "\" reads whatever rounds have left in " +
                               faults.resource_name(use.resource) + ", but no group writes this resource",
                           "only what the rounds of a group write may be read in this way");
}

}  // namespace weft::check
