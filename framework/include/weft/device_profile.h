// Purpose: the properties of a device that the compiler uses, as data: queues, limits, formats, memory.
// Profiles are JSON files in framework/profiles/, or made from the current device (`weft doctor --json`).
// Units: bytes, pixels.
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
}  // namespace format_feature

struct QueueFamilyProfile {
    QueueKind kind = QueueKind::graphics;  // its most capable kind
    uint32_t count = 1;
};

struct MemoryHeapProfile {
    uint64_t size_bytes = 0;
    bool device_local = true;
    bool operator==(const MemoryHeapProfile&) const = default;
};

// Kinds of content that a memory type may hold. Some devices separate buffers, colour and depth.
using MemoryContentMask = uint8_t;
namespace memory_content {
inline constexpr MemoryContentMask kBuffers = 1;
inline constexpr MemoryContentMask kColorImages = 2;
inline constexpr MemoryContentMask kDepthImages = 4;
inline constexpr MemoryContentMask kAll = 7;
}  // namespace memory_content

struct MemoryTypeProfile {
    uint32_t heap = 0;  // index into DeviceProfile::memory_heaps
    bool device_local = true;
    bool host_visible = false;
    bool lazily_allocated = false;  // on a tiler: attachments that stay in on-chip memory use no memory here
    MemoryContentMask holds = memory_content::kAll;
    bool operator==(const MemoryTypeProfile&) const = default;
};

// Supported sample counts, one bit each: 1 | 4 means one or four samples per pixel.
using SampleCountMask = uint32_t;

// Shader capabilities that only some devices have. Files use the names of SPIR-V's capabilities.
using ShaderCapabilityMask = uint32_t;
namespace shader_capability {
inline constexpr ShaderCapabilityMask kImageGatherExtended = 1u << 0;
inline constexpr ShaderCapabilityMask kImageCubeArray = 1u << 1;
// Subgroup operations of compute stages, in addition to the basic ones that every device has.
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
    std::map<Format, FormatFeatureMask> formats;  // absent: unsupported
    uint32_t max_image_2d_px = 16384;
    uint32_t max_image_layers = 2048;
    uint32_t max_push_constants_bytes = 128;
    uint32_t max_color_attachments = 8;
    SampleCountMask color_samples = 1 | 4;  // sample counts of images that passes draw to and sample
    SampleCountMask integer_samples = 1;
    SampleCountMask depth_samples = 1 | 4;
    uint32_t max_workgroup_invocations = 1024;
    uint32_t max_shared_bytes = 32768;  // limit on `shared` variables of a compute stage
    uint32_t max_sampled_images_per_stage = 128;
    uint32_t max_storage_images_per_stage = 128;
    uint64_t max_uniform_buffer_bytes = 65536;
    uint64_t max_storage_buffer_bytes = 134217728;
    uint64_t buffer_image_granularity_bytes = 64;
    bool storage_read_without_format = false;
    bool descriptor_indexing = false;
    // Optional pipeline state: "fill" other than "fill", "depthClamp", "clamp" of "depthBias".
    bool non_solid_fill = false;
    bool depth_clamp = false;
    bool depth_bias_clamp = false;
    ShaderCapabilityMask shader_capabilities = 0;
    // Memory heaps and types; empty lists mean unknown. The bit of a type in MemoryNeed::type_bits is its
    // index in memory_types.
    std::vector<MemoryHeapProfile> memory_heaps;
    std::vector<MemoryTypeProfile> memory_types;  // at most 32
    uint64_t image_alignment_bytes = 64;          // powers of two
    uint64_t buffer_alignment_bytes = 64;
    uint64_t image_row_alignment_bytes = 1;  // each row of texels is padded to a multiple of this
    uint64_t image_extra_bytes = 0;          // extra bytes of an image besides its texels

    [[nodiscard]] FormatFeatureMask features(Format format) const;
    [[nodiscard]] SampleCountMask samples(Format format) const;
};

// Reads a profile file; `file` names it in errors. Errors: W140.
[[nodiscard]] Result<DeviceProfile> parse_profile(const std::string& json, const std::string& file);
[[nodiscard]] std::string profile_to_json(const DeviceProfile& profile);

}  // namespace weft
