// Purpose: the Vulkan objects that the tests of raw passes create themselves, as a program would.
#pragma once

#include <gtest/gtest.h>

#include <array>

#include "vulkan/device/functions.h"
#include "vulkan/device/handle.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

// The Vulkan objects of the raw passes: a compute pipeline with one storage buffer, and a render pass. The
// passes get them through HostInputs.
struct OwnObjects {
    explicit OwnObjects(Device& d) : device(d) {}
    ~OwnObjects() {
        for (const VkFramebuffer framebuffer : framebuffers)
            destroy_framebuffer(device.handle(), framebuffer, nullptr);
        if (render_pass != VK_NULL_HANDLE) destroy_render_pass(device.handle(), render_pass, nullptr);
    }

    template <class Function>
    void load(const char* name, Function& function) const {
        function =
            reinterpret_cast<Function>(device.instance_fn().vkGetDeviceProcAddr(device.handle(), name));
    }

    Device& device;
    SetLayoutHandle set_layout;
    PipelineLayoutHandle layout;
    PipelineHandle pipeline;
    DescriptorPoolHandle pool;
    VkDescriptorSet set = VK_NULL_HANDLE;
    VkRenderPass render_pass = VK_NULL_HANDLE;
    std::array<VkFramebuffer, kFramesInFlight> framebuffers{};
    PFN_vkCreateRenderPass create_render_pass = nullptr;
    PFN_vkDestroyRenderPass destroy_render_pass = nullptr;
    PFN_vkCreateFramebuffer create_framebuffer = nullptr;
    PFN_vkDestroyFramebuffer destroy_framebuffer = nullptr;
    PFN_vkCmdBeginRenderPass begin_render_pass = nullptr;
    PFN_vkCmdEndRenderPass end_render_pass = nullptr;
};

inline void make_compute_objects(OwnObjects& own, const ShaderModuleHandle& module) {
    const DeviceFunctions& fn = own.device.fn();
    const VkDevice device = own.device.handle();
    const VkDescriptorSetLayoutBinding binding{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1,
                                               VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    VkDescriptorSetLayoutCreateInfo set_info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    set_info.bindingCount = 1;
    set_info.pBindings = &binding;
    VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
    ASSERT_EQ(fn.vkCreateDescriptorSetLayout(device, &set_info, nullptr, &set_layout), VK_SUCCESS);
    own.set_layout = {own.device, set_layout};
    const std::array sets{set_layout, set_layout};  // Shaders of Weft have their ports in set 1.
    VkPipelineLayoutCreateInfo layout_info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    layout_info.setLayoutCount = static_cast<uint32_t>(sets.size());
    layout_info.pSetLayouts = sets.data();
    VkPipelineLayout layout = VK_NULL_HANDLE;
    ASSERT_EQ(fn.vkCreatePipelineLayout(device, &layout_info, nullptr, &layout), VK_SUCCESS);
    own.layout = {own.device, layout};
    VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    info.stage = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module.get();
    info.stage.pName = "main";
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    ASSERT_EQ(fn.vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline), VK_SUCCESS);
    own.pipeline = {own.device, pipeline};
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, kFramesInFlight};
    VkDescriptorPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    pool_info.maxSets = 1;
    pool_info.poolSizeCount = 1;
    pool_info.pPoolSizes = &size;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    ASSERT_EQ(fn.vkCreateDescriptorPool(device, &pool_info, nullptr, &pool), VK_SUCCESS);
    own.pool = {own.device, pool};
    VkDescriptorSetAllocateInfo set_alloc{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    set_alloc.descriptorPool = pool;
    set_alloc.descriptorSetCount = 1;
    set_alloc.pSetLayouts = &set_layout;
    ASSERT_EQ(fn.vkAllocateDescriptorSets(device, &set_alloc, &own.set), VK_SUCCESS);
}

inline VkRenderPass make_render_pass(const OwnObjects& own) {
    VkAttachmentDescription color{};
    color.format = VK_FORMAT_R8G8B8A8_UNORM;
    color.samples = VK_SAMPLE_COUNT_1_BIT;
    color.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    color.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    color.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    color.initialLayout = color.finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &reference;
    VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
    info.attachmentCount = 1;
    info.pAttachments = &color;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    VkRenderPass made = VK_NULL_HANDLE;
    EXPECT_EQ(own.create_render_pass(own.device.handle(), &info, nullptr, &made), VK_SUCCESS);
    return made;
}

}  // namespace weft::vk
