// Purpose: makes the textures of a metallic-roughness material from a function per texel: colour with alpha,
// metallic-roughness, and a normal map derived from heights, each with its full mip chain.
// Units: heights and periods in metres, so that the slopes of a normal map are those of the real surface.
// Conventions: colours are specified and stored display-encoded (sRGB). The smaller mips average them in
// linear light. Row 0 is on top; a normal's green channel points up the picture (glTF's convention).
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::scene {

struct Texel {
    glm::vec3 color_srgb{0.5f};
    float height_m = 0;
    float roughness = 0.8f;
    float metalness = 0;
    float alpha = 1;
};

// A square texture that covers `period_m` metres per side and then repeats.
struct Surface {
    uint32_t size_px = 0;
    float period_m = 1;
    std::vector<Texel> texels;

    [[nodiscard]] Texel& at(uint32_t x, uint32_t y) { return texels[y * size_px + x]; }
    [[nodiscard]] const Texel& at(uint32_t x, uint32_t y) const { return texels[y * size_px + x]; }
};

[[nodiscard]] Surface make_surface(uint32_t size_px, float period_m,
                                   const std::function<Texel(uint32_t x, uint32_t y)>& recipe);

// The textures of one material, as indices into Scene::textures.
struct SurfaceTextures {
    uint32_t color = kNone;
    uint32_t metallic_roughness = kNone;
    uint32_t normal = kNone;
};

// Adds the three textures of a material to the scene. If `keep_coverage` is true, alpha is rescaled in the
// smaller mips, so that the same share of texels passes a cutoff of 0.5 as in mip 0. So masked leaves do not
// become thinner at a distance (Castaño, "Computing Alpha Mipmaps", 2010).
[[nodiscard]] SurfaceTextures add_surface(Scene& scene, const std::string& name, const Surface& surface,
                                          bool keep_coverage = false);

// Adds a one-channel picture with values in 0..1 as a linear texture, for example for occlusion.
[[nodiscard]] uint32_t add_gray_texture(Scene& scene, const std::string& name, uint32_t width_px,
                                        uint32_t height_px, const std::vector<float>& values);

// Adds a display-encoded colour picture with values in 0..1, for example for emission.
[[nodiscard]] uint32_t add_color_texture(Scene& scene, const std::string& name, uint32_t size_px,
                                         const std::vector<glm::vec3>& srgb);

// Smoothstep: 0 below `low`, 1 above `high`, smooth between them.
[[nodiscard]] float smooth_step(float low, float high, float x);
[[nodiscard]] glm::vec3 rgb(uint32_t hex);  // Converts a colour 0xRRGGBB to three values in 0..1.

}  // namespace weft::scene
