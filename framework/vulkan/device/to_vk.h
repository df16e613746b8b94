// Purpose: the only translation of Weft's enumerations to Vulkan's, and back for formats. Every enumerator
// has an entry. Masks are translated bit by bit.
#pragma once

#include "vulkan/device/functions.h"
#include "weft/access.h"
#include "weft/declaration.h"
#include "weft/format.h"
#include "weft/plan.h"
#include "weft/shader_interface.h"

namespace weft::vk {

[[nodiscard]] VkFormat to_vk(Format format);
[[nodiscard]] Format from_vk(VkFormat format);  // undefined for a format that graphs cannot name

[[nodiscard]] VkImageLayout to_vk(Layout layout);
[[nodiscard]] VkPipelineStageFlags2 stages_to_vk(StageMask stages);
[[nodiscard]] VkAccessFlags2 access_to_vk(AccessMask access);
[[nodiscard]] VkImageAspectFlags aspects_to_vk(AspectMask aspects);
[[nodiscard]] VkImageSubresourceRange to_vk(const SubresourceRange& range);
// The layers of one mip, for copies.
[[nodiscard]] VkImageSubresourceLayers layers_to_vk(const SubresourceRange& range);

[[nodiscard]] VkImageUsageFlags image_usage_to_vk(
    UsageMask usage);  // bits that only apply to buffers are ignored
[[nodiscard]] VkBufferUsageFlags buffer_usage_to_vk(UsageMask usage);  // bits that only apply to images
                                                                       // (kSampled, attachments) are ignored
[[nodiscard]] VkImageType image_type_to_vk(ImageKind kind);
[[nodiscard]] VkImageViewType view_type_to_vk(ImageKind kind);
[[nodiscard]] VkSampleCountFlagBits samples_to_vk(uint32_t samples);  // 1, 2, 4, … 64
[[nodiscard]] VkExtent3D to_vk(const Extent3D& extent);

[[nodiscard]] VkShaderStageFlagBits to_vk(ShaderStage stage);
[[nodiscard]] VkShaderStageFlags shader_stages_to_vk(ShaderStageMask stages);
// A sampled image is a combined image sampler.
[[nodiscard]] VkDescriptorType to_vk(BindingKind kind);

[[nodiscard]] VkFilter to_vk(SamplerFilter filter);
[[nodiscard]] VkSamplerMipmapMode mip_filter_to_vk(SamplerFilter filter);
[[nodiscard]] VkSamplerAddressMode to_vk(SamplerWrap wrap);

[[nodiscard]] VkCompareOp to_vk(CompareOp op);
// For `material` the cull mode is set for each draw; the initial value is no culling.
[[nodiscard]] VkCullModeFlags to_vk(CullMode mode);
[[nodiscard]] VkFrontFace to_vk(FrontFace face);
[[nodiscard]] VkPrimitiveTopology to_vk(Topology topology);
[[nodiscard]] VkPolygonMode to_vk(FillMode mode);
[[nodiscard]] VkBlendFactor to_vk(BlendFactor factor);
[[nodiscard]] VkBlendOp to_vk(BlendOp op);
[[nodiscard]] VkStencilOp to_vk(StencilOp op);
[[nodiscard]] VkColorComponentFlags write_mask_to_vk(uint8_t mask);
// Vulkan 1.3 has no LOAD_OP_NONE, so `none` becomes a load, which also keeps the content.
[[nodiscard]] VkAttachmentLoadOp to_vk(LoadOp op);
[[nodiscard]] VkAttachmentStoreOp to_vk(StoreOp op);

}  // namespace weft::vk
