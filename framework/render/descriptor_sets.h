// Purpose: layouts and sets of descriptors that live longer than a frame: created and written once. Errors:
// those of vk_error().
#pragma once

#include <span>
#include <string>
#include <vector>

#include "vulkan/device/handle.h"
#include "weft/result.h"

namespace weft::render {

// `count` sets of one layout, and their pool.
struct DescriptorSets {
    vk::SetLayoutHandle layout;
    vk::DescriptorPoolHandle pool;
    std::vector<VkDescriptorSet> sets;

    // `name` is used in messages. With a count of 0 only the layout is made.
    [[nodiscard]] static Result<DescriptorSets> create(vk::Device& device,
                                                       std::span<const VkDescriptorSetLayoutBinding> bindings,
                                                       uint32_t count, const std::string& name);
};

// Writes descriptors of consecutive bindings of one type, starting at `binding`.
void write_buffers(vk::Device& device, VkDescriptorSet set, uint32_t binding, VkDescriptorType type,
                   std::span<const VkDescriptorBufferInfo> buffers);
void write_images(vk::Device& device, VkDescriptorSet set, uint32_t binding,
                  std::span<const VkDescriptorImageInfo> images);

}  // namespace weft::render
