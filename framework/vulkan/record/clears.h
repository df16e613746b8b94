// Purpose: fills resources with one value, outside any rendering scope: for clear passes, and for the
// first-frame values of persistent resources.
#pragma once

#include <array>
#include <span>

#include "vulkan/memory/resource_table.h"

namespace weft::vk {

// An image must be in `layout`; the value is interpreted by its format, depth first, then stencil. A buffer
// is filled as a whole with words of the value's integer part, so that 7 becomes the integer 7.
struct ClearTarget {
    ResourceId resource = kNoId;
    SubresourceRange range;
    Layout layout = Layout::transfer_dst;
    std::array<float, 4> value{0, 0, 0, 0};
};

void record_clear_of(const Device& device, VkCommandBuffer commands, const FramePlan& plan,
                     const FrameResources& resources, const ClearTarget& target);

// Fills persistent resources, which must be in transfer_dst, with their first-frame values.
void record_first_content(const Device& device, VkCommandBuffer commands, const FramePlan& plan,
                          const FrameResources& resources, std::span<const ResourceId> cleared);

// Recorded once, before the first frame: fills all copies of persistent resources with their first-frame
// values.
void record_prologue(const Device& device, VkCommandBuffer commands, const FramePlan& plan,
                     const ResourceTable& resources);

}  // namespace weft::vk
