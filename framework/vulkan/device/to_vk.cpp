#include "vulkan/device/to_vk.h"

#include <array>
#include <cassert>
#include <cstddef>

namespace weft::vk {
namespace {

// Translates each set bit of `mask`. `bits` has the Vulkan flag of each bit of `mask`, lowest bit first.
// `Flags` may be 32 or 64 bits wide.
template <class Flags, class Mask, size_t N>
Flags translate_bits(Mask mask, const std::array<Flags, N>& bits) {
    assert((static_cast<uint64_t>(mask) >> N) == 0);
    Flags flags = 0;
    for (size_t i = 0; i < N; ++i) {
        if (((static_cast<uint64_t>(mask) >> i) & 1u) != 0) flags |= bits[i];
    }
    return flags;
}

// Returns the element of `table` whose index is the number of the enumerator `value`.
template <class To, class From, size_t N>
To look_up(From value, const std::array<To, N>& table) {
    const auto index = static_cast<size_t>(value);
    assert(index < N);
    return table[index];
}

template <auto Last>
constexpr size_t kCountTo = static_cast<size_t>(Last) + 1;

constexpr std::array<VkFormat, kCountTo<Format::rgb32i>> kFormats{
    VK_FORMAT_UNDEFINED,
    VK_FORMAT_R8_UNORM,
    VK_FORMAT_R8G8_UNORM,
    VK_FORMAT_R8G8B8A8_UNORM,
    VK_FORMAT_R8G8B8A8_SRGB,
    VK_FORMAT_B8G8R8A8_UNORM,
    VK_FORMAT_B8G8R8A8_SRGB,
    VK_FORMAT_R8_SNORM,
    VK_FORMAT_R8G8_SNORM,
    VK_FORMAT_R8G8B8A8_SNORM,
    VK_FORMAT_R8_UINT,
    VK_FORMAT_R8G8_UINT,
    VK_FORMAT_R8G8B8A8_UINT,
    VK_FORMAT_R16_UNORM,
    VK_FORMAT_R16G16_UNORM,
    VK_FORMAT_R16G16B16A16_UNORM,
    VK_FORMAT_R16G16_SNORM,
    VK_FORMAT_R16G16B16A16_SNORM,
    VK_FORMAT_R16_SFLOAT,
    VK_FORMAT_R16G16_SFLOAT,
    VK_FORMAT_R16G16B16A16_SFLOAT,
    VK_FORMAT_R16_UINT,
    VK_FORMAT_R16G16_UINT,
    VK_FORMAT_R16G16B16A16_UINT,
    VK_FORMAT_R32_SFLOAT,
    VK_FORMAT_R32G32_SFLOAT,
    VK_FORMAT_R32G32B32A32_SFLOAT,
    VK_FORMAT_R32_UINT,
    VK_FORMAT_R32G32_UINT,
    VK_FORMAT_R32G32B32A32_UINT,
    VK_FORMAT_R32_SINT,
    VK_FORMAT_R32G32_SINT,
    VK_FORMAT_R32G32B32A32_SINT,
    VK_FORMAT_A2B10G10R10_UNORM_PACK32,
    VK_FORMAT_B10G11R11_UFLOAT_PACK32,
    VK_FORMAT_E5B9G9R9_UFLOAT_PACK32,
    VK_FORMAT_D16_UNORM,
    VK_FORMAT_D32_SFLOAT,
    VK_FORMAT_D32_SFLOAT_S8_UINT,
    VK_FORMAT_D24_UNORM_S8_UINT,
    VK_FORMAT_S8_UINT,
    VK_FORMAT_R32G32B32_SFLOAT,
    VK_FORMAT_R32G32B32_UINT,
    VK_FORMAT_R32G32B32_SINT,
};

constexpr std::array<VkImageLayout, kCountTo<Layout::present>> kLayouts{
    VK_IMAGE_LAYOUT_UNDEFINED,
    VK_IMAGE_LAYOUT_GENERAL,
    VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
    VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
    VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL,
    VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
    VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
    VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
    VK_IMAGE_LAYOUT_PRESENT_SRC_KHR,
};

constexpr std::array<VkPipelineStageFlags2, stage::kCount> kStages{
    VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT,
    VK_PIPELINE_STAGE_2_VERTEX_INPUT_BIT,
    VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT,
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT,
    VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
    VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
    VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
    VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
    VK_PIPELINE_STAGE_2_COPY_BIT,
    VK_PIPELINE_STAGE_2_BLIT_BIT,
    VK_PIPELINE_STAGE_2_RESOLVE_BIT,
    VK_PIPELINE_STAGE_2_CLEAR_BIT,
    VK_PIPELINE_STAGE_2_HOST_BIT,
};

constexpr std::array<VkAccessFlags2, access::kCount> kAccesses{
    VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT,
    VK_ACCESS_2_INDEX_READ_BIT,
    VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT,
    VK_ACCESS_2_UNIFORM_READ_BIT,
    VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
    VK_ACCESS_2_SHADER_STORAGE_READ_BIT,
    VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
    VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT,
    VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
    VK_ACCESS_2_TRANSFER_READ_BIT,
    VK_ACCESS_2_TRANSFER_WRITE_BIT,
    VK_ACCESS_2_HOST_READ_BIT,
    VK_ACCESS_2_HOST_WRITE_BIT,
};

constexpr std::array<VkImageAspectFlags, 3> kAspects{VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_ASPECT_DEPTH_BIT,
                                                     VK_IMAGE_ASPECT_STENCIL_BIT};

constexpr std::array<VkImageUsageFlags, 10> kImageUsages{VK_IMAGE_USAGE_SAMPLED_BIT,
                                                         VK_IMAGE_USAGE_STORAGE_BIT,
                                                         VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                                                         VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                                                         VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                                                         VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                                         0,
                                                         0,
                                                         0,
                                                         0};

constexpr std::array<VkBufferUsageFlags, 10> kBufferUsages{0,
                                                           VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                                           0,
                                                           0,
                                                           VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                                           VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                                           VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                                                           VK_BUFFER_USAGE_VERTEX_BUFFER_BIT,
                                                           VK_BUFFER_USAGE_INDEX_BUFFER_BIT,
                                                           VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT};

constexpr std::array<VkImageViewType, kCountTo<ImageKind::d3>> kViewTypes{
    VK_IMAGE_VIEW_TYPE_2D, VK_IMAGE_VIEW_TYPE_2D_ARRAY, VK_IMAGE_VIEW_TYPE_CUBE,
    VK_IMAGE_VIEW_TYPE_CUBE_ARRAY, VK_IMAGE_VIEW_TYPE_3D};

constexpr std::array<VkShaderStageFlagBits, kCountTo<ShaderStage::compute>> kShaderStages{
    VK_SHADER_STAGE_VERTEX_BIT, VK_SHADER_STAGE_FRAGMENT_BIT, VK_SHADER_STAGE_COMPUTE_BIT};

constexpr std::array<VkDescriptorType, kCountTo<BindingKind::storage_buffer>> kDescriptors{
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,
    VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};

constexpr std::array<VkSamplerAddressMode, kCountTo<SamplerWrap::border>> kWraps{
    VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE, VK_SAMPLER_ADDRESS_MODE_REPEAT,
    VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER};

constexpr std::array<VkCompareOp, kCountTo<CompareOp::always>> kCompareOps{VK_COMPARE_OP_NEVER,
                                                                           VK_COMPARE_OP_LESS,
                                                                           VK_COMPARE_OP_EQUAL,
                                                                           VK_COMPARE_OP_LESS_OR_EQUAL,
                                                                           VK_COMPARE_OP_GREATER,
                                                                           VK_COMPARE_OP_NOT_EQUAL,
                                                                           VK_COMPARE_OP_GREATER_OR_EQUAL,
                                                                           VK_COMPARE_OP_ALWAYS};

constexpr std::array<VkCullModeFlags, kCountTo<CullMode::material>> kCullModes{
    VK_CULL_MODE_NONE, VK_CULL_MODE_FRONT_BIT, VK_CULL_MODE_BACK_BIT, VK_CULL_MODE_NONE};

constexpr std::array<VkFrontFace, kCountTo<FrontFace::clockwise>> kFrontFaces{VK_FRONT_FACE_COUNTER_CLOCKWISE,
                                                                              VK_FRONT_FACE_CLOCKWISE};

constexpr std::array<VkPrimitiveTopology, kCountTo<Topology::points>> kTopologies{
    VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
    VK_PRIMITIVE_TOPOLOGY_LINE_LIST, VK_PRIMITIVE_TOPOLOGY_LINE_STRIP, VK_PRIMITIVE_TOPOLOGY_POINT_LIST};

constexpr std::array<VkPolygonMode, kCountTo<FillMode::point>> kFillModes{
    VK_POLYGON_MODE_FILL, VK_POLYGON_MODE_LINE, VK_POLYGON_MODE_POINT};

constexpr std::array<VkBlendFactor, kCountTo<BlendFactor::one_minus_dst_alpha>> kBlendFactors{
    VK_BLEND_FACTOR_ZERO,      VK_BLEND_FACTOR_ONE,
    VK_BLEND_FACTOR_SRC_COLOR, VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR,
    VK_BLEND_FACTOR_DST_COLOR, VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR,
    VK_BLEND_FACTOR_SRC_ALPHA, VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
    VK_BLEND_FACTOR_DST_ALPHA, VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA,
};

constexpr std::array<VkBlendOp, kCountTo<BlendOp::max>> kBlendOps{
    VK_BLEND_OP_ADD, VK_BLEND_OP_SUBTRACT, VK_BLEND_OP_REVERSE_SUBTRACT, VK_BLEND_OP_MIN, VK_BLEND_OP_MAX};

constexpr std::array<VkStencilOp, kCountTo<StencilOp::decrement_wrap>> kStencilOps{
    VK_STENCIL_OP_KEEP,
    VK_STENCIL_OP_ZERO,
    VK_STENCIL_OP_REPLACE,
    VK_STENCIL_OP_INCREMENT_AND_CLAMP,
    VK_STENCIL_OP_DECREMENT_AND_CLAMP,
    VK_STENCIL_OP_INVERT,
    VK_STENCIL_OP_INCREMENT_AND_WRAP,
    VK_STENCIL_OP_DECREMENT_AND_WRAP,
};

constexpr std::array<VkAttachmentLoadOp, kCountTo<LoadOp::none>> kLoadOps{
    VK_ATTACHMENT_LOAD_OP_LOAD, VK_ATTACHMENT_LOAD_OP_CLEAR, VK_ATTACHMENT_LOAD_OP_DONT_CARE,
    VK_ATTACHMENT_LOAD_OP_LOAD};

constexpr std::array<VkAttachmentStoreOp, kCountTo<StoreOp::none>> kStoreOps{
    VK_ATTACHMENT_STORE_OP_STORE, VK_ATTACHMENT_STORE_OP_DONT_CARE, VK_ATTACHMENT_STORE_OP_NONE};

}  // namespace

VkFormat to_vk(Format format) {
    return look_up(format, kFormats);
}

Format from_vk(VkFormat format) {
    for (size_t i = 0; i < kFormats.size(); ++i) {
        if (kFormats[i] == format) return static_cast<Format>(i);
    }
    return Format::undefined;
}

VkImageLayout to_vk(Layout layout) {
    return look_up(layout, kLayouts);
}
VkPipelineStageFlags2 stages_to_vk(StageMask stages) {
    return translate_bits(stages, kStages);
}
VkAccessFlags2 access_to_vk(AccessMask access) {
    return translate_bits(access, kAccesses);
}
VkImageAspectFlags aspects_to_vk(AspectMask aspects) {
    return translate_bits(aspects, kAspects);
}

VkImageSubresourceRange to_vk(const SubresourceRange& range) {
    return {aspects_to_vk(range.aspects), range.mip, range.mips, range.layer, range.layers};
}

VkImageSubresourceLayers layers_to_vk(const SubresourceRange& range) {
    return {aspects_to_vk(range.aspects), range.mip, range.layer, range.layers};
}

VkImageUsageFlags image_usage_to_vk(UsageMask usage) {
    return translate_bits(usage, kImageUsages);
}
VkBufferUsageFlags buffer_usage_to_vk(UsageMask usage) {
    return translate_bits(usage, kBufferUsages);
}

VkImageType image_type_to_vk(ImageKind kind) {
    return kind == ImageKind::d3 ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D;
}

VkImageViewType view_type_to_vk(ImageKind kind) {
    return look_up(kind, kViewTypes);
}

VkSampleCountFlagBits samples_to_vk(uint32_t samples) {
    assert(samples >= 1 && samples <= 64 && (samples & (samples - 1)) == 0);
    // Each of Vulkan's sample-count bits equals its sample count: VK_SAMPLE_COUNT_4_BIT is 4.
    return static_cast<VkSampleCountFlagBits>(samples);
}

VkExtent3D to_vk(const Extent3D& extent) {
    return {extent.width, extent.height, extent.depth};
}

VkShaderStageFlagBits to_vk(ShaderStage stage) {
    return look_up(stage, kShaderStages);
}

VkShaderStageFlags shader_stages_to_vk(ShaderStageMask stages) {
    constexpr std::array<VkShaderStageFlags, kShaderStages.size()> bits{kShaderStages[0], kShaderStages[1],
                                                                        kShaderStages[2]};
    return translate_bits(stages, bits);
}

VkDescriptorType to_vk(BindingKind kind) {
    return look_up(kind, kDescriptors);
}

VkFilter to_vk(SamplerFilter filter) {
    return filter == SamplerFilter::linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
}

VkSamplerReductionMode to_vk(SamplerReduction reduction) {
    switch (reduction) {
        case SamplerReduction::average:
            break;
        case SamplerReduction::min:
            return VK_SAMPLER_REDUCTION_MODE_MIN;
        case SamplerReduction::max:
            return VK_SAMPLER_REDUCTION_MODE_MAX;
    }
    return VK_SAMPLER_REDUCTION_MODE_WEIGHTED_AVERAGE;
}

VkSamplerMipmapMode mip_filter_to_vk(SamplerFilter filter) {
    return filter == SamplerFilter::linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
}

VkSamplerAddressMode to_vk(SamplerWrap wrap) {
    return look_up(wrap, kWraps);
}
VkCompareOp to_vk(CompareOp op) {
    return look_up(op, kCompareOps);
}
VkCullModeFlags to_vk(CullMode mode) {
    return look_up(mode, kCullModes);
}
VkFrontFace to_vk(FrontFace face) {
    return look_up(face, kFrontFaces);
}
VkPrimitiveTopology to_vk(Topology topology) {
    return look_up(topology, kTopologies);
}
VkPolygonMode to_vk(FillMode mode) {
    return look_up(mode, kFillModes);
}
VkBlendFactor to_vk(BlendFactor factor) {
    return look_up(factor, kBlendFactors);
}
VkBlendOp to_vk(BlendOp op) {
    return look_up(op, kBlendOps);
}
VkStencilOp to_vk(StencilOp op) {
    return look_up(op, kStencilOps);
}
VkColorComponentFlags write_mask_to_vk(uint8_t mask) {
    // Weft and Vulkan number the components with the same bits: red 1, green 2, blue 4, alpha 8.
    return mask & 0xFu;
}
VkAttachmentLoadOp to_vk(LoadOp op) {
    return look_up(op, kLoadOps);
}
VkAttachmentStoreOp to_vk(StoreOp op) {
    return look_up(op, kStoreOps);
}

}  // namespace weft::vk
