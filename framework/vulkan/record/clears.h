// Purpose: filling resources with one value, outside of any rendering: clear passes, and what persistent
// resources hold before the first frame.
#pragma once

#include <array>
#include <span>

#include "vulkan/memory/resource_table.h"

namespace weft::vk {

// Images in `layout`: the value as the format has it, depth first, then stencil. Buffers, whole: words of
// the value's integer part, so that 7 is the integer 7.
struct ClearTarget {
    ResourceId resource = kNoId;
    SubresourceRange range;
    Layout layout = Layout::transfer_dst;
    std::array<float, 4> value{0, 0, 0, 0};
};

void record_clear_of(const Device& device, VkCommandBuffer commands, const FramePlan& plan,
                     const FrameResources& resources, const ClearTarget& target);

// Persistent resources, in transfer_dst, get what they hold before anybody wrote them.
void record_first_content(const Device& device, VkCommandBuffer commands, const FramePlan& plan,
                          const FrameResources& resources, std::span<const ResourceId> cleared);

// Once, before the first frame: all copies of persistent resources get their first content.
void record_prologue(const Device& device, VkCommandBuffer commands, const FramePlan& plan,
                     const ResourceTable& resources);

}  // namespace weft::vk
