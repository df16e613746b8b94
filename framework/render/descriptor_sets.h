// Purpose: descriptor set layouts and sets that live longer than a frame. They are created and written only
// once. Errors: those of vk_error(), such as V410 (out of memory).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "vulkan/device/handle.h"
#include "weft/result.h"

namespace weft::render {

// A number of descriptor sets of one layout, and the pool from which they are allocated.
struct DescriptorSets {
    vk::SetLayoutHandle layout;
    vk::DescriptorPoolHandle pool;
    std::vector<VkDescriptorSet> sets;

    // Makes the layout and `count` sets. `name` describes the sets in error messages. With a count of 0 only
    // the layout is made.
    [[nodiscard]] static Result<DescriptorSets> create(vk::Device& device,
                                                       std::span<const VkDescriptorSetLayoutBinding> bindings,
                                                       uint32_t count, const std::string& name);
};

// These functions write the descriptors of consecutive bindings, starting at binding `binding`. All bindings
// have the type `type`; for write_images() this is a combined image sampler.
void write_buffers(vk::Device& device, VkDescriptorSet set, uint32_t binding, VkDescriptorType type,
                   std::span<const VkDescriptorBufferInfo> buffers);
void write_images(vk::Device& device, VkDescriptorSet set, uint32_t binding,
                  std::span<const VkDescriptorImageInfo> images);

}  // namespace weft::render
