#include "vulkan/execute/frame_slots.h"

#include <algorithm>
#include <utility>

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/queue_lock.h"
#include "vulkan/execute/submission.h"

namespace weft::vk {
namespace {

VkResult wait_for(const Device& device, const std::vector<TimelinePoint>& points) {
    std::vector<VkSemaphore> semaphores;
    std::vector<uint64_t> values;
    for (const TimelinePoint& point : points) {
        semaphores.push_back(point.semaphore);
        values.push_back(point.value);
    }
    VkSemaphoreWaitInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO};
    info.semaphoreCount = static_cast<uint32_t>(semaphores.size());
    info.pSemaphores = semaphores.data();
    info.pValues = values.data();
    return device.fn().vkWaitSemaphores(device.handle(), &info, device.timeout_ns());
}

// Records a command that has no effect. It is used at the start and end of a command buffer, because lavapipe
// (Mesa 22.3) ignores barriers that are the first or last commands of a command buffer, although earlier
// submissions may still be running. Queues without graphics do not support the command, so they get none.
void fence_off_barriers(const Device& device, VkCommandBuffer commands, uint32_t family) {
    if ((device.families()[family].flags & VK_QUEUE_GRAPHICS_BIT) == 0) return;
    const VkRect2D anywhere{{0, 0}, {1, 1}};
    device.fn().vkCmdSetScissor(commands, 0, 1, &anywhere);
}

VkResult begin_commands(const Device& device, VkCommandBuffer commands, uint32_t family) {
    VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    const VkResult result = device.fn().vkBeginCommandBuffer(commands, &info);
    if (result == VK_SUCCESS) fence_off_barriers(device, commands, family);
    return result;
}

VkResult end_commands(const Device& device, VkCommandBuffer commands, uint32_t family) {
    fence_off_barriers(device, commands, family);
    return device.fn().vkEndCommandBuffer(commands);
}

}  // namespace

VkResult FrameSlots::allocate(VkCommandPool pool, VkCommandBuffer& commands) const {
    VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    info.commandPool = pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    return device_->fn().vkAllocateCommandBuffers(device_->handle(), &info, &commands);
}

VkResult FrameSlots::open(Slot& slot) const {
    const DeviceFunctions& fn = device_->fn();
    VkResult result = VK_SUCCESS;
    for (const PlanQueue& queue : queues_) {
        VkCommandPoolCreateInfo info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
        info.queueFamilyIndex = queue.family;
        VkCommandPool pool = VK_NULL_HANDLE;
        result = fn.vkCreateCommandPool(device_->handle(), &info, nullptr, &pool);
        if (result != VK_SUCCESS) return result;
        slot.pools.emplace_back(*device_, pool);
    }
    slot.commands.resize(queue_of_.size(), VK_NULL_HANDLE);
    for (size_t batch = 0; batch < slot.commands.size() && result == VK_SUCCESS; ++batch)
        result = allocate(slot.pools[queue_of_[batch]].get(), slot.commands[batch]);
    if (result == VK_SUCCESS) result = allocate(slot.pools[0].get(), slot.prologue);
    if (result != VK_SUCCESS || timelines_.in_use()) return result;
    VkFenceCreateInfo info{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    VkFence fence = VK_NULL_HANDLE;
    result = fn.vkCreateFence(device_->handle(), &info, nullptr, &fence);
    if (result == VK_SUCCESS) slot.fence = {*device_, fence};
    return result;
}

Result<FrameSlots> FrameSlots::create(Device& device, const FramePlan& plan) {
    FrameSlots slots;
    slots.device_ = &device;
    slots.queues_ = map_queues(device, plan.schedule.queues);
    for (const Batch& batch : plan.submissions.batches) slots.queue_of_.push_back(batch.queue);
    Result<QueueTimelines> timelines = QueueTimelines::create(device, plan);
    if (!timelines) return timelines.take_errors();
    slots.timelines_ = std::move(*timelines);
    for (Slot& slot : slots.slots_)
        if (const VkResult result = slots.open(slot); result != VK_SUCCESS)
            return failed_call("V418", "creating the objects of a frame in flight", result);
    return slots;
}

VkResult FrameSlots::wait(uint32_t index) {
    Slot& slot = slots_[index];
    if (!slot.in_flight) return VK_SUCCESS;
    const DeviceFunctions& fn = device_->fn();
    if (slot.last.empty()) {
        VkFence fence = slot.fence.get();
        const VkResult result =
            fn.vkWaitForFences(device_->handle(), 1, &fence, VK_TRUE, device_->timeout_ns());
        if (result != VK_SUCCESS) return result;
        slot.in_flight = false;
        return fn.vkResetFences(device_->handle(), 1, &fence);
    }
    const VkResult result = wait_for(*device_, slot.last);
    slot.in_flight = result != VK_SUCCESS;
    return result;
}

void FrameSlots::let_go() const {
    if (!timelines_.in_use() || !submitted_) return;
    for (const PlanQueue& queue : queues_) {
        const QueueLock lock(*device_, queue.handle);
        static_cast<void>(device_->fn().vkQueueWaitIdle(queue.handle));
    }
}

bool FrameSlots::is_over(uint32_t index) const {
    const Slot& slot = slots_[index];
    if (!slot.in_flight) return true;
    const DeviceFunctions& fn = device_->fn();
    if (slot.last.empty()) {
        const VkResult result = fn.vkGetFenceStatus(device_->handle(), slot.fence.get());
        return result == VK_SUCCESS || result == VK_ERROR_DEVICE_LOST;
    }
    return std::all_of(slot.last.begin(), slot.last.end(), [&](const TimelinePoint& point) {
        uint64_t value = 0;
        const VkResult result = fn.vkGetSemaphoreCounterValue(device_->handle(), point.semaphore, &value);
        return result == VK_ERROR_DEVICE_LOST || (result == VK_SUCCESS && value >= point.value);
    });
}

Status FrameSlots::begin(uint32_t index, uint64_t frame, VkCommandBuffer own) {
    Slot& slot = slots_[index];
    slot.own = own;
    slot.ticket = {};
    if (own != VK_NULL_HANDLE) {
        fence_off_barriers(*device_, own, queues_[0].family);
        return Unit{};
    }
    VkResult result = VK_SUCCESS;
    for (const CommandPoolHandle& pool : slot.pools)
        if (result == VK_SUCCESS) result = device_->fn().vkResetCommandPool(device_->handle(), pool.get(), 0);
    for (size_t batch = 0; batch < slot.commands.size() && result == VK_SUCCESS; ++batch)
        result = begin_commands(*device_, slot.commands[batch], queues_[queue_of_[batch]].family);
    if (result == VK_SUCCESS && frame == 0)
        result = begin_commands(*device_, slot.prologue, queues_[0].family);
    if (result != VK_SUCCESS) return failed_call("V418", "beginning the commands of a frame", result);
    return Unit{};
}

BatchCommands FrameSlots::batch(uint32_t index, uint32_t batch) const {
    const Slot& slot = slots_[index];
    const PlanQueue& queue = queues_[queue_of_[batch]];
    return {slot.own != VK_NULL_HANDLE ? slot.own : slot.commands[batch], queue.labels, queue.family};
}

VkResult FrameSlots::submit_alone(Slot& slot, uint64_t frame, const FrameSubmit& how) const {
    std::vector<VkCommandBuffer> commands;
    if (frame == 0) commands.push_back(slot.prologue);
    commands.push_back(slot.commands.front());
    Submission submission;
    for (const SemaphoreWait& wait : how.waits) submission.add(wait);
    for (const SemaphoreSignal& signal : how.signals) submission.add(signal);
    slot.last.clear();
    const VkResult result = submission.submit(*device_, queues_[0].handle, commands, slot.fence.get());
    slot.in_flight = result == VK_SUCCESS;
    return result;
}

// Handles those semaphores of the program for which all batches of the frame must wait. A binary semaphore
// can release only one submission. So an empty submission waits for the semaphores and signals a point of a
// timeline semaphore. The first batch of each queue waits for this point. Stores the point in `gate`, unless
// there are no such semaphores.
VkResult FrameSlots::open_gate(const FrameSubmit& how, const std::vector<uint32_t>& batches,
                               TimelinePoint& gate) {
    Submission submission;
    bool waits = false;
    for (size_t i = 0; i < how.waits.size(); ++i) {
        if (batches[i] != kNoId) continue;
        submission.add(how.waits[i]);
        waits = true;
    }
    if (!waits) return VK_SUCCESS;
    gate = timelines_.next_gate();
    submission.add_signal(gate.semaphore, gate.value);
    return submission.submit(*device_, queues_[0].handle, {}, VK_NULL_HANDLE);
}

// Signals the semaphores of the program after all batches of the frame.
VkResult FrameSlots::close_frame(const Slot& slot, const FrameSubmit& how) const {
    if (how.signals.empty()) return VK_SUCCESS;
    Submission submission;
    for (const TimelinePoint& point : slot.last) submission.add_wait(point.semaphore, point.value);
    for (const SemaphoreSignal& signal : how.signals) submission.add(signal);
    return submission.submit(*device_, queues_[0].handle, {}, VK_NULL_HANDLE);
}

VkResult FrameSlots::submit_batch(const Slot& slot, uint32_t batch, uint64_t frame,
                                  const std::vector<TimelinePoint>& gates, const ProgramWaits& own) {
    Submission submission;
    for (const TimelinePoint& point : timelines_.submit(batch, frame))
        submission.add_wait(point.semaphore, point.value);
    for (const TimelinePoint& gate : gates) submission.add_wait(gate.semaphore, gate.value);
    for (size_t i = 0; i < own.batches.size(); ++i)
        if (own.batches[i] == batch) submission.add(own.how.waits[i]);
    const TimelinePoint end = timelines_.end_of(batch, frame);
    submission.add_signal(end.semaphore, end.value);
    return submission.submit(*device_, queues_[queue_of_[batch]].handle, {&slot.commands[batch], 1},
                             VK_NULL_HANDLE);
}

VkResult FrameSlots::submit_batches(Slot& slot, uint64_t frame, const std::vector<uint8_t>& empty,
                                    const ProgramWaits& own) {
    std::vector<TimelinePoint> last(queues_.size());
    TimelinePoint gate;
    VkResult result = open_gate(own.how, own.batches, gate);
    if (result == VK_SUCCESS && frame == 0) {
        last[0] = timelines_.ready();
        Submission prologue;
        prologue.add_signal(last[0].semaphore, last[0].value);
        result = prologue.submit(*device_, queues_[0].handle, {&slot.prologue, 1}, VK_NULL_HANDLE);
        slot.in_flight = result == VK_SUCCESS;
    }
    if (result == VK_SUCCESS && frame > 0 && timelines_.awaits_program()) {
        const TimelinePoint done = timelines_.program_done(frame);
        Submission program;
        program.add_signal(done.semaphore, done.value);
        result = program.submit(*device_, queues_[0].handle, {}, VK_NULL_HANDLE);
    }
    timelines_.begin_frame();
    std::vector<uint8_t> passed(queues_.size(), gate.semaphore == VK_NULL_HANDLE ? 1 : 0);
    for (uint32_t batch = 0; batch < slot.commands.size() && result == VK_SUCCESS; ++batch) {
        if (batch < empty.size() && empty[batch] != 0) {
            timelines_.skip(batch);
            continue;
        }
        const QueueIndex queue = queue_of_[batch];
        std::vector<TimelinePoint> gates;
        if (std::exchange(passed[queue], uint8_t{1}) == 0) gates.push_back(gate);
        result = submit_batch(slot, batch, frame, gates, own);
        if (result != VK_SUCCESS) break;
        last[queue] = timelines_.end_of(batch, frame);
        slot.in_flight = true;
    }
    slot.last.clear();
    for (const TimelinePoint& point : last)
        if (point.semaphore != VK_NULL_HANDLE) slot.last.push_back(point);
    return result == VK_SUCCESS ? close_frame(slot, own.how) : result;
}

VkResult FrameSlots::submit(uint32_t index, uint64_t frame, const std::vector<uint8_t>& empty,
                            const ProgramWaits& own) {
    Slot& slot = slots_[index];
    if (slot.own != VK_NULL_HANDLE) {
        fence_off_barriers(*device_, slot.own, queues_[0].family);
        slot.ticket = own.how.ticket;
        slot.last = {{slot.ticket.timeline, slot.ticket.value}};
        slot.in_flight = true;
        return VK_SUCCESS;
    }
    VkResult result = VK_SUCCESS;
    if (frame == 0) result = end_commands(*device_, slot.prologue, queues_[0].family);
    for (size_t batch = 0; batch < slot.commands.size() && result == VK_SUCCESS; ++batch)
        result = end_commands(*device_, slot.commands[batch], queues_[queue_of_[batch]].family);
    if (result != VK_SUCCESS) return result;
    submitted_ = true;
    return timelines_.in_use() ? submit_batches(slot, frame, empty, own) : submit_alone(slot, frame, own.how);
}

}  // namespace weft::vk
