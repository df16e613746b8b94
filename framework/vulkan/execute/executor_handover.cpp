// This file contains the functions by which one executor replaces another, and amend(), which replaces only
// the values and pipelines of a running executor.
#include <algorithm>
#include <cassert>
#include <iterator>

#include "graph/rest/unit_match.h"
#include "vulkan/device/immediate_submit.h"
#include "vulkan/execute/replay_executor.h"
#include "vulkan/execute/transition_record.h"
#include "vulkan/record/clears.h"
#include "weft/compile.h"

namespace weft::vk {
namespace {

ReplayExecutor& executor_of(const Predecessor& predecessor) {
    return static_cast<ReplayExecutor&>(*predecessor.executor);
}

template <class T>
void move_to_front(std::vector<T>& to, std::vector<T> from) {
    to.insert(to.begin(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

bool same_pipelines(const std::vector<DrawPipeline>& a, const std::vector<DrawPipeline>& b) {
    return std::ranges::equal(a, b, [](const DrawPipeline& x, const DrawPipeline& y) {
        return x.pipeline.get() == y.pipeline.get();
    });
}

// Returns true if the two passes run the same code and read the same constants of frame and view.
bool same_pipelines(const PreparedPass& a, const PreparedPass& b) {
    return same_pipelines(a.pipelines, b.pipelines) && a.frame_ranges == b.frame_ranges;
}

// Returns true if the plan keeps its structure with this graph. Only an assertion calls this function.
[[maybe_unused]] bool keeps_structure(const FramePlan& plan, const ResolvedGraph& graph) {
    FramePlan other = plan;
    other.graph = graph;
    return structure_hash(std::move(other)) == structure_hash(plan);
}

}  // namespace

Status ReplayExecutor::take_over(Predecessor predecessor) {
    assert(frames_begun_ == 0 && !predecessor_ && "take_over() comes before the first frame");
    ReplayExecutor& old = executor_of(predecessor);
    assert(old.slot_ == kNoId && "its frame was begun and not run");
    if (Status quiet = old.be_followed(plan()); !quiet) {
        lost_ = quiet.errors();
        return quiet;
    }
    objects_->resources.rings.inherit(old.objects_->resources.rings, old.frames_run_, predecessor.transition);
    for (const ContentCopy& carried : predecessor.transition.carried)
        if (!carried.resample && !carried.shared)
            objects_->areas.inherit(
                objects_->resources.rings.copy(carried.to, 0),
                old.objects_->areas.area_before(old.plan().graph, carried.from, old.objects_->resources.rings,
                                                old.frames_run_));
    rest_.inherit(old.rest_, match_units(old.plan(), plan(), predecessor.transition,
                                         [&](Position old_position, Position position) {
                                             return same_pipelines(old.objects_->passes[old_position],
                                                                   objects_->passes[position]);
                                         }));
    // This executor continues the frame count of `old`, so its first frame uses the next frame slot. The
    // program's data has one copy per slot. A frame of `old` may still read the copy of its slot, so
    // begin_frame() first waits for the frame of `old` in the same slot.
    frames_begun_ = old.frames_begun_;
    predecessor_ = std::move(predecessor);
    return Unit{};
}

Status ReplayExecutor::be_followed(const FramePlan& next) {
    if (!lost_.empty()) return lost_;
    if (frames_run_ == 0) {
        if (Status started = start_without_frame(); !started) return started;
    }
    followed_ = true;
    // If each of the two plans has only one batch per frame, both use the same queue, which runs the old and
    // the new frames in order. Otherwise, the host must wait for the old frames.
    const bool one_queue = plan().submissions.batches.size() <= 1 && next.submissions.batches.size() <= 1;
    return one_queue ? Status(Unit{}) : finish();
}

// Writes the initial contents of this executor's persistent resources. This is needed if this executor is
// replaced before its first frame, because the new executor copies these contents.
Status ReplayExecutor::start_without_frame() {
    Status started = immediate_submit(device_, "writing the initial content of persistent resources",
                                      [&](VkCommandBuffer commands) { record_start(commands); });
    if (!started) return started;
    return retire_predecessor();
}

void ReplayExecutor::record_start(VkCommandBuffer commands) const {
    objects_->dummies.record_layouts(commands);
    if (!predecessor_) return record_prologue(device_, commands, objects_->plan, objects_->resources);
    const ReplayExecutor& old = executor_of(*predecessor_);
    record_transition(device_, commands, predecessor_->transition,
                      {old.objects_->plan, {old.objects_->resources, old.frames_run_}, old.objects_->areas},
                      {objects_->plan, {objects_->resources, 0}, objects_->areas});
}

void ReplayExecutor::inherit_results() {
    move_to_front(timings_, predecessor_->executor->take_timings());
    move_to_front(readbacks_, predecessor_->executor->take_readbacks());
}

// Waits until the replaced executor's frame in frame slot `slot` has finished, because this executor will
// overwrite the copy of the program's data for that slot.
Status ReplayExecutor::complete_predecessor(uint32_t slot) {
    if (!predecessor_) return Unit{};
    Status completed = executor_of(*predecessor_).complete(slot);
    inherit_results();
    if (!completed) lost_ = completed.errors();
    return completed;
}

// Destroys the replaced executor. Call this only after the commands of record_start() have finished, because
// they copy contents from the resources of the replaced executor.
Status ReplayExecutor::retire_predecessor() {
    if (!predecessor_) return Unit{};
    Status finished = predecessor_->executor->finish();
    inherit_results();
    if (!finished) lost_ = finished.errors();
    predecessor_.reset();
    return finished;
}

void ReplayExecutor::amend(std::unique_ptr<Amendment> amendment) {
    assert(slot_ == kNoId && "a frame was begun and not run");
    PlanAmendment& now = static_cast<PlanAmendment&>(*amendment);
    assert(keeps_structure(objects_->plan, now.graph));
    objects_->plan.graph = std::move(now.graph);
    if (now.passes.empty()) return;
    wake_changed(now);
    objects_->pipeline_counts = now.counts;
    Retired& old = retired_.emplace_back();
    for (size_t position = 0; position < now.passes.size(); ++position)
        old.passes.push_back(
            std::exchange(objects_->passes[position].pipelines, std::move(now.passes[position])));
    for (uint32_t slot = 0; slot < kFramesInFlight; ++slot) old.in_flight[slot] = slots_->in_flight(slot);
    drop_retired();
}

// Wakes the rest units whose pipelines the amendment replaces, so that they run in the next frame. A rest
// unit is a set of passes that run together: in each frame, either all of them run or none.
void ReplayExecutor::wake_changed(PlanAmendment& amendment) {
    for (Position position(0); position < amendment.passes.size(); ++position) {
        PreparedPass& prepared = objects_->passes[position];
        prepared.frame_ranges = std::move(amendment.frame_ranges[position]);
        const uint32_t unit = objects_->plan.graph.passes[objects_->plan.schedule.order[position]].rest_unit;
        const bool same = same_pipelines(prepared.pipelines, amendment.passes[position]);
        if (unit != kNoId && !same) rest_.wake(unit);
    }
}

// Destroys the retired pipelines that no frame in flight can use any more. A frame slot whose frame has
// finished needs no retired pipeline.
void ReplayExecutor::drop_retired() {
    for (Retired& old : retired_)
        for (uint32_t slot = 0; slot < kFramesInFlight; ++slot)
            old.in_flight[slot] = old.in_flight[slot] && slots_->in_flight(slot);
    std::erase_if(retired_, [](const Retired& old) {
        return std::ranges::none_of(old.in_flight, [](bool busy) { return busy; });
    });
}

}  // namespace weft::vk
