#include "vulkan/execute/queue_timelines.h"

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"

namespace weft::vk {
namespace {

Status make_timeline(Device& device, const std::string& name, SemaphoreHandle& handle) {
    VkSemaphoreTypeCreateInfo type{VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO};
    type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
    VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    info.pNext = &type;
    VkSemaphore semaphore = VK_NULL_HANDLE;
    const VkResult result = device.fn().vkCreateSemaphore(device.handle(), &info, nullptr, &semaphore);
    if (result != VK_SUCCESS) return failed_call("V418", "creating a timeline semaphore", result);
    handle = {device, semaphore};
    device.name(VK_OBJECT_TYPE_SEMAPHORE, reinterpret_cast<uint64_t>(semaphore), name);
    return Unit{};
}

}  // namespace

Result<QueueTimelines> QueueTimelines::create(Device& device, const FramePlan& plan) {
    QueueTimelines timelines;
    const std::vector<Batch>& batches = plan.submissions.batches;
    if (batches.size() < 2) return timelines;
    timelines.order_ = BatchOrder(plan);
    timelines.semaphores_.resize(plan.schedule.queues.size());
    for (size_t queue = 0; queue < timelines.semaphores_.size(); ++queue) {
        const std::string name = "queue " + std::to_string(queue);
        if (Status made = make_timeline(device, name, timelines.semaphores_[queue]); !made)
            return made.take_errors();
    }
    if (Status made = make_timeline(device, "before the first frame", timelines.ready_); !made)
        return made.take_errors();
    if (timelines.order_.awaits_program())
        if (Status made = make_timeline(device, "work of the program", timelines.program_); !made)
            return made.take_errors();
    if (Status made = make_timeline(device, "semaphores of the program", timelines.gate_); !made)
        return made.take_errors();
    return timelines;
}

TimelinePoint QueueTimelines::end_of(uint32_t batch, uint64_t frame) const {
    const QueuePoint end = order_.end_of(batch, frame);
    return {semaphores_[end.queue].get(), end.value};
}

std::vector<TimelinePoint> QueueTimelines::submit(uint32_t batch, uint64_t frame) {
    std::vector<TimelinePoint> points;
    for (const QueuePoint& point : order_.submit(batch, frame)) {
        const bool program = point.queue == semaphores_.size();
        points.push_back({program ? program_.get() : semaphores_[point.queue].get(), point.value});
    }
    if (frame == 0) points.push_back(ready());
    return points;
}

}  // namespace weft::vk
