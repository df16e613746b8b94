#include <algorithm>
#include <array>
#include <utility>

#include "vulkan/device/functions.h"
#include "vulkan/device/physical_device.h"
#include "vulkan/device/to_vk.h"
#include "weft/vulkan/device_features.h"

namespace weft::vk {
namespace {

namespace ff = format_feature;

constexpr std::array<std::pair<VkFormatFeatureFlagBits, FormatFeatureMask>, 11> kFeatureBits{{
    {VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT, ff::kSampled},
    {VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT, ff::kSampledLinear},
    {VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_MINMAX_BIT, ff::kSampledMinMax},
    {VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT, ff::kStorage},
    {VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT, ff::kColorAttachment},
    {VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT, ff::kColorBlend},
    {VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT, ff::kDepthAttachment},
    {VK_FORMAT_FEATURE_TRANSFER_SRC_BIT, ff::kTransferSrc},
    {VK_FORMAT_FEATURE_TRANSFER_DST_BIT, ff::kTransferDst},
    {VK_FORMAT_FEATURE_BLIT_SRC_BIT, ff::kBlitSrc},
    {VK_FORMAT_FEATURE_BLIT_DST_BIT, ff::kBlitDst},
}};

FormatFeatureMask features_from_vk(VkFormatFeatureFlags flags) {
    FormatFeatureMask mask = 0;
    for (const auto& [bit, feature] : kFeatureBits) {
        if ((flags & bit) != 0) mask |= feature;
    }
    return mask;
}

void add_formats(const InstanceFunctions& fn, VkPhysicalDevice physical, DeviceProfile& profile) {
    for (const std::string& name : format_names()) {
        const Format format = *format_from_name(name);
        VkFormatProperties properties{};
        fn.vkGetPhysicalDeviceFormatProperties(physical, to_vk(format), &properties);
        const FormatFeatureMask features = features_from_vk(properties.optimalTilingFeatures);
        if (features != 0) profile.formats[format] = features;
    }
}

void add_limits(const VkPhysicalDeviceLimits& limits, DeviceProfile& profile) {
    profile.max_image_2d_px = limits.maxImageDimension2D;
    profile.max_image_layers = limits.maxImageArrayLayers;
    profile.max_push_constants_bytes = limits.maxPushConstantsSize;
    profile.max_color_attachments = limits.maxColorAttachments;
    profile.color_samples = limits.framebufferColorSampleCounts & limits.sampledImageColorSampleCounts;
    profile.depth_samples = limits.framebufferDepthSampleCounts & limits.framebufferStencilSampleCounts &
                            limits.sampledImageDepthSampleCounts;
    profile.max_workgroup_invocations = limits.maxComputeWorkGroupInvocations;
    profile.max_shared_bytes = limits.maxComputeSharedMemorySize;
    profile.max_sampled_images_per_stage = limits.maxPerStageDescriptorSampledImages;
    profile.max_storage_images_per_stage = limits.maxPerStageDescriptorStorageImages;
    // Each texture of a table is a combined image sampler, which counts as an image and as a sampler.
    profile.texture_table = std::min({limits.maxPerStageDescriptorSampledImages,
                                      limits.maxPerStageDescriptorSamplers, limits.maxPerStageResources,
                                      limits.maxDescriptorSetSampledImages, limits.maxDescriptorSetSamplers});
    profile.max_sampler_anisotropy = limits.maxSamplerAnisotropy;
    profile.max_sampler_lod_bias = limits.maxSamplerLodBias;
    profile.max_uniform_buffer_bytes = limits.maxUniformBufferRange;
    profile.max_storage_buffer_bytes = limits.maxStorageBufferRange;
    profile.buffer_image_granularity_bytes = limits.bufferImageGranularity;
    profile.max_draw_indirect_count = limits.maxDrawIndirectCount;
    profile.max_output_layers = std::min(limits.maxFramebufferLayers, limits.maxImageArrayLayers);
    profile.storage_offset_alignment_bytes = limits.minStorageBufferOffsetAlignment;
    profile.uniform_offset_alignment_bytes = limits.minUniformBufferOffsetAlignment;
}

namespace sc = shader_capability;

constexpr std::array<std::pair<VkSubgroupFeatureFlagBits, ShaderCapabilityMask>, 7> kSubgroupBits{{
    {VK_SUBGROUP_FEATURE_VOTE_BIT, sc::kSubgroupVote},
    {VK_SUBGROUP_FEATURE_ARITHMETIC_BIT, sc::kSubgroupArithmetic},
    {VK_SUBGROUP_FEATURE_BALLOT_BIT, sc::kSubgroupBallot},
    {VK_SUBGROUP_FEATURE_SHUFFLE_BIT, sc::kSubgroupShuffle},
    {VK_SUBGROUP_FEATURE_SHUFFLE_RELATIVE_BIT, sc::kSubgroupShuffleRelative},
    {VK_SUBGROUP_FEATURE_CLUSTERED_BIT, sc::kSubgroupClustered},
    {VK_SUBGROUP_FEATURE_QUAD_BIT, sc::kSubgroupQuad},
}};

// Reads the supported subgroup operations from the device's properties, because Vulkan has no feature that
// enables them.
ShaderCapabilityMask subgroup_capabilities(const VkPhysicalDeviceVulkan11Properties& properties) {
    if ((properties.subgroupSupportedStages & VK_SHADER_STAGE_COMPUTE_BIT) == 0) return 0;
    ShaderCapabilityMask mask = 0;
    for (const auto& [bit, capability] : kSubgroupBits) {
        if ((properties.subgroupSupportedOperations & bit) != 0) mask |= capability;
    }
    return mask;
}

void add_queue_families(const InstanceFunctions& fn, VkPhysicalDevice physical, DeviceProfile& profile) {
    uint32_t count = 0;
    fn.vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    fn.vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    profile.queue_families.clear();
    for (const VkQueueFamilyProperties& family : families) {
        const bool computes = (family.queueFlags & VK_QUEUE_COMPUTE_BIT) != 0;
        const bool draws = (family.queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0;
        // Weft requires that a graphics queue can run every pass, compute passes included. So a family that
        // draws but cannot compute is treated as a transfer family.
        const QueueKind kind = draws && computes ? QueueKind::graphics
                               : computes        ? QueueKind::compute
                                                 : QueueKind::transfer;
        profile.queue_families.push_back({kind, family.queueCount});
    }
}

}  // namespace

void add_optional_features(const OptionalFeatures& enabled, DeviceProfile& profile) {
    profile.storage_read_without_format = enabled.storage_read_without_format;
    profile.non_solid_fill = enabled.fill_mode_non_solid;
    profile.depth_clamp = enabled.depth_clamp;
    profile.depth_bias_clamp = enabled.depth_bias_clamp;
    profile.draw_indirect_count = enabled.draw_indirect_count;
    if (!enabled.texture_tables()) profile.texture_table = 0;
    if (!enabled.multiview) profile.max_multiview_views = 1;
    if (!enabled.output_layer) profile.max_output_layers = 1;
    if (!enabled.sampler_anisotropy) profile.max_sampler_anisotropy = 1;
    if (!enabled.sampler_min_max)
        for (auto& [format, features] : profile.formats) features &= ~ff::kSampledMinMax;
    const auto set = [&](ShaderCapabilityMask bit, bool has) {
        profile.shader_capabilities =
            has ? profile.shader_capabilities | bit : profile.shader_capabilities & ~bit;
    };
    set(sc::kImageGatherExtended, enabled.image_gather_extended);
    set(sc::kImageCubeArray, enabled.cube_arrays);
}

DeviceProfile make_profile(const InstanceFunctions& fn, VkPhysicalDevice physical) {
    VkPhysicalDeviceVulkan12Properties v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES};
    VkPhysicalDeviceVulkan11Properties v11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES, &v12};
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &v11;
    fn.vkGetPhysicalDeviceProperties2(physical, &properties);
    FeatureChain supported;
    fn.vkGetPhysicalDeviceFeatures2(physical, &supported.head());

    DeviceProfile profile;
    profile.name = properties.properties.deviceName;
    add_queue_families(fn, physical, profile);
    add_formats(fn, physical, profile);
    add_limits(properties.properties.limits, profile);
    profile.integer_samples = v12.framebufferIntegerColorSampleCounts &
                              properties.properties.limits.sampledImageIntegerSampleCounts;
    profile.shader_capabilities = subgroup_capabilities(v11);
    // Vulkan's mask of views has 32 bits. Weft counts llvmpipe (Mesa 22.3) as a device without multiview,
    // because it has a fault: it draws the clipped triangles of all views into the first view.
    const bool clips_wrong = v12.driverID == VK_DRIVER_ID_MESA_LLVMPIPE;
    profile.max_multiview_views = clips_wrong ? 1 : std::min(v11.maxMultiviewViewCount, 32u);
    FeatureChain all;
    add_optional_features(enable_optional_features(supported, all), profile);
    profile.descriptor_indexing = supported.v12().descriptorIndexing == VK_TRUE;
    return profile;
}

}  // namespace weft::vk
