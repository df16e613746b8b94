// Purpose: makes the full mip chain of an 8-bit RGBA image. The filter depends on the image's meaning:
// colours are filtered in linear light, normals are renormalised, masks keep the coverage of mip 0. Shapes:
// `rgba` has width_px * height_px * 4 bytes, row 0 on top. Source: sRGB: IEC 61966-2-1. Odd sizes:
// area-weighted boxes. Coverage: I. Castaño, "Computing Alpha Mipmaps", 2010.
#pragma once

#include <cstdint>
#include <vector>

namespace weft::scene {

enum class TexelMeaning : uint8_t { srgb_color, linear_data, normal };

struct MipOptions {
    TexelMeaning meaning = TexelMeaning::linear_data;
    // Cutoff in [0, 1] for an alpha mask; negative if there is no mask. With a cutoff, all mips keep the
    // coverage of mip 0: the share of texels whose alpha passes the cutoff.
    float alpha_cutoff = -1;
};

[[nodiscard]] std::vector<std::vector<uint8_t>> build_mip_chain(uint32_t width_px, uint32_t height_px,
                                                                std::vector<uint8_t> rgba,
                                                                const MipOptions& options);

[[nodiscard]] float srgb_to_linear(float encoded);
[[nodiscard]] float linear_to_srgb(float linear);

}  // namespace weft::scene
