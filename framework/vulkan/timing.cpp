#include "vulkan/timing.h"

#include "vulkan/executor_errors.h"

namespace weft::vk {

Result<PassTimer> PassTimer::create(Device& device, uint32_t pass_count, bool enabled) {
    PassTimer timer;
    timer.device_ = &device;
    timer.pass_count_ = pass_count;
    if (!enabled || !device.info().timestamps) return timer;
    for (QueryPoolHandle& pool : timer.pools_) {
        VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
        info.queryType = VK_QUERY_TYPE_TIMESTAMP;
        info.queryCount = pass_count + 1;
        VkQueryPool object = VK_NULL_HANDLE;
        const VkResult result = device.fn().vkCreateQueryPool(device.handle(), &info, nullptr, &object);
        if (result != VK_SUCCESS) return failed_call("V418", "making the timestamp queries", result);
        pool = {device, object};
    }
    return timer;
}

void PassTimer::write(VkCommandBuffer commands, uint32_t slot, uint32_t query) const {
    const DeviceFunctions& fn = device_->fn();
    fn.vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pools_[slot].get(), query);
    // lavapipe puts a timestamp where it next flushes. A barrier makes it flush; this one depends on nothing
    // and holds nothing back, so it can't stand in for one that the plan forgot.
    const VkDependencyInfo nothing{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    fn.vkCmdPipelineBarrier2(commands, &nothing);
}

void PassTimer::record_start(VkCommandBuffer commands, uint32_t slot) const {
    if (!pools_[slot]) return;
    device_->fn().vkCmdResetQueryPool(commands, pools_[slot].get(), 0, pass_count_ + 1);
    write(commands, slot, 0);
}

void PassTimer::record_pass_end(VkCommandBuffer commands, uint32_t slot, uint32_t position) const {
    if (pools_[slot]) write(commands, slot, position + 1);
}

std::vector<double> PassTimer::read_ms(uint32_t slot) const {
    std::vector<double> times(pass_count_, -1);
    if (!pools_[slot]) return times;
    std::vector<uint64_t> ticks(pass_count_ + 1);
    const VkResult result = device_->fn().vkGetQueryPoolResults(
        device_->handle(), pools_[slot].get(), 0, pass_count_ + 1, ticks.size() * sizeof(uint64_t),
        ticks.data(), sizeof(uint64_t), VK_QUERY_RESULT_64_BIT);
    if (result != VK_SUCCESS) return times;
    for (uint32_t i = 0; i < pass_count_; ++i)
        times[i] = static_cast<double>(ticks[i + 1] - ticks[i]) * device_->info().timestamp_period_ns * 1e-6;
    return times;
}

uint32_t PassTimer::first_unfinished(uint32_t slot) const {
    if (!pools_[slot]) return pass_count_;
    struct Answer {
        uint64_t ticks = 0;
        uint64_t available = 0;
    };
    std::vector<Answer> answers(pass_count_ + 1);
    const VkResult result = device_->fn().vkGetQueryPoolResults(
        device_->handle(), pools_[slot].get(), 0, pass_count_ + 1, answers.size() * sizeof(Answer),
        answers.data(), sizeof(Answer), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WITH_AVAILABILITY_BIT);
    if (result != VK_SUCCESS && result != VK_NOT_READY) return pass_count_;
    for (uint32_t i = 0; i < pass_count_; ++i)
        if (answers[i + 1].available == 0) return i;
    return pass_count_;
}

}  // namespace weft::vk
