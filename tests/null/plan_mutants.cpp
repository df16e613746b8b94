#include "tests/null/plan_mutants.h"

#include <vector>

namespace weft::test {
namespace {

using BarrierList = std::vector<BarrierDecl>;

class Mutator {
 public:
    Mutator(const FramePlan& plan, const std::function<void(const Mutant&)>& visit)
        : plan_(plan), visit_(visit), mutant_{MutantKind::removed_barrier, {}, plan} {}

    void run() {
        BarrierPlan& barriers = mutant_.plan.barriers;
        for (PassStep& step : barriers.steps) {
            const std::string& pass = plan_.graph.passes[step.pass].name;
            mutate(step.barriers, "before " + pass);
            mutate(step.after, "after " + pass);
            if (!step.merges_render_pass) continue;
            step.merges_render_pass = false;
            show(MutantKind::parted_scope, pass + " begins a scope of its own");
            step.merges_render_pass = true;
        }
        mutate(barriers.epilogue, "at the end");
        weakened_ = MutantKind::weakened_prologue;
        mutate(barriers.prologue.before, "before the prologue");
        mutate(barriers.prologue.after, "after the prologue");
        for (Batch& batch : mutant_.plan.submissions.batches) drop_waits(batch);
        for (const GroupDecl& group : plan_.graph.groups) move_shared(group);
    }

 private:
    void show(MutantKind kind, std::string text) {
        mutant_.kind = kind;
        mutant_.text = std::move(text);
        visit_(mutant_);
    }

    void mutate(BarrierList& list, const std::string& where) {
        const BarrierList sound = list;
        for (size_t i = 0; i < sound.size(); ++i) {
            const std::string what = where + " on " + plan_.graph.resources[sound[i].resource].name +
                                     range_text(plan_.graph.resources[sound[i].resource], sound[i].range);
            list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
            const bool transfer = sound[i].src_family != sound[i].dst_family;
            show(transfer ? MutantKind::removed_transfer : MutantKind::removed_barrier, "no barrier " + what);
            list = sound;
            weaken(
                list[i].src.stages, [](StageMask m) { return stages_text(m); }, "source of " + what);
            weaken(
                list[i].src.access, [](AccessMask m) { return access_text(m); }, "source of " + what);
            weaken(
                list[i].dst.stages, [](StageMask m) { return stages_text(m); }, "destination of " + what);
            weaken(
                list[i].dst.access, [](AccessMask m) { return access_text(m); }, "destination of " + what);
            narrow(list[i].range.layers, "no barrier for the last layer or piece " + what);
            narrow(list[i].range.mips, "no barrier for the last mip " + what);
            drop_owners(list[i], what);
            if (sound[i].reason == BarrierReason::prologue) continue;
            list[i].if_pass_runs = !list[i].if_pass_runs;
            show(MutantKind::other_frames, "recorded in other frames: " + what);
            list[i].if_pass_runs = sound[i].if_pass_runs;
        }
    }

    void move_shared(const GroupDecl& group) {
        std::vector<Position> places;
        for (Position position(0); position < plan_.schedule.order.size(); ++position) {
            const uint32_t unit = plan_.graph.passes[plan_.schedule.order[position]].rest_unit;
            if (unit != kNoId && group.has_unit(unit)) places.push_back(position);
        }
        if (places.size() < 2) return;
        std::vector<PassStep>& steps = mutant_.plan.barriers.steps;
        move_each(steps[places[0]].barriers, steps[places[1]].barriers, "before the rounds of " + group.name);
        move_each(steps[places.back()].after, steps[places[places.size() - 2]].after,
                  "after the rounds of " + group.name);
    }

    void move_each(BarrierList& from, BarrierList& to, const std::string& where) {
        const BarrierList sound_from = from, sound_to = to;
        for (size_t i = 0; i < sound_from.size(); ++i) {
            if (sound_from[i].if_pass_runs) continue;
            to.push_back(sound_from[i]);
            from.erase(from.begin() + static_cast<std::ptrdiff_t>(i));
            show(MutantKind::moved_barrier, "a barrier on " +
                                                plan_.graph.resources[sound_from[i].resource].name +
                                                " is no longer " + where);
            from = sound_from;
            to = sound_to;
        }
    }

    void narrow(uint32_t& count, const std::string& what) {
        if (count < 2) return;
        --count;
        show(MutantKind::narrowed_barrier, what);
        ++count;
    }

    template <class Text>
    void weaken(uint32_t& mask, Text text, const std::string& what) {
        const uint32_t sound = mask;
        for (uint32_t left = sound; left != 0; left &= left - 1) {
            const uint32_t bit = left & (~left + 1);
            mask = sound & ~bit;
            show(weakened_, "no " + text(bit) + " in the " + what);
        }
        mask = sound;
    }

    void drop_owners(BarrierDecl& barrier, const std::string& what) {
        const std::vector<ResourceId> sound = barrier.aliased_from;
        for (size_t i = 0; i < sound.size(); ++i) {
            barrier.aliased_from.erase(barrier.aliased_from.begin() + static_cast<std::ptrdiff_t>(i));
            show(MutantKind::removed_owner,
                 plan_.graph.resources[sound[i]].name + " not waited for by the alias transition " + what);
            barrier.aliased_from = sound;
        }
    }

    void drop_waits(Batch& batch) {
        const std::vector<QueueWait> sound = batch.waits;
        for (size_t i = 0; i < sound.size(); ++i) {
            batch.waits.erase(batch.waits.begin() + static_cast<std::ptrdiff_t>(i));
            show(MutantKind::removed_wait, "no wait for batch " + std::to_string(sound[i].batch) +
                                               (sound[i].previous_frame ? " of the frame before" : ""));
            batch.waits = sound;
        }
    }

    const FramePlan& plan_;
    const std::function<void(const Mutant&)>& visit_;
    Mutant mutant_;
    MutantKind weakened_ = MutantKind::weakened_barrier;
};

}  // namespace

void for_each_mutant(const FramePlan& plan, const std::function<void(const Mutant&)>& visit) {
    Mutator(plan, visit).run();
}

}  // namespace weft::test
