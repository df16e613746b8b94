// Purpose: descriptor set layouts and sets for what outlives every frame: made once, written once.
// Errors: those of vk_error().
#pragma once

#include <span>
#include <string>
#include <vector>

#include "vulkan/device/handle.h"
#include "weft/result.h"

namespace weft::render {

// `count` sets of one layout, with the pool they came from.
struct DescriptorSets {
    vk::SetLayoutHandle layout;
    vk::DescriptorPoolHandle pool;
    std::vector<VkDescriptorSet> sets;

    // `name` is for messages. No sets is fine: the layout alone is made.
    [[nodiscard]] static Result<DescriptorSets> create(vk::Device& device,
                                                       std::span<const VkDescriptorSetLayoutBinding> bindings,
                                                       uint32_t count, const std::string& name);
};

// Write descriptors of consecutive bindings that share a type, from `binding` on.
void write_buffers(vk::Device& device, VkDescriptorSet set, uint32_t binding, VkDescriptorType type,
                   std::span<const VkDescriptorBufferInfo> buffers);
void write_images(vk::Device& device, VkDescriptorSet set, uint32_t binding,
                  std::span<const VkDescriptorImageInfo> images);

}  // namespace weft::render
