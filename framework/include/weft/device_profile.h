// Purpose: what the compiler may know about a device, as data: queues, limits, formats, memory. Profiles are
// JSON files in framework/profiles/, or made from the present device (`weft doctor --json`). Units: bytes,
// pixels.
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
    QueueKind kind = QueueKind::graphics;  // the most capable thing it can do
    uint32_t count = 1;
};

struct DeviceProfile {
    std::string name;
    std::vector<QueueFamilyProfile> queue_families{{QueueKind::graphics, 1}};
    std::map<Format, FormatFeatureMask> formats;  // absent: unsupported
    uint32_t max_image_2d_px = 16384;
    uint32_t max_image_layers = 2048;
    uint32_t max_push_constants_bytes = 128;
    uint32_t max_color_attachments = 8;
    uint32_t max_workgroup_invocations = 1024;
    uint32_t max_sampled_images_per_stage = 128;
    uint32_t max_storage_images_per_stage = 128;
    uint64_t max_uniform_buffer_bytes = 65536;
    uint64_t max_storage_buffer_bytes = 134217728;
    uint64_t buffer_image_granularity_bytes = 64;
    bool storage_read_without_format = false;
    bool descriptor_indexing = false;

    [[nodiscard]] FormatFeatureMask features(Format format) const;
};

// Reads a profile file; `file` names it in errors.
[[nodiscard]] Result<DeviceProfile> parse_profile(const std::string& json, const std::string& file);
[[nodiscard]] std::string profile_to_json(const DeviceProfile& profile);

}  // namespace weft
