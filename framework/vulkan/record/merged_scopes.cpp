#include "vulkan/record/merged_scopes.h"

#include <cassert>

namespace weft::vk {
namespace {

Position next_on_queue(const FramePlan& plan, Position position) {
    const std::vector<QueueIndex>& queue = plan.schedule.queue;
    for (Position next(position + 1); next < queue.size(); ++next)
        if (queue[next] == queue[position]) return next;
    return kNoId;
}

}  // namespace

bool scope_continues(const FramePlan& plan, Position position) {
    const Position next = next_on_queue(plan, position);
    return next != kNoId && plan.barriers.steps[next].merges_render_pass;
}

PassStep step_of_scope(const FramePlan& plan, Position position) {
    PassStep step = plan.barriers.steps[position];
    while (scope_continues(plan, position)) position = next_on_queue(plan, position);
    const PassStep& last = plan.barriers.steps[position];
    assert(step.attachments.size() == last.attachments.size() &&
           "a scope's passes have the same attachments");
    for (size_t i = 0; i < step.attachments.size(); ++i)
        step.attachments[i].store = last.attachments[i].store;
    return step;
}

}  // namespace weft::vk
