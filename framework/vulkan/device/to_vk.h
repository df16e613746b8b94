// Purpose: the only table from Weft's enumerations to Vulkan's, and back for formats. Total: every enumerator
// has an entry. Masks translate bit by bit.
#pragma once

#include "weft/access.h"
#include "weft/declaration.h"
#include "weft/format.h"
#include "weft/plan.h"
#include "weft/shader_interface.h"
#include "weft/vulkan/functions.h"

namespace weft::vk {

[[nodiscard]] VkFormat to_vk(Format format);
[[nodiscard]] Format from_vk(VkFormat format);  // undefined for a format without a name in graphs

[[nodiscard]] VkImageLayout to_vk(Layout layout);
[[nodiscard]] VkPipelineStageFlags2 stages_to_vk(StageMask stages);
[[nodiscard]] VkAccessFlags2 access_to_vk(AccessMask access);
[[nodiscard]] VkImageAspectFlags aspects_to_vk(AspectMask aspects);
[[nodiscard]] VkImageSubresourceRange to_vk(const SubresourceRange& range);
// Of one mip, for copies.
[[nodiscard]] VkImageSubresourceLayers layers_to_vk(const SubresourceRange& range);

[[nodiscard]] VkImageUsageFlags image_usage_to_vk(
    UsageMask usage);  // bits that only buffers have give nothing
[[nodiscard]] VkBufferUsageFlags buffer_usage_to_vk(UsageMask usage);  // kSampled, attachments give nothing
[[nodiscard]] VkImageType image_type_to_vk(ImageKind kind);
[[nodiscard]] VkImageViewType view_type_to_vk(ImageKind kind);
[[nodiscard]] VkSampleCountFlagBits samples_to_vk(uint32_t samples);  // 1, 2, 4, … 64
[[nodiscard]] VkExtent3D to_vk(const Extent3D& extent);

[[nodiscard]] VkShaderStageFlagBits to_vk(ShaderStage stage);
[[nodiscard]] VkShaderStageFlags shader_stages_to_vk(ShaderStageMask stages);
// Sampled images are combined with their sampler.
[[nodiscard]] VkDescriptorType to_vk(BindingKind kind);

[[nodiscard]] VkFilter to_vk(SamplerFilter filter);
[[nodiscard]] VkSamplerMipmapMode mip_filter_to_vk(SamplerFilter filter);
[[nodiscard]] VkSamplerAddressMode to_vk(SamplerWrap wrap);

[[nodiscard]] VkCompareOp to_vk(CompareOp op);
// `material` is set for each draw; until then nothing is culled.
[[nodiscard]] VkCullModeFlags to_vk(CullMode mode);
[[nodiscard]] VkFrontFace to_vk(FrontFace face);
[[nodiscard]] VkPrimitiveTopology to_vk(Topology topology);
[[nodiscard]] VkPolygonMode to_vk(FillMode mode);
[[nodiscard]] VkBlendFactor to_vk(BlendFactor factor);
[[nodiscard]] VkBlendOp to_vk(BlendOp op);
[[nodiscard]] VkStencilOp to_vk(StencilOp op);
[[nodiscard]] VkColorComponentFlags write_mask_to_vk(uint8_t mask);
// Vulkan 1.3 has no LOAD_OP_NONE: `none` keeps the content by loading it.
[[nodiscard]] VkAttachmentLoadOp to_vk(LoadOp op);
[[nodiscard]] VkAttachmentStoreOp to_vk(StoreOp op);

}  // namespace weft::vk
