// Purpose: the words of device profile files: the name of each feature, limit and switch, and the member of
// DeviceProfile that this name sets.
#pragma once

#include <array>
#include <cstdint>

#include "weft/device_profile.h"

namespace weft::profile_json {

namespace ff = format_feature;
namespace sc = shader_capability;

struct FeatureName {
    FormatFeatureMask bit;
    const char* name;
};
inline constexpr std::array kFeatureNames{
    FeatureName{ff::kSampled, "sampled"},       FeatureName{ff::kSampledLinear, "linear"},
    FeatureName{ff::kSampledMinMax, "minMax"},  FeatureName{ff::kStorage, "storage"},
    FeatureName{ff::kColorAttachment, "color"}, FeatureName{ff::kColorBlend, "blend"},
    FeatureName{ff::kDepthAttachment, "depth"}, FeatureName{ff::kTransferSrc, "copySrc"},
    FeatureName{ff::kTransferDst, "copyDst"},   FeatureName{ff::kBlitSrc, "blitSrc"},
    FeatureName{ff::kBlitDst, "blitDst"},
};

inline constexpr std::array<const char*, 3> kQueueNames{"graphics", "compute", "transfer"};

struct Limit {
    const char* name;
    uint32_t DeviceProfile::*value;
};
inline constexpr std::array kLimits{
    Limit{"maxImage2dPx", &DeviceProfile::max_image_2d_px},
    Limit{"maxImageLayers", &DeviceProfile::max_image_layers},
    Limit{"maxPushConstantsBytes", &DeviceProfile::max_push_constants_bytes},
    Limit{"maxColorAttachments", &DeviceProfile::max_color_attachments},
    Limit{"maxWorkgroupInvocations", &DeviceProfile::max_workgroup_invocations},
    Limit{"maxSharedBytes", &DeviceProfile::max_shared_bytes},
    Limit{"maxSampledImagesPerStage", &DeviceProfile::max_sampled_images_per_stage},
    Limit{"maxStorageImagesPerStage", &DeviceProfile::max_storage_images_per_stage},
    Limit{"textureTable", &DeviceProfile::texture_table},
    Limit{"maxDrawIndirectCount", &DeviceProfile::max_draw_indirect_count},
    Limit{"maxMultiviewViews", &DeviceProfile::max_multiview_views},
    Limit{"maxOutputLayers", &DeviceProfile::max_output_layers},
};
struct WideLimit {
    const char* name;
    uint64_t DeviceProfile::*value;
};
inline constexpr std::array kWideLimits{
    WideLimit{"maxUniformBufferBytes", &DeviceProfile::max_uniform_buffer_bytes},
    WideLimit{"maxStorageBufferBytes", &DeviceProfile::max_storage_buffer_bytes},
    WideLimit{"bufferImageGranularityBytes", &DeviceProfile::buffer_image_granularity_bytes},
};
struct RealLimit {
    const char* name;
    float DeviceProfile::*value;
};
inline constexpr std::array kRealLimits{
    RealLimit{"maxSamplerAnisotropy", &DeviceProfile::max_sampler_anisotropy},
    RealLimit{"maxSamplerLodBias", &DeviceProfile::max_sampler_lod_bias},
};
struct Switch {
    const char* name;
    bool DeviceProfile::*value;
};
inline constexpr std::array kSwitches{
    Switch{"storageReadWithoutFormat", &DeviceProfile::storage_read_without_format},
    Switch{"descriptorIndexing", &DeviceProfile::descriptor_indexing},
    Switch{"nonSolidFill", &DeviceProfile::non_solid_fill},
    Switch{"depthClamp", &DeviceProfile::depth_clamp},
    Switch{"depthBiasClamp", &DeviceProfile::depth_bias_clamp},
    Switch{"drawIndirectCount", &DeviceProfile::draw_indirect_count},
};

struct CapabilityName {
    ShaderCapabilityMask bit;
    const char* name;
};
inline constexpr std::array kCapabilityNames{
    CapabilityName{sc::kImageGatherExtended, "ImageGatherExtended"},
    CapabilityName{sc::kImageCubeArray, "ImageCubeArray"},
    CapabilityName{sc::kSubgroupVote, "GroupNonUniformVote"},
    CapabilityName{sc::kSubgroupArithmetic, "GroupNonUniformArithmetic"},
    CapabilityName{sc::kSubgroupBallot, "GroupNonUniformBallot"},
    CapabilityName{sc::kSubgroupShuffle, "GroupNonUniformShuffle"},
    CapabilityName{sc::kSubgroupShuffleRelative, "GroupNonUniformShuffleRelative"},
    CapabilityName{sc::kSubgroupClustered, "GroupNonUniformClustered"},
    CapabilityName{sc::kSubgroupQuad, "GroupNonUniformQuad"},
};

struct SampleCounts {
    const char* name;
    SampleCountMask DeviceProfile::*value;
};
inline constexpr std::array kSampleCounts{
    SampleCounts{"colorSamples", &DeviceProfile::color_samples},
    SampleCounts{"integerSamples", &DeviceProfile::integer_samples},
    SampleCounts{"depthSamples", &DeviceProfile::depth_samples},
};
inline constexpr uint32_t kMostSamples = 64;

// Alignments that a profile file may omit. DeviceProfile contains the default value of each omitted
// alignment.
inline constexpr std::array kMemoryLimits{
    WideLimit{"imageAlignmentBytes", &DeviceProfile::image_alignment_bytes},
    WideLimit{"bufferAlignmentBytes", &DeviceProfile::buffer_alignment_bytes},
    WideLimit{"imageRowAlignmentBytes", &DeviceProfile::image_row_alignment_bytes},
    WideLimit{"storageOffsetAlignmentBytes", &DeviceProfile::storage_offset_alignment_bytes},
    WideLimit{"uniformOffsetAlignmentBytes", &DeviceProfile::uniform_offset_alignment_bytes},
};

inline constexpr WideLimit kExtraBytes{"imageExtraBytes", &DeviceProfile::image_extra_bytes};

struct ContentName {
    MemoryContentMask bit;
    const char* name;
};
inline constexpr std::array kContentNames{ContentName{memory_content::kBuffers, "buffers"},
                                          ContentName{memory_content::kColorImages, "colorImages"},
                                          ContentName{memory_content::kDepthImages, "depthImages"}};

}  // namespace weft::profile_json
