// Purpose: tests the tables that convert Weft's enumerations to Vulkan's. Every enumerator must have a Vulkan
// value. Two enumerators may have the same Vulkan value only where a test in this file allows it.
#include "vulkan/device/to_vk.h"

#include <gtest/gtest.h>

#include <set>

namespace weft::vk {
namespace {

// Returns how many different Vulkan values the enumerators from 0 to `last` have.
template <class Enum>
size_t distinct(Enum last) {
    std::set<int64_t> values;
    for (int i = 0; i <= static_cast<int>(last); ++i) {
        values.insert(static_cast<int64_t>(to_vk(static_cast<Enum>(i))));
    }
    return values.size();
}

template <class Enum>
size_t count(Enum last) {
    return static_cast<size_t>(last) + 1;
}

TEST(ToVk, every_format_has_one_of_its_own_and_comes_back) {
    EXPECT_EQ(distinct(Format::rgb32i), count(Format::rgb32i));
    for (int i = 1; i <= static_cast<int>(Format::rgb32i); ++i) {
        const auto format = static_cast<Format>(i);
        EXPECT_NE(to_vk(format), VK_FORMAT_UNDEFINED) << format_info(format).name;
        EXPECT_EQ(from_vk(to_vk(format)), format) << format_info(format).name;
    }
    EXPECT_EQ(from_vk(VK_FORMAT_G8B8G8R8_422_UNORM), Format::undefined);
}

TEST(ToVk, formats_mean_what_their_names_say) {
    EXPECT_EQ(to_vk(Format::rgba8_srgb), VK_FORMAT_R8G8B8A8_SRGB);
    EXPECT_EQ(to_vk(Format::rgba8u), VK_FORMAT_R8G8B8A8_UINT);
    EXPECT_EQ(to_vk(Format::rgba16f), VK_FORMAT_R16G16B16A16_SFLOAT);
    EXPECT_EQ(to_vk(Format::r32u), VK_FORMAT_R32_UINT);
    EXPECT_EQ(to_vk(Format::rgba32i), VK_FORMAT_R32G32B32A32_SINT);
    EXPECT_EQ(to_vk(Format::b10g11r11f), VK_FORMAT_B10G11R11_UFLOAT_PACK32);
    EXPECT_EQ(to_vk(Format::d32f), VK_FORMAT_D32_SFLOAT);
    EXPECT_EQ(to_vk(Format::s8), VK_FORMAT_S8_UINT);
    EXPECT_EQ(to_vk(Format::rgb32f), VK_FORMAT_R32G32B32_SFLOAT);
}

TEST(ToVk, every_enumerator_has_a_value_of_its_own) {
    EXPECT_EQ(distinct(Layout::present), count(Layout::present));
    EXPECT_EQ(distinct(ShaderStage::compute), count(ShaderStage::compute));
    EXPECT_EQ(distinct(BindingKind::storage_buffer), count(BindingKind::storage_buffer));
    EXPECT_EQ(distinct(SamplerFilter::linear), count(SamplerFilter::linear));
    EXPECT_EQ(distinct(SamplerReduction::max), count(SamplerReduction::max));
    EXPECT_EQ(distinct(SamplerWrap::border), count(SamplerWrap::border));
    EXPECT_EQ(distinct(CompareOp::always), count(CompareOp::always));
    EXPECT_EQ(distinct(FrontFace::clockwise), count(FrontFace::clockwise));
    EXPECT_EQ(distinct(Topology::points), count(Topology::points));
    EXPECT_EQ(distinct(FillMode::point), count(FillMode::point));
    EXPECT_EQ(distinct(BlendFactor::one_minus_dst_alpha), count(BlendFactor::one_minus_dst_alpha));
    EXPECT_EQ(distinct(BlendOp::max), count(BlendOp::max));
    EXPECT_EQ(distinct(StencilOp::decrement_wrap), count(StencilOp::decrement_wrap));
    EXPECT_EQ(distinct(StoreOp::none), count(StoreOp::none));
}

TEST(ToVk, two_pairs_share_a_value_on_purpose) {
    EXPECT_EQ(distinct(CullMode::material), count(CullMode::material) - 1);
    EXPECT_EQ(to_vk(CullMode::material), to_vk(CullMode::none));
    EXPECT_EQ(distinct(LoadOp::none), count(LoadOp::none) - 1);
    EXPECT_EQ(to_vk(LoadOp::none), to_vk(LoadOp::load));
}

TEST(ToVk, every_stage_and_access_bit_has_one_bit_of_its_own) {
    std::set<VkPipelineStageFlags2> stages;
    for (int i = 0; i < stage::kCount; ++i) stages.insert(stages_to_vk(1u << i));
    EXPECT_EQ(stages.size(), static_cast<size_t>(stage::kCount));
    EXPECT_FALSE(stages.contains(0));
    std::set<VkAccessFlags2> accesses;
    for (int i = 0; i < access::kCount; ++i) accesses.insert(access_to_vk(1u << i));
    EXPECT_EQ(accesses.size(), static_cast<size_t>(access::kCount));
    EXPECT_FALSE(accesses.contains(0));

    EXPECT_EQ(stages_to_vk(stage::kComputeShader | stage::kHost),
              VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_HOST_BIT);
    EXPECT_EQ(stages_to_vk(stage::kLateFragmentTests), VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT);
    EXPECT_EQ(access_to_vk(access::kStorageWrite | access::kHostWrite),
              VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_HOST_WRITE_BIT);
    EXPECT_EQ(stages_to_vk(stage::kNone), VK_PIPELINE_STAGE_2_NONE);
}

TEST(ToVk, usages_go_to_images_to_buffers_or_to_both) {
    for (int i = 0; i < 10; ++i) {
        const UsageMask bit = 1u << i;
        EXPECT_TRUE(image_usage_to_vk(bit) != 0 || buffer_usage_to_vk(bit) != 0) << "usage bit " << i;
    }
    EXPECT_EQ(image_usage_to_vk(usage::kSampled | usage::kTransferDst),
              static_cast<VkImageUsageFlags>(VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT));
    EXPECT_EQ(buffer_usage_to_vk(usage::kIndirect | usage::kStorage),
              static_cast<VkBufferUsageFlags>(VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
                                              VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
}

TEST(ToVk, image_kinds_samples_and_ranges) {
    EXPECT_EQ(view_type_to_vk(ImageKind::d2), VK_IMAGE_VIEW_TYPE_2D);
    EXPECT_EQ(view_type_to_vk(ImageKind::d2_array), VK_IMAGE_VIEW_TYPE_2D_ARRAY);
    EXPECT_EQ(view_type_to_vk(ImageKind::cube), VK_IMAGE_VIEW_TYPE_CUBE);
    EXPECT_EQ(view_type_to_vk(ImageKind::cube_array), VK_IMAGE_VIEW_TYPE_CUBE_ARRAY);
    EXPECT_EQ(view_type_to_vk(ImageKind::d3), VK_IMAGE_VIEW_TYPE_3D);
    EXPECT_EQ(image_type_to_vk(ImageKind::cube), VK_IMAGE_TYPE_2D);
    EXPECT_EQ(image_type_to_vk(ImageKind::d3), VK_IMAGE_TYPE_3D);
    EXPECT_EQ(samples_to_vk(4), VK_SAMPLE_COUNT_4_BIT);
    const VkImageSubresourceRange range =
        to_vk(SubresourceRange{1, 2, 3, 4, aspect::kDepth | aspect::kStencil});
    EXPECT_EQ(range.baseMipLevel, 1u);
    EXPECT_EQ(range.levelCount, 2u);
    EXPECT_EQ(range.baseArrayLayer, 3u);
    EXPECT_EQ(range.layerCount, 4u);
    EXPECT_EQ(range.aspectMask,
              static_cast<VkImageAspectFlags>(VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT));
}

}  // namespace
}  // namespace weft::vk
