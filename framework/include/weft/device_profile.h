// Purpose: describes the queues, limits, formats and memory of a device as data, so that the compiler needs
// no device. Profiles are JSON files in framework/profiles/, or are made from a device
// (`weft doctor --json`). Units: bytes, pixels.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "weft/format.h"
#include "weft/result.h"

namespace weft {

enum class QueueKind : uint8_t { graphics, compute, transfer };

using FormatFeatureMask = uint32_t;
namespace format_feature {
inline constexpr FormatFeatureMask kSampled = 1u << 0;
inline constexpr FormatFeatureMask kSampledLinear = 1u << 1;
inline constexpr FormatFeatureMask kStorage = 1u << 2;
inline constexpr FormatFeatureMask kColorAttachment = 1u << 3;
inline constexpr FormatFeatureMask kColorBlend = 1u << 4;
inline constexpr FormatFeatureMask kDepthAttachment = 1u << 5;
inline constexpr FormatFeatureMask kTransferSrc = 1u << 6;
inline constexpr FormatFeatureMask kTransferDst = 1u << 7;
inline constexpr FormatFeatureMask kBlitSrc = 1u << 8;
inline constexpr FormatFeatureMask kBlitDst = 1u << 9;
// Sampling with the reduction `min` or `max`.
inline constexpr FormatFeatureMask kSampledMinMax = 1u << 10;
}  // namespace format_feature

struct QueueFamilyProfile {
    QueueKind kind = QueueKind::graphics;  // The most capable kind of work that the family supports.
    uint32_t count = 1;
};

struct MemoryHeapProfile {
    uint64_t size_bytes = 0;
    bool device_local = true;
    bool operator==(const MemoryHeapProfile&) const = default;
};

// The kinds of resources that a memory type may contain, as a bit mask. On some devices, buffers, colour
// images and depth images need different memory types.
using MemoryContentMask = uint8_t;
namespace memory_content {
inline constexpr MemoryContentMask kBuffers = 1;
inline constexpr MemoryContentMask kColorImages = 2;
inline constexpr MemoryContentMask kDepthImages = 4;
inline constexpr MemoryContentMask kAll = 7;
}  // namespace memory_content

struct MemoryTypeProfile {
    uint32_t heap = 0;  // The heap of this memory type: an index into DeviceProfile::memory_heaps.
    bool device_local = true;
    bool host_visible = false;
    // True on tile-based GPUs: an attachment in this memory type uses no memory as long as it stays in
    // on-chip memory.
    bool lazily_allocated = false;
    MemoryContentMask holds = memory_content::kAll;
    bool operator==(const MemoryTypeProfile&) const = default;
};

// Supported numbers of samples per pixel, as a sum: 1 | 4 means that one and four samples are supported.
using SampleCountMask = uint32_t;

// Shader capabilities that only some devices have, as a bit mask. In profile files they have the names of
// SPIR-V's capabilities.
using ShaderCapabilityMask = uint32_t;
namespace shader_capability {
inline constexpr ShaderCapabilityMask kImageGatherExtended = 1u << 0;
inline constexpr ShaderCapabilityMask kImageCubeArray = 1u << 1;
// The constants from here on are subgroup operations in compute shaders. All devices have the basic
// operations; these are additional.
inline constexpr ShaderCapabilityMask kSubgroupVote = 1u << 2;
inline constexpr ShaderCapabilityMask kSubgroupArithmetic = 1u << 3;
inline constexpr ShaderCapabilityMask kSubgroupBallot = 1u << 4;
inline constexpr ShaderCapabilityMask kSubgroupShuffle = 1u << 5;
inline constexpr ShaderCapabilityMask kSubgroupShuffleRelative = 1u << 6;
inline constexpr ShaderCapabilityMask kSubgroupClustered = 1u << 7;
inline constexpr ShaderCapabilityMask kSubgroupQuad = 1u << 8;
}  // namespace shader_capability

struct DeviceProfile {
    std::string name;
    std::vector<QueueFamilyProfile> queue_families{{QueueKind::graphics, 1}};
    // The features of each supported format. A format without an entry is not supported.
    std::map<Format, FormatFeatureMask> formats;
    uint32_t max_image_2d_px = 16384;
    uint32_t max_image_layers = 2048;
    uint32_t max_push_constants_bytes = 128;
    uint32_t max_color_attachments = 8;
    // Supported numbers of samples of images that passes both draw to and sample. color_samples: colour
    // images with float or normalised formats. integer_samples: colour images with integer formats.
    SampleCountMask color_samples = 1 | 4;
    SampleCountMask integer_samples = 1;
    SampleCountMask depth_samples = 1 | 4;
    uint32_t max_workgroup_invocations = 1024;
    // Limit on the total size of the `shared` variables of a compute shader.
    uint32_t max_shared_bytes = 32768;
    uint32_t max_sampled_images_per_stage = 128;
    uint32_t max_storage_images_per_stage = 128;
    // The largest number of textures that a shader stage can sample if it indexes a table of textures. 0: the
    // device lacks features of descriptor indexing, so that it has no tables.
    uint32_t texture_table = 0;
    float max_sampler_anisotropy = 1;  // 1: the device has no anisotropic filtering.
    float max_sampler_lod_bias = 2;  // Limit on the magnitude of the bias; 2 is the least that Vulkan allows.
    uint64_t max_uniform_buffer_bytes = 65536;
    uint64_t max_storage_buffer_bytes = 134217728;
    uint64_t buffer_image_granularity_bytes = 64;
    // A range of a buffer that a shader uses must begin at a multiple of these sizes.
    uint64_t storage_offset_alignment_bytes = 256;
    uint64_t uniform_offset_alignment_bytes = 256;
    // Whether the GPU can read a number of draws from a buffer, and the largest such number.
    bool draw_indirect_count = false;
    uint32_t max_draw_indirect_count = 65535;
    // The largest number of views that one draw can draw (multiview); 1: the device has no multiview.
    uint32_t max_multiview_views = 1;
    // The largest number of layers among which a vertex shader can choose; 1: it cannot choose.
    uint32_t max_output_layers = 1;
    bool storage_read_without_format = false;
    bool descriptor_indexing = false;
    // The next members tell whether the device supports optional pipeline state: "fill" with the value "line"
    // or "point", "depthClamp", and "clamp" in "depthBias".
    bool non_solid_fill = false;
    bool depth_clamp = false;
    bool depth_bias_clamp = false;
    ShaderCapabilityMask shader_capabilities = 0;
    // The memory heaps and types of the device; empty lists mean that they are unknown. Bit i of
    // MemoryNeed::type_bits is set if memory_types[i] is allowed.
    std::vector<MemoryHeapProfile> memory_heaps;
    // At most 32 memory types, because a mask of types has 32 bits.
    std::vector<MemoryTypeProfile> memory_types;
    uint64_t image_alignment_bytes = 64;  // Alignment of images in memory. All alignments are powers of two.
    uint64_t buffer_alignment_bytes = 64;
    uint64_t image_row_alignment_bytes = 1;  // Each row of texels is padded to a multiple of this size.
    uint64_t image_extra_bytes = 0;          // Bytes that every image needs in addition to its texels.

    [[nodiscard]] FormatFeatureMask features(Format format) const;
    [[nodiscard]] SampleCountMask samples(Format format) const;
};

// Reads a profile from JSON text. `file` names the profile in messages. Errors: W140.
[[nodiscard]] Result<DeviceProfile> parse_profile(const std::string& json, const std::string& file);
[[nodiscard]] std::string profile_to_json(const DeviceProfile& profile);

}  // namespace weft
