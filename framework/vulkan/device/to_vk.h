// Purpose: the only place where Weft's enumerations are translated to Vulkan's. Formats can also be
// translated back to Weft's. Every enumerator has a Vulkan value. Masks are translated bit by bit.
#pragma once

#include "vulkan/device/functions.h"
#include "weft/access.h"
#include "weft/declaration.h"
#include "weft/format.h"
#include "weft/plan.h"
#include "weft/shader_interface.h"

namespace weft::vk {

[[nodiscard]] VkFormat to_vk(Format format);
// Returns Format::undefined for a format that graphs cannot name.
[[nodiscard]] Format from_vk(VkFormat format);

[[nodiscard]] VkImageLayout to_vk(Layout layout);
[[nodiscard]] VkPipelineStageFlags2 stages_to_vk(StageMask stages);
[[nodiscard]] VkAccessFlags2 access_to_vk(AccessMask access);
[[nodiscard]] VkImageAspectFlags aspects_to_vk(AspectMask aspects);
[[nodiscard]] VkImageSubresourceRange to_vk(const SubresourceRange& range);
// Returns the layers of the one mip level range.mip, for copy commands.
[[nodiscard]] VkImageSubresourceLayers layers_to_vk(const SubresourceRange& range);

// Bits of `usage` that only apply to buffers are ignored.
[[nodiscard]] VkImageUsageFlags image_usage_to_vk(UsageMask usage);
// Bits of `usage` that only apply to images (kSampled and the attachment bits) are ignored.
[[nodiscard]] VkBufferUsageFlags buffer_usage_to_vk(UsageMask usage);

[[nodiscard]] VkImageType image_type_to_vk(ImageKind kind);
[[nodiscard]] VkImageViewType view_type_to_vk(ImageKind kind);
// `samples` is a power of two from 1 to 64.
[[nodiscard]] VkSampleCountFlagBits samples_to_vk(uint32_t samples);
[[nodiscard]] VkExtent3D to_vk(const Extent3D& extent);

[[nodiscard]] VkShaderStageFlagBits to_vk(ShaderStage stage);
[[nodiscard]] VkShaderStageFlags shader_stages_to_vk(ShaderStageMask stages);
// A sampled image becomes a combined image sampler: VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER.
[[nodiscard]] VkDescriptorType to_vk(BindingKind kind);

[[nodiscard]] VkFilter to_vk(SamplerFilter filter);
[[nodiscard]] VkSamplerReductionMode to_vk(SamplerReduction reduction);
[[nodiscard]] VkSamplerMipmapMode mip_filter_to_vk(SamplerFilter filter);
[[nodiscard]] VkSamplerAddressMode to_vk(SamplerWrap wrap);

[[nodiscard]] VkCompareOp to_vk(CompareOp op);
// CullMode::material means that every draw sets its own cull mode. It becomes VK_CULL_MODE_NONE, which is the
// cull mode before the first draw sets one.
[[nodiscard]] VkCullModeFlags to_vk(CullMode mode);
[[nodiscard]] VkFrontFace to_vk(FrontFace face);
[[nodiscard]] VkPrimitiveTopology to_vk(Topology topology);
[[nodiscard]] VkPolygonMode to_vk(FillMode mode);
[[nodiscard]] VkBlendFactor to_vk(BlendFactor factor);
[[nodiscard]] VkBlendOp to_vk(BlendOp op);
[[nodiscard]] VkStencilOp to_vk(StencilOp op);
[[nodiscard]] VkColorComponentFlags write_mask_to_vk(uint8_t mask);
// LoadOp::none becomes VK_ATTACHMENT_LOAD_OP_LOAD, which also keeps the content, because Vulkan 1.3 has no
// VK_ATTACHMENT_LOAD_OP_NONE.
[[nodiscard]] VkAttachmentLoadOp to_vk(LoadOp op);
[[nodiscard]] VkAttachmentStoreOp to_vk(StoreOp op);

}  // namespace weft::vk
