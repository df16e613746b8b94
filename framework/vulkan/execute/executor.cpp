#include "vulkan/execute/replay_executor.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <numeric>

#include "graph/rest/needed_by_units.h"
#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/execute/pass_lists.h"
#include "vulkan/execute/program_submit.h"
#include "vulkan/execute/unit_input.h"
#include "vulkan/record/barriers_vk.h"
#include "vulkan/record/record.h"

namespace weft::vk {
namespace {

// Maximum number of frame timings that wait until the program reads them; older ones are dropped. Without
// this limit, a program that never reads them would use more and more memory.
constexpr size_t kMostTimings = 32;

class Stopwatch {
 public:
    [[nodiscard]] double ms() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

 private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Returns the switches (parameters that turn passes on or off) that are on in this frame.
Combination switches_in(const ResolvedGraph& graph, const FrameInput& frame) {
    Combination on = switches_of(graph);
    for (uint32_t i = 0; frame.switches != nullptr && i < graph.switches.size(); ++i) {
        const auto given = frame.switches->find(graph.switches[i].param);
        if (given == frame.switches->end()) continue;
        on = given->second ? on | 1u << i : on & ~(1u << i);
    }
    return on;
}

// Returns true if `wait`, the result of waiting for a frame, means that the objects of the frame can be
// destroyed. A lost device runs nothing any more, so it counts as finished.
bool is_finished(VkResult wait) {
    return wait == VK_SUCCESS || wait == VK_ERROR_DEVICE_LOST;
}

// Returns a text for the message that a frame did not finish. The text names the ticket of the frame, a value
// of a timeline semaphore. It is empty if the frame has no ticket.
std::string ticket_text(const FrameTicket& ticket) {
    if (ticket.timeline == VK_NULL_HANDLE) return {};
    return " in the command buffer of the program, with the ticket " + std::to_string(ticket.value);
}

void begin_label(const Device& device, VkCommandBuffer commands, const std::string& name) {
    VkDebugUtilsLabelEXT label{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
    label.pLabelName = name.c_str();
    if (device.instance_fn().vkCmdBeginDebugUtilsLabelEXT != nullptr)
        device.instance_fn().vkCmdBeginDebugUtilsLabelEXT(commands, &label);
}

void end_label(const Device& device, VkCommandBuffer commands) {
    if (device.instance_fn().vkCmdEndDebugUtilsLabelEXT != nullptr)
        device.instance_fn().vkCmdEndDebugUtilsLabelEXT(commands);
}

}  // namespace

ReplayExecutor::~ReplayExecutor() {
    bool idle = true;
    for (uint32_t slot = 0; slot < kFramesInFlight; ++slot)
        // After a time-out, the destructor does not wait a second time. It only checks whether the late frame
        // has finished in the meantime.
        idle &= timed_out_ ? slots_->is_over(slot) : is_finished(slots_->wait(slot));
    if (!idle)
        device_.abandon();
    else if (!followed_)
        slots_->let_go();
}

Diagnostic ReplayExecutor::lost_frame(uint32_t slot, VkResult result) {
    const size_t pass_count = objects_->plan.schedule.order.size();
    uint32_t first = objects_->timer.first_unfinished(slot);
    if (first >= pass_count) first = 0;
    Diagnostic diagnostic = failed_call("V418",
                                        "waiting for frame " + std::to_string(in_flight_[slot].frame_index) +
                                            ticket_text(slots_->ticket(slot)) +
                                            " (unfinished passes: " + pass_names(objects_->plan, first) + ")",
                                        result);
    if (slots_->ticket(slot).timeline != VK_NULL_HANDLE && result == VK_TIMEOUT)
        diagnostic.help.insert(diagnostic.help.begin(),
                               "submit the command buffer of the frame, and let the submission signal the "
                               "timeline semaphore of the ticket");
    if (diagnostic.help.empty())
        diagnostic.help.push_back("look for an endless loop in the first unfinished pass");
    if (const std::string counts = draw_counts(objects_->plan, objects_->draws, first); !counts.empty())
        diagnostic.help.push_back(
            "or draw fewer objects; the unfinished passes draw these numbers of objects: " + counts);
    lost_ = {diagnostic};
    device_.log(lost_);
    timed_out_ = true;
    return diagnostic;
}

PassTiming ReplayExecutor::pass_timing(Position position, double gpu_ms, const InFlight& frame) const {
    const PassDecl& pass = objects_->plan.graph.passes[objects_->plan.schedule.order[position]];
    PassTiming timing{.pass = pass.name, .gpu_ms = gpu_ms};
    timing.switched_off = !has_combination(pass.runs_in, frame.switches);
    if (!frame.draws_left_out.empty()) {
        const std::span<const uint32_t> all(frame.draws_left_out);
        const std::span<const uint32_t> of_pass =
            all.subspan(first_view_[position], first_view_[position + 1] - first_view_[position]);
        timing.draws_left_out = std::accumulate(of_pass.begin(), of_pass.end(), 0u);
        if (of_pass.size() > 1) timing.view_draws_left_out.assign(of_pass.begin(), of_pass.end());
    }
    if (pass.rest_unit == kNoId || frame.wakes.empty()) return timing;
    const Wake& wake = frame.wakes[pass.rest_unit];
    timing.rested = !wake.runs();
    timing.woken_by = wake_text(objects_->plan, wake);
    return timing;
}

Status ReplayExecutor::complete(uint32_t slot) {
    if (!lost_.empty()) return lost_;
    if (!slots_->in_flight(slot)) return Unit{};
    const VkResult result = slots_->wait(slot);
    if (result != VK_SUCCESS) return lost_frame(slot, result);
    if (Status retired = retire_predecessor(); !retired) return retired;
    drop_retired();
    InFlight& frame = in_flight_[slot];
    const std::vector<double> times = objects_->timer.read_ms(slot);
    for (Position position(0); position < times.size(); ++position)
        frame.timing.passes.push_back(pass_timing(position, times[position], frame));
    timings_.push_back(std::move(frame.timing));
    if (timings_.size() > kMostTimings) timings_.erase(timings_.begin());
    objects_->readbacks.deliver(objects_->plan, slot, frame.frame_index, {frame.areas, frame.switches},
                                readbacks_);
    return Unit{};
}

Result<uint32_t> ReplayExecutor::begin_frame() {
    assert(slot_ == kNoId && "begin_frame() twice without run()");
    const auto slot = static_cast<uint32_t>(frames_begun_ % kFramesInFlight);
    const Stopwatch watch;
    if (Status completed = complete_predecessor(slot); !completed) return completed.take_errors();
    if (Status completed = complete(slot); !completed) return completed.take_errors();
    in_flight_[slot] = {};
    in_flight_[slot].timing.wait_ms = watch.ms();
    ++frames_begun_;
    slot_ = slot;
    return slot;
}

Status ReplayExecutor::finish() {
    for (uint32_t i = 0; i < kFramesInFlight; ++i) {
        const auto oldest = static_cast<uint32_t>((frames_begun_ + i) % kFramesInFlight);
        if (Status completed = complete_predecessor(oldest); !completed) return completed;
        if (Status completed = complete(oldest); !completed) return completed;
    }
    return Unit{};
}

// Chooses the rest units that run in this frame. In each frame, either all passes of a rest unit run, or none
// of them.
void ReplayExecutor::choose_units(const FrameInput& frame, const TurnLists& turns, uint32_t slot) {
    if (rest_.unit_count() == 0) return;
    unit_inputs_.assign(rest_.unit_count(), UnitInput(std::in_place));
    const std::vector<uint8_t> needed = rest_.needs_input(turns);
    for (Position position(0); position < objects_->passes.size(); ++position) {
        const PassDecl& pass = objects_->plan.graph.passes[objects_->plan.schedule.order[position]];
        if (pass.rest_unit == kNoId || needed[pass.rest_unit] == 0) continue;
        add_unit_input({*objects_, frame, {objects_->resources, frames_run_, slot}, slot}, position,
                       unit_inputs_[pass.rest_unit]);
    }
    chosen_ = rest_.choose(unit_inputs_, turns);
    objects_->validity.begin_frame(rest_, chosen_);
    name_changed_inputs({*objects_, frame, {objects_->resources, frames_run_, slot}, slot});
}

// For each rest unit that runs because an input has changed, stores the name of this input.
void ReplayExecutor::name_changed_inputs(const UnitInputContext& context) {
    const auto woken = [](const Wake& wake) { return wake.reason == WakeReason::input; };
    if (std::ranges::none_of(chosen_.wakes, woken)) return;
    const FramePlan& plan = objects_->plan;
    std::vector<std::vector<Position>> positions(chosen_.wakes.size());
    for (Position position(0); position < plan.schedule.order.size(); ++position) {
        const uint32_t unit = plan.graph.passes[plan.schedule.order[position]].rest_unit;
        if (unit != kNoId) positions[unit].push_back(position);
    }
    for (uint32_t unit = 0; unit < positions.size(); ++unit)
        if (woken(chosen_.wakes[unit]))
            chosen_.wakes[unit].input = changed_input(context, positions[unit], rest_.last_input(unit));
}

std::vector<uint8_t> ReplayExecutor::running_units() const {
    std::vector<uint8_t> runs;
    for (const Wake& wake : chosen_.wakes) runs.push_back(wake.runs() ? 1 : 0);
    return runs;
}

// Lets the C++ passes prepare their data. Returns the lists of turns of the frame: the numbers of the rounds
// of a group that may run. The lists come from the program, but passes may replace them.
TurnLists ReplayExecutor::prepare_uploads(const FrameInput& frame, uint32_t slot) {
    const FramePlan& plan = objects_->plan;
    const HostInputs none;
    TurnLists turns = frame.turns;
    for (Position position(0); position < objects_->passes.size(); ++position) {
        const PreparedPass& prepared = objects_->passes[position];
        const PassDecl& pass = plan.graph.passes[plan.schedule.order[position]];
        if (!prepared.type || !has_combination(pass.runs_in, in_flight_[slot].switches)) continue;
        objects_->uploads.prepare(position, *prepared.type, pass, frame.host != nullptr ? *frame.host : none,
                                  slot, turns);
    }
    return turns;
}

void ReplayExecutor::record_step(const RecordContext& context, const FrameStep& recorded) {
    const FramePlan& plan = objects_->plan;
    const Position position = recorded.position;
    const PassStep& step = plan.barriers.steps[position];
    const std::string& name = plan.graph.passes[step.pass].name;
    device_.messages().set_current_pass(name);
    if (context.labels) begin_label(device_, context.commands, name);
    if (position != hooks_.drop_barriers_of_position)
        record_barriers(device_, context.commands, step.barriers, plan, context.resources, recorded, true);
    const PassDecl& pass = plan.graph.passes[step.pass];
    const bool counts = !context.frame.prepares_units || needed_by_units_[position] != 0;
    if (recorded.runs && counts && runs_in_frame(pass, frames_run_) &&
        has_combination(pass.runs_in, context.switches))
        record_pass(context, position);
    record_barriers(device_, context.commands, step.after, plan, context.resources, recorded, false);
    if (context.labels) end_label(device_, context.commands);
    if (!recorded.is_border()) objects_->timer.record_pass_end(context.commands, context.slot, position);
}

void ReplayExecutor::record_epilogue(const RecordContext& context) {
    const FramePlan& plan = objects_->plan;
    if (context.labels) begin_label(device_, context.commands, "epilogue");
    record_barriers(device_, context.commands, plan.barriers.epilogue, plan, context.resources);
    if (context.labels) end_label(device_, context.commands);
}

void ReplayExecutor::record_frame(const FrameInput& frame, uint32_t slot) {
    const FramePlan& plan = objects_->plan;
    if (frames_run_ == 0) record_start(slots_->prologue(slot));
    const std::vector<uint8_t> running = running_units();
    if (frame.prepares_units && needed_by_units_.empty()) needed_by_units_ = needed_by_units(plan);
    in_flight_[slot].draws_left_out.assign(first_view_.back(), 0);
    for (uint32_t i = 0; i < plan.submissions.batches.size(); ++i) {
        const Batch& batch = plan.submissions.batches[i];
        const BatchCommands place = slots_->batch(slot, i);
        const RecordContext context{device_,
                                    place.commands,
                                    place.labels,
                                    place.family,
                                    slot,
                                    frame,
                                    *objects_,
                                    {objects_->resources, frames_run_, slot},
                                    in_flight_[slot].draws_left_out,
                                    first_view_,
                                    in_flight_[slot].switches};
        objects_->timer.record_batch_start(context.commands, slot, i);
        for (const FrameStep& step : frame_steps(plan, batch, running, chosen_.rounds))
            record_step(context, step);
        if (batch.epilogue) record_epilogue(context);
        objects_->readbacks.record_visibility(device_, context.commands, slot, batch);
    }
}

// Returns one number for each batch (a submission of passes): 1 if nothing was recorded because all passes of
// the batch rest, else 0. An empty list means that no batch is empty.
std::vector<uint8_t> ReplayExecutor::empty_batches() const {
    if (chosen_.wakes.empty()) return {};
    std::vector<uint8_t> resting, empty;
    for (const Wake& wake : chosen_.wakes) resting.push_back(wake.runs() ? 0 : 1);
    for (const Batch& batch : objects_->plan.submissions.batches)
        empty.push_back(is_empty_batch(objects_->plan, batch, resting) ? 1 : 0);
    return empty;
}

Status ReplayExecutor::submit_frame(const FrameSubmit& how, uint32_t slot) {
    const std::string all_passes = pass_names(objects_->plan, 0);
    device_.messages().set_current_pass(all_passes);
    const std::vector<uint8_t> empty = empty_batches();
    const VkResult result =
        slots_->submit(slot, frames_run_, empty, {how, waiting_batches(plan(), how.waits, empty)});
    device_.messages().set_current_pass("");
    if (result == VK_ERROR_DEVICE_LOST) return lost_frame(slot, result);
    if (result == VK_SUCCESS) {
        ++frames_run_;
        rest_.commit(unit_inputs_, chosen_);
        return Unit{};
    }
    const Diagnostic failed = failed_call("V418", "submitting passes " + all_passes, result);
    // If only part of a frame was submitted, the state of its resources is unknown, so no further frame can
    // run.
    if (slots_->in_flight(slot)) lost_ = {failed};
    return failed;
}

Status ReplayExecutor::run(const FrameInput& frame) {
    assert(slot_ != kNoId && "run() needs the slot of begin_frame()");
    const uint32_t slot = std::exchange(slot_, kNoId);
    if (!lost_.empty()) return lost_;
    if (Status possible = check_submit(plan(), frame.submit); !possible) return possible;
    InFlight& in_flight = in_flight_[slot];
    in_flight.frame_index = frame.frame_index;
    in_flight.switches = switches_in(plan().graph, frame);
    const Stopwatch record_watch;
    objects_->areas.begin_frame(plan().graph, frame.scales, objects_->resources.rings, frames_run_);
    if (!plan().graph.live_values.empty()) in_flight.areas = objects_->areas.all();
    choose_units(frame, prepare_uploads(frame, slot), slot);
    objects_->timer.reset(slot);
    objects_->params.write(
        plan(),
        {frame, {objects_->resources, frames_run_}, objects_->areas, &objects_->validity, in_flight.switches},
        slot);
    if (Status begun = slots_->begin(slot, frames_run_, frame.submit.commands); !begun) return begun;
    record_frame(frame, slot);
    in_flight.wakes = chosen_.wakes;
    in_flight.timing.dropped_turns = chosen_.dropped_turns;
    in_flight.timing.record_ms = record_watch.ms();
    const Stopwatch submit_watch;
    Status submitted = submit_frame(frame.submit, slot);
    in_flight.timing.submit_ms = submit_watch.ms();
    return submitted;
}

NativeResource ReplayExecutor::native(ResourceId resource) const {
    for (const Placement& placement : plan().memory.placements)
        if (placement.resource == resource)
            return {objects_->heap.image(resource), objects_->heap.buffer(resource),
                    objects_->heap.memory(placement).memory,
                    objects_->heap.memory(placement).offset_bytes + placement.offset_bytes};
    return {};
}

ResourceId ReplayExecutor::last_copy(ResourceId resource) const {
    return objects_->resources.rings.copy(resource, frames_run_ == 0 ? 0 : frames_run_ - 1);
}

Result<std::unique_ptr<Executor>> Executor::create(Device& device, ExecutorInput input) {
    const ExecutorHooks hooks = input.hooks;
    Result<std::unique_ptr<PlanObjects>> objects = make_plan_objects(device, std::move(input));
    if (!objects) return objects.take_errors();
    Result<FrameSlots> slots = FrameSlots::create(device, (*objects)->plan);
    if (!slots) return slots.take_errors();
    return std::unique_ptr<Executor>(
        std::make_unique<ReplayExecutor>(device, std::move(*objects), std::move(*slots), hooks));
}

std::unique_ptr<Amendment> Executor::make_amendment(ResolvedGraph graph) {
    auto amendment = std::make_unique<PlanAmendment>();
    amendment->graph = std::move(graph);
    return amendment;
}

Result<std::unique_ptr<Amendment>> Executor::make_amendment(Device& device, ExecutorInput input) {
    Result<std::unique_ptr<PlanAmendment>> made = make_plan_amendment(device, std::move(input));
    if (!made) return made.take_errors();
    return std::unique_ptr<Amendment>(std::move(*made));
}

}  // namespace weft::vk
