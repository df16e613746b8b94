#include <array>
#include <utility>

#include "vulkan/device_features.h"
#include "vulkan/physical_device.h"
#include "vulkan/to_vk.h"

namespace weft::vk {
namespace {

namespace ff = format_feature;

constexpr std::array<std::pair<VkFormatFeatureFlagBits, FormatFeatureMask>, 10> kFeatureBits{{
    {VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT, ff::kSampled},
    {VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT, ff::kSampledLinear},
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
    profile.max_sampled_images_per_stage = limits.maxPerStageDescriptorSampledImages;
    profile.max_storage_images_per_stage = limits.maxPerStageDescriptorStorageImages;
    profile.max_uniform_buffer_bytes = limits.maxUniformBufferRange;
    profile.max_storage_buffer_bytes = limits.maxStorageBufferRange;
    profile.buffer_image_granularity_bytes = limits.bufferImageGranularity;
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
        // A graphics queue runs every pass, so one that draws and can't compute counts for what is left.
        const QueueKind kind = draws && computes ? QueueKind::graphics
                               : computes        ? QueueKind::compute
                                                 : QueueKind::transfer;
        profile.queue_families.push_back({kind, family.queueCount});
    }
}

}  // namespace

DeviceProfile make_profile(const InstanceFunctions& fn, VkPhysicalDevice physical) {
    VkPhysicalDeviceVulkan12Properties v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES};
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &v12;
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
    profile.storage_read_without_format = supported.v10().shaderStorageImageReadWithoutFormat == VK_TRUE;
    profile.descriptor_indexing = supported.v12().descriptorIndexing == VK_TRUE;
    return profile;
}

}  // namespace weft::vk
