#include "tests/vulkan/triangle_source.h"

#include <gtest/gtest.h>

#include <cstring>

#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"

namespace weft::vk {
namespace {

constexpr uint64_t kColorStrideBytes = 256;

template <class T>
Buffer filled(Device& device, const T& values, VkBufferUsageFlags usage, const char* name) {
    Result<Buffer> made =
        Buffer::create(device, values.size() * sizeof(values[0]), usage, Buffer::Memory::upload, name);
    if (!made) {
        ADD_FAILURE() << to_text(made.errors());
        return {};
    }
    std::memcpy(made->mapped().data(), values.data(), made->mapped().size());
    return std::move(*made);
}

}  // namespace

TriangleSource::TriangleSource(Device& device) {
    const std::array<float, 8> corners{-1, -1, -1, 1, 1, -1, 1, 1};
    const std::array<float, 4> weights{1, 1, 1, 1};
    const std::array<uint32_t, 6> indices{0, 1, 2, 3, 2, 1};
    std::array<float, 2 * kColorStrideBytes / sizeof(float)> colors{};
    std::memcpy(colors.data(), kCameraColor.data(), sizeof kCameraColor);
    std::memcpy(colors.data() + colors.size() / 2, kSunColor.data(), sizeof kSunColor);
    positions_ = filled(device, corners, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "positions");
    weights_ = filled(device, weights, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "weights");
    indices_ = filled(device, indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT, "indices");
    colors_ = filled(device, colors, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, "view colours");
    make_frame_sets(device);
}

void TriangleSource::make_frame_sets(Device& device) {
    const DeviceFunctions& fn = device.fn();
    const VkDescriptorSetLayoutBinding binding{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, VK_SHADER_STAGE_ALL,
                                               nullptr};
    VkDescriptorSetLayoutCreateInfo layout_info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    layout_info.bindingCount = 1;
    layout_info.pBindings = &binding;
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    ASSERT_EQ(fn.vkCreateDescriptorSetLayout(device.handle(), &layout_info, nullptr, &layout), VK_SUCCESS);
    layout_ = {device, layout};
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 2};
    VkDescriptorPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    pool_info.maxSets = 2;
    pool_info.poolSizeCount = 1;
    pool_info.pPoolSizes = &size;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    ASSERT_EQ(fn.vkCreateDescriptorPool(device.handle(), &pool_info, nullptr, &pool), VK_SUCCESS);
    pool_ = {device, pool};
    const std::array layouts{layout, layout};
    VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = pool;
    allocate.descriptorSetCount = 2;
    allocate.pSetLayouts = layouts.data();
    ASSERT_EQ(fn.vkAllocateDescriptorSets(device.handle(), &allocate, sets_.data()), VK_SUCCESS);
    for (size_t i = 0; i < sets_.size(); ++i) {
        const VkDescriptorBufferInfo info{colors_.handle(), i * kColorStrideBytes, sizeof kCameraColor};
        VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
        write.dstSet = sets_[i];
        write.descriptorCount = 1;
        write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        write.pBufferInfo = &info;
        fn.vkUpdateDescriptorSets(device.handle(), 1, &write, 0, nullptr);
    }
}

VkDescriptorSetLayout TriangleSource::set_layout(uint32_t set) const {
    return set == 0 || set == 3 ? layout_.get() : VK_NULL_HANDLE;
}

VkDescriptorSet TriangleSource::frame_set(uint32_t /*frame_slot*/, std::string_view view) const {
    return view == "camera" ? sets_[0] : sets_[1];
}

uint32_t TriangleSource::record(const DrawContext& context) const {
    drawn.push_back(std::string(context.list) + "/" + std::to_string(context.variant));
    const std::array buffers{positions_.handle(), weights_.handle()};
    const std::array<VkDeviceSize, 2> offsets{0, 0};
    context.fn->vkCmdBindVertexBuffers(context.commands, 0, 2, buffers.data(), offsets.data());
    if (context.uses_instances)
        context.fn->vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout,
                                            3, 1, &sets_[1], 0, nullptr);
    if (context.cull == CullMode::material) {
        context.fn->vkCmdSetCullMode(context.commands, VK_CULL_MODE_BACK_BIT);
        context.fn->vkCmdSetFrontFace(context.commands, to_vk(front_face));
    }
    if (context.draw_commands == VK_NULL_HANDLE) {
        context.fn->vkCmdDraw(context.commands, 3, 1, 0, 0);
        return 0;
    }
    constexpr uint32_t kCommandBytes = sizeof(VkDrawIndexedIndirectCommand);
    context.fn->vkCmdBindIndexBuffer(context.commands, indices_.handle(), 0, VK_INDEX_TYPE_UINT32);
    if (context.draw_count != VK_NULL_HANDLE) {
        context.fn->vkCmdDrawIndexedIndirectCount(
            context.commands, context.draw_commands, context.draw_commands_offset_bytes, context.draw_count,
            context.draw_count_offset_bytes, context.most_draws, kCommandBytes);
        return 0;
    }
    for (uint32_t draw = 0; draw < 2; ++draw)
        context.fn->vkCmdDrawIndexedIndirect(context.commands, context.draw_commands,
                                             context.draw_commands_offset_bytes + draw * kCommandBytes, 1,
                                             kCommandBytes);
    return 0;
}

ImportDecl TriangleSource::draw_list(const std::string& name) {
    ImportDecl import;
    import.name = name;
    import.kind = ImportKind::draw_list;
    import.variants = {{"plain", {}}, { "tinted", { {"TINT", 1}, { "UNKNOWN", 1 } } }};
    import.vertex_format.stride_bytes = {8, 4};
    import.vertex_format.attributes = {{"position", Format::rg32f, 0, 0}, { "weight", Format::r32f, 1, 0 }};
    return import;
}

}  // namespace weft::vk
