#include "render/descriptor_sets.h"

#include "vulkan/device/functions.h"
#include "vulkan/device/vk_result.h"

namespace weft::render {
namespace {

VkWriteDescriptorSet write_of(VkDescriptorSet set, uint32_t binding, VkDescriptorType type, size_t count) {
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.dstBinding = binding;
    write.descriptorCount = static_cast<uint32_t>(count);
    write.descriptorType = type;
    return write;
}

}  // namespace

Result<DescriptorSets> DescriptorSets::create(vk::Device& device,
                                              std::span<const VkDescriptorSetLayoutBinding> bindings,
                                              uint32_t count, const std::string& name) {
    const vk::DeviceFunctions& fn = device.fn();
    DescriptorSets made;
    VkDescriptorSetLayoutCreateInfo layout_info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    layout_info.bindingCount = static_cast<uint32_t>(bindings.size());
    layout_info.pBindings = bindings.data();
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    VkResult result = fn.vkCreateDescriptorSetLayout(device.handle(), &layout_info, nullptr, &layout);
    if (result != VK_SUCCESS)
        return vk::vk_error(result, "creating the descriptor set layout of the " + name);
    made.layout = {device, layout};
    if (count == 0) return made;

    std::vector<VkDescriptorPoolSize> sizes;
    for (const VkDescriptorSetLayoutBinding& binding : bindings)
        sizes.push_back({binding.descriptorType, binding.descriptorCount * count});
    VkDescriptorPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    pool_info.maxSets = count;
    pool_info.poolSizeCount = static_cast<uint32_t>(sizes.size());
    pool_info.pPoolSizes = sizes.data();
    VkDescriptorPool pool = VK_NULL_HANDLE;
    result = fn.vkCreateDescriptorPool(device.handle(), &pool_info, nullptr, &pool);
    if (result != VK_SUCCESS) return vk::vk_error(result, "creating the descriptor pool of the " + name);
    made.pool = {device, pool};

    const std::vector<VkDescriptorSetLayout> layouts(count, layout);
    VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    info.descriptorPool = pool;
    info.descriptorSetCount = count;
    info.pSetLayouts = layouts.data();
    made.sets.resize(count);
    result = fn.vkAllocateDescriptorSets(device.handle(), &info, made.sets.data());
    if (result != VK_SUCCESS) return vk::vk_error(result, "allocating the descriptor sets of the " + name);
    return made;
}

void write_buffers(vk::Device& device, VkDescriptorSet set, uint32_t binding, VkDescriptorType type,
                   std::span<const VkDescriptorBufferInfo> buffers) {
    VkWriteDescriptorSet write = write_of(set, binding, type, buffers.size());
    write.pBufferInfo = buffers.data();
    device.fn().vkUpdateDescriptorSets(device.handle(), 1, &write, 0, nullptr);
}

void write_images(vk::Device& device, VkDescriptorSet set, uint32_t binding,
                  std::span<const VkDescriptorImageInfo> images) {
    VkWriteDescriptorSet write =
        write_of(set, binding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, images.size());
    write.pImageInfo = images.data();
    device.fn().vkUpdateDescriptorSets(device.handle(), 1, &write, 0, nullptr);
}

}  // namespace weft::render
