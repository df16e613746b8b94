// Purpose: makes the full mip chain of an 8-bit RGBA image. The filter depends on the image's meaning:
// colours are filtered in linear light, normals are renormalised, masks keep the coverage of mip 0. Levels
// with odd sizes are reduced with area-weighted boxes. Shapes: `rgba` has width_px * height_px * 4 bytes, row
// 0 on top. Sources: IEC 61966-2-1 (sRGB); I. Castaño, "Computing Alpha Mipmaps", 2010 (coverage).
#pragma once

#include <cstdint>
#include <vector>

namespace weft::scene {

enum class TexelMeaning : uint8_t { srgb_color, linear_data, normal };

struct MipOptions {
    TexelMeaning meaning = TexelMeaning::linear_data;
    // Cutoff for an alpha mask; 0 or less if there is no mask. With a cutoff, all mips keep about the
    // coverage of mip 0: the share of texels whose alpha passes the cutoff.
    float alpha_cutoff = -1;
};

// Returns the texels of all mips, mip 0 first.
[[nodiscard]] std::vector<std::vector<uint8_t>> build_mip_chain(uint32_t width_px, uint32_t height_px,
                                                                std::vector<uint8_t> rgba,
                                                                const MipOptions& options);

[[nodiscard]] float srgb_to_linear(float encoded);
[[nodiscard]] float linear_to_srgb(float linear);

}  // namespace weft::scene
