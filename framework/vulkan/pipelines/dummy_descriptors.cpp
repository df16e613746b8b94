#include "vulkan/pipelines/dummy_descriptors.h"

#include <algorithm>

#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"

namespace weft::vk {
namespace {

Format dummy_format(const ShaderBinding& binding) {
    if (binding.storage_format != Format::undefined) return binding.storage_format;
    if (binding.shadow) return Format::d16;
    switch (binding.numeric) {
        case NumericClass::sint:
            return Format::r32i;
        case NumericClass::uint:
            return Format::r32u;
        case NumericClass::depth:
            return Format::d16;
        case NumericClass::float_like:
            break;
    }
    return Format::rgba8;
}

ImageKind dummy_kind(const ShaderBinding& binding) {
    if (binding.dim == ImageDim::d3) return ImageKind::d3;
    if (binding.dim == ImageDim::cube) return binding.arrayed ? ImageKind::cube_array : ImageKind::cube;
    return binding.arrayed ? ImageKind::d2_array : ImageKind::d2;
}

ResourceDecl dummy_decl(const ShaderBinding& binding) {
    ResourceDecl decl;
    decl.name = "stand-in for " + binding.name;
    decl.image_kind = dummy_kind(binding);
    decl.format = dummy_format(binding);
    decl.layers = binding.dim == ImageDim::cube ? 6 : 1;
    decl.samples = binding.multisampled ? 4 : 1;
    decl.aspects = format_info(decl.format).depth ? aspect::kDepth : aspect::kColor;
    decl.usage = binding.kind == BindingKind::storage_image ? usage::kStorage : usage::kSampled;
    return decl;
}

}  // namespace

Result<VkDescriptorImageInfo> DummyDescriptors::image(const ShaderBinding& binding) {
    Result<Image> made = Image::create(*device_, dummy_decl(binding));
    if (!made) return made.take_errors();
    const Image& image = images_.emplace_back(std::move(*made));
    const Layout layout =
        access_state(binding.kind == BindingKind::storage_image ? Access::storage_read : Access::sampled_read,
                     binding.stages, image.decl().aspects)
            .layout;
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    // The change of the layout is a write. Shaders that read the image must wait for it.
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT;
    barrier.newLayout = to_vk(layout);
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.handle();
    barrier.subresourceRange = to_vk(image.decl().whole());
    first_layouts_.push_back(barrier);
    return VkDescriptorImageInfo{VK_NULL_HANDLE, image.view(), to_vk(layout)};
}

Result<VkBuffer> DummyDescriptors::buffer(uint64_t size_bytes) {
    const VkBufferUsageFlags usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    Result<Buffer> made = Buffer::create(*device_, std::max<uint64_t>(size_bytes, 256), usage,
                                         Buffer::Memory::device, "stand-in buffer");
    if (!made) return made.take_errors();
    return buffers_.emplace_back(std::move(*made)).handle();
}

void DummyDescriptors::record_layouts(VkCommandBuffer commands) const {
    if (first_layouts_.empty()) return;
    VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.imageMemoryBarrierCount = static_cast<uint32_t>(first_layouts_.size());
    info.pImageMemoryBarriers = first_layouts_.data();
    device_->fn().vkCmdPipelineBarrier2(commands, &info);
}

}  // namespace weft::vk
