#include "vulkan/record/timing.h"

#include <algorithm>

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/plan_queues.h"
#include "vulkan/record/merged_scopes.h"

namespace weft::vk {

Result<PassTimer> PassTimer::create(Device& device, const FramePlan& plan, bool enabled) {
    PassTimer timer;
    timer.device_ = &device;
    timer.pass_timed_.resize(plan.schedule.order.size(), 0);
    timer.before_.fill(std::vector<uint32_t>(plan.schedule.order.size(), kNoId));
    for (Position position(0); position < plan.schedule.order.size(); ++position)
        timer.inside_scope_.push_back(scope_continues(plan, position) ? 1 : 0);
    const std::vector<PlanQueue> queues = map_queues(device, plan.schedule.queues);
    for (const Batch& batch : plan.submissions.batches) {
        timer.batch_timed_.push_back(enabled && queues[batch.queue].timestamps ? 1 : 0);
        for (const Position position : batch.positions)
            timer.pass_timed_[position] = timer.batch_timed_.back();
    }
    const auto timed = [](uint8_t flag) { return flag != 0; };
    if (std::none_of(timer.batch_timed_.begin(), timer.batch_timed_.end(), timed)) return timer;
    for (QueryPoolHandle& pool : timer.pools_) {
        VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
        info.queryType = VK_QUERY_TYPE_TIMESTAMP;
        info.queryCount = timer.end_query(timer.pass_timed_.size());
        VkQueryPool object = VK_NULL_HANDLE;
        const VkResult result = device.fn().vkCreateQueryPool(device.handle(), &info, nullptr, &object);
        if (result != VK_SUCCESS) return failed_call("V418", "creating the timestamp queries", result);
        pool = {device, object};
    }
    return timer;
}

uint32_t PassTimer::end_query(size_t position) const {
    return static_cast<uint32_t>(batch_timed_.size() + position);
}

void PassTimer::write(VkCommandBuffer commands, uint32_t slot, uint32_t query, bool inside_scope) const {
    const DeviceFunctions& fn = device_->fn();
    fn.vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pools_[slot].get(), query);
    // lavapipe writes a timestamp only at its next flush, and this empty barrier causes a flush. The barrier
    // has no stages and no accesses, so it cannot hide a missing barrier of the plan. Vulkan forbids such a
    // barrier inside a rendering scope, so no barrier is recorded there. A flush inside a scope would not
    // help anyway, because lavapipe executes a whole scope at once.
    if (inside_scope) return;
    const VkDependencyInfo nothing{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    fn.vkCmdPipelineBarrier2(commands, &nothing);
}

void PassTimer::reset(uint32_t slot) {
    std::ranges::fill(before_[slot], kNoId);
    // The host resets the queries, because a transfer queue cannot.
    if (pools_[slot])
        device_->fn().vkResetQueryPool(device_->handle(), pools_[slot].get(), 0,
                                       end_query(pass_timed_.size()));
}

void PassTimer::record_batch_start(VkCommandBuffer commands, uint32_t slot, uint32_t batch) {
    if (batch_timed_[batch] == 0) return;
    write(commands, slot, batch, false);
    last_query_ = batch;
}

void PassTimer::record_pass_end(VkCommandBuffer commands, uint32_t slot, Position position) {
    if (pass_timed_[position] == 0) return;
    write(commands, slot, end_query(position), inside_scope_[position] != 0);
    before_[slot][position] = last_query_;
    last_query_ = end_query(position);
}

std::vector<PassTimer::Stamp> PassTimer::stamps(uint32_t slot) const {
    if (!pools_[slot]) return {};
    std::vector<Stamp> stamps(end_query(pass_timed_.size()));
    const VkResult result = device_->fn().vkGetQueryPoolResults(
        device_->handle(), pools_[slot].get(), 0, static_cast<uint32_t>(stamps.size()),
        stamps.size() * sizeof(Stamp), stamps.data(), sizeof(Stamp),
        VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WITH_AVAILABILITY_BIT);
    if (result != VK_SUCCESS && result != VK_NOT_READY) return {};
    return stamps;
}

std::vector<double> PassTimer::read_ms(uint32_t slot) const {
    std::vector<double> times(pass_timed_.size(), -1);
    const std::vector<Stamp> all = stamps(slot);
    for (size_t i = 0; i < times.size() && !all.empty(); ++i) {
        if (pass_timed_[i] == 0) continue;
        if (before_[slot][i] == kNoId) {
            times[i] = 0;
            continue;
        }
        const Stamp& start = all[before_[slot][i]];
        const Stamp& end = all[end_query(i)];
        if (start.available == 0 || end.available == 0) continue;
        times[i] = static_cast<double>(end.ticks - start.ticks) * device_->info().timestamp_period_ns * 1e-6;
    }
    return times;
}

uint32_t PassTimer::first_unfinished(uint32_t slot) const {
    const std::vector<Stamp> all = stamps(slot);
    for (uint32_t i = 0; i < pass_timed_.size() && !all.empty(); ++i)
        if (before_[slot][i] != kNoId && all[end_query(i)].available == 0) return i;
    return static_cast<uint32_t>(pass_timed_.size());
}

}  // namespace weft::vk
