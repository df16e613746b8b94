// Purpose: how a port of a shader looks at an image: the sampler, and whether the port is an array of mips or
// layers. The names follow Vulkan.
#pragma once

#include <cstdint>
#include <optional>

#include "weft/raster_state.h"

namespace weft {

enum class SamplerFilter : uint8_t { nearest, linear };
enum class SamplerWrap : uint8_t { clamp, repeat, mirror, border };
// The result of a lookup that touches several texels: their weighted average, or the least or greatest of
// them.
enum class SamplerReduction : uint8_t { average, min, max };
// The value of SamplerDecl::max_lod that does not limit the mips.
inline constexpr float kNoMaxLod = 1000;
struct SamplerDecl {
    SamplerFilter filter = SamplerFilter::linear;
    SamplerFilter mip_filter = SamplerFilter::linear;
    SamplerWrap wrap = SamplerWrap::clamp;
    // The comparison of a sampler2DShadow. Absent: the sampler does not compare.
    std::optional<CompareOp> compare;
    SamplerReduction reduction = SamplerReduction::average;
    // Greatest number of samples along the longer axis of a pixel's footprint, 1 to 16. 1: isotropic.
    float anisotropy = 1;
    // Level of detail: 0 is the first mip of the port, 1 the second. A lookup adds lod_bias to the level, and
    // then clamps it to min_lod..max_lod.
    float lod_bias = 0, min_lod = 0, max_lod = kNoMaxLod;
    bool operator==(const SamplerDecl&) const = default;
};

// For a port that is an array in the shader: each element of the array is one mip, or one layer, of the range
// of the image that the port names.
enum class EachPart : uint8_t { none, mip, layer };

}  // namespace weft
