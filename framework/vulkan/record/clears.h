// Purpose: fills resources with one value, outside any rendering scope. This is used for clear passes, and
// for persistent resources before the first frame.
#pragma once

#include <array>
#include <span>

#include "vulkan/memory/resource_table.h"

namespace weft::vk {

// A range of a resource, and the value that fills it. An image must be in `layout`. For a colour image,
// `value` is the colour. For a depth-stencil image, value[0] is the depth and value[1] the stencil. In a
// buffer, each 32-bit word becomes value[0] as an integer, for example 7.0 becomes the integer 7.
struct ClearTarget {
    ResourceId resource = kNoId;
    SubresourceRange range;
    Layout layout = Layout::transfer_dst;
    std::array<float, 4> value{0, 0, 0, 0};
};

void record_clear_of(const Device& device, VkCommandBuffer commands, const FramePlan& plan,
                     const FrameResources& resources, const ClearTarget& target);

// Fills persistent resources with their first-frame values. The resources must be in the transfer_dst layout.
void record_first_content(const Device& device, VkCommandBuffer commands, const FramePlan& plan,
                          const FrameResources& resources, std::span<const ResourceId> cleared);

// Fills all copies of persistent resources with their first-frame values. Recorded once, before the first
// frame.
void record_prologue(const Device& device, VkCommandBuffer commands, const FramePlan& plan,
                     const ResourceTable& resources);

}  // namespace weft::vk
