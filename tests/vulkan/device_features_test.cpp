// Purpose: tests the features with which the Vulkan device is created. The features for shaders must be
// exactly those that the SPIR-V gate allows shaders to use (framework/shader/capability_table.cpp). Features
// that no graph can use must be off.
#include "weft/vulkan/device_features.h"

#include <gtest/gtest.h>

#include <cstring>

#include "vulkan/device/physical_device.h"

namespace weft::vk {
namespace {

template <class Struct>
void switch_all_on(Struct& features, VkBool32 Struct::*first) {
    VkBool32* begin = &(features.*first);
    const auto* end = reinterpret_cast<const std::byte*>(&features) + sizeof(features);
    for (VkBool32* feature = begin; reinterpret_cast<const std::byte*>(feature + 1) <= end; ++feature)
        *feature = VK_TRUE;
}

// Marks all features in the chain as supported by the physical device.
void offer_all(FeatureChain& chain) {
    switch_all_on(chain.v10(), &VkPhysicalDeviceFeatures::robustBufferAccess);
    switch_all_on(chain.v11(), &VkPhysicalDeviceVulkan11Features::storageBuffer16BitAccess);
    switch_all_on(chain.v12(), &VkPhysicalDeviceVulkan12Features::samplerMirrorClampToEdge);
    switch_all_on(chain.v13(), &VkPhysicalDeviceVulkan13Features::robustImageAccess);
}

class MadeWith : public testing::Test {
 protected:
    MadeWith() {
        FeatureChain supported;
        offer_all(supported);
        required_features(enabled_);
        optional_ = enable_optional_features(supported, enabled_);
    }
    FeatureChain enabled_;
    OptionalFeatures optional_;
};

TEST_F(MadeWith, NothingThatTheGateRefuses) {
    const VkPhysicalDeviceFeatures& v10 = enabled_.v10();
    for (const VkBool32 feature :
         {v10.shaderFloat64, v10.shaderInt64, v10.shaderInt16, v10.shaderClipDistance, v10.shaderCullDistance,
          v10.sampleRateShading, v10.geometryShader, v10.tessellationShader, v10.multiViewport,
          v10.shaderStorageImageMultisample, v10.shaderResourceResidency, v10.shaderResourceMinLod,
          v10.vertexPipelineStoresAndAtomics, v10.shaderTessellationAndGeometryPointSize})
        EXPECT_EQ(feature, VK_FALSE);
    // The memory comparison checks the features of Vulkan 1.1 at once: 16-bit storage, variable pointers,
    // draw parameters and others. All must be off, except multiview: the gate refuses shaders that use it,
    // but Weft itself adds it to shaders (lowered_views.h). The same holds for shaderOutputLayer.
    const VkPhysicalDeviceVulkan11Features none{};
    VkPhysicalDeviceVulkan11Features v11 = enabled_.v11();
    v11.multiview = VK_FALSE;
    EXPECT_EQ(
        std::memcmp(&v11.storageBuffer16BitAccess, &none.storageBuffer16BitAccess,
                    sizeof(none) - offsetof(VkPhysicalDeviceVulkan11Features, storageBuffer16BitAccess)),
        0);
    const VkPhysicalDeviceVulkan12Features& v12 = enabled_.v12();
    for (const VkBool32 feature :
         {v12.bufferDeviceAddress, v12.bufferDeviceAddressCaptureReplay, v12.shaderBufferInt64Atomics,
          v12.shaderSharedInt64Atomics, v12.shaderFloat16, v12.shaderInt8, v12.storageBuffer8BitAccess,
          v12.uniformAndStorageBuffer8BitAccess, v12.storagePushConstant8, v12.descriptorIndexing,
          v12.vulkanMemoryModel, v12.vulkanMemoryModelDeviceScope, v12.shaderOutputViewportIndex,
          v12.shaderSubgroupExtendedTypes, v12.scalarBlockLayout,
          v12.shaderStorageImageArrayNonUniformIndexing})
        EXPECT_EQ(feature, VK_FALSE);
    EXPECT_EQ(enabled_.v13().shaderZeroInitializeWorkgroupMemory, VK_FALSE);
    EXPECT_EQ(enabled_.v13().shaderIntegerDotProduct, VK_FALSE);
}

TEST_F(MadeWith, BuffersThatNoIndexLeaves) {
    EXPECT_EQ(enabled_.v10().robustBufferAccess, VK_TRUE);
    const FeatureChain nothing;
    FeatureChain least;
    enable_features(nothing, least);
    EXPECT_EQ(least.v10().robustBufferAccess, VK_FALSE) << "where the device does not offer it";
}

// No graph can use these features, so they must be off.
TEST_F(MadeWith, NothingThatNoGraphCanUse) {
    const VkPhysicalDeviceFeatures& v10 = enabled_.v10();
    for (const VkBool32 feature :
         {v10.dualSrcBlend, v10.logicOp, v10.depthBounds, v10.wideLines, v10.largePoints, v10.alphaToOne,
          v10.sparseBinding, v10.inheritedQueries, v10.pipelineStatisticsQuery, v10.occlusionQueryPrecise,
          v10.fullDrawIndexUint32})
        EXPECT_EQ(feature, VK_FALSE);
    for (const VkBool32 feature :
         {enabled_.v12().samplerMirrorClampToEdge, enabled_.v12().imagelessFramebuffer})
        EXPECT_EQ(feature, VK_FALSE);
}

TEST_F(MadeWith, AllThatTheGateAlwaysAllows) {
    EXPECT_EQ(enabled_.v10().fragmentStoresAndAtomics, VK_TRUE);
    EXPECT_EQ(enabled_.v10().shaderStorageImageExtendedFormats, VK_TRUE);
    EXPECT_EQ(enabled_.v10().shaderStorageImageWriteWithoutFormat, VK_TRUE);
    EXPECT_EQ(enabled_.v13().shaderDemoteToHelperInvocation, VK_TRUE);
    EXPECT_EQ(enabled_.v13().shaderTerminateInvocation, VK_TRUE);
}

TEST_F(MadeWith, WhatTheProfileSaysThatGraphsMayUse) {
    DeviceProfile profile;
    profile.max_sampler_anisotropy = 16;
    profile.formats[Format::r32f] = format_feature::kSampled | format_feature::kSampledMinMax;
    profile.max_multiview_views = 6;
    profile.max_output_layers = 256;
    add_optional_features(optional_, profile);
    EXPECT_EQ(enabled_.v10().imageCubeArray, VK_TRUE);
    EXPECT_EQ(enabled_.v10().shaderImageGatherExtended, VK_TRUE);
    EXPECT_EQ(enabled_.v10().shaderStorageImageReadWithoutFormat, VK_TRUE);
    EXPECT_EQ(profile.shader_capabilities,
              shader_capability::kImageCubeArray | shader_capability::kImageGatherExtended);
    EXPECT_TRUE(profile.storage_read_without_format);
    EXPECT_EQ(enabled_.v10().samplerAnisotropy, VK_TRUE);
    EXPECT_EQ(enabled_.v12().samplerFilterMinmax, VK_TRUE);
    EXPECT_EQ(profile.max_sampler_anisotropy, 16.0F);
    EXPECT_EQ(enabled_.v11().multiview, VK_TRUE);
    EXPECT_EQ(enabled_.v12().shaderOutputLayer, VK_TRUE);
    EXPECT_EQ(profile.max_multiview_views, 6u);
    EXPECT_EQ(profile.max_output_layers, 256u);
    EXPECT_NE(profile.features(Format::r32f) & format_feature::kSampledMinMax, 0u);
    EXPECT_TRUE(profile.non_solid_fill && profile.depth_clamp && profile.depth_bias_clamp);
    add_optional_features({}, profile);
    EXPECT_EQ(profile.shader_capabilities, 0u) << "a device that was made without them";
    EXPECT_FALSE(profile.storage_read_without_format);
    EXPECT_EQ(profile.max_sampler_anisotropy, 1.0F);
    EXPECT_EQ(profile.max_multiview_views, 1u);
    EXPECT_EQ(profile.max_output_layers, 1u);
    EXPECT_EQ(profile.features(Format::r32f), format_feature::kSampled);
    EXPECT_FALSE(profile.non_solid_fill || profile.depth_clamp || profile.depth_bias_clamp);
}

}  // namespace
}  // namespace weft::vk
