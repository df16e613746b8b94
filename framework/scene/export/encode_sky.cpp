#include <cmath>
#include <glm/gtc/packing.hpp>
#include <vector>

#include "scene/model/angles.h"
#include "scene/model/sky_gradient.h"
#include "scene/pictures/radiance_encode.h"
#include "weft/scene/encode_glb.h"

namespace weft::scene {
namespace {

constexpr uint32_t kGradientWidth_px = 1024, kGradientHeight_px = 512;

std::string encode_gradient(const SkyGradient& sky) {
    std::vector<glm::vec3> texels;
    texels.reserve(size_t{kGradientWidth_px} * kGradientHeight_px);
    for (uint32_t row = 0; row < kGradientHeight_px; ++row) {
        const float from_zenith = kPi * (static_cast<float>(row) + 0.5f) / float{kGradientHeight_px};
        const glm::vec3 direction(std::sin(from_zenith), std::cos(from_zenith), 0);
        texels.insert(texels.end(), kGradientWidth_px, gradient_radiance(sky, direction));
    }
    return encode_radiance(kGradientWidth_px, kGradientHeight_px, texels);
}

}  // namespace

bool has_sky(const Scene& scene) {
    return !scene.environment.mips.empty() || scene.sky_zenith != glm::vec3(0) ||
           scene.sky_horizon != glm::vec3(0);
}

std::string encode_sky(const Scene& scene) {
    const Environment& picture = scene.environment;
    if (picture.mips.empty()) return encode_gradient({scene.sky_zenith, scene.sky_horizon});
    std::vector<glm::vec3> texels;
    texels.reserve(picture.mips.front().size());
    for (const uint32_t texel : picture.mips.front())
        texels.push_back(glm::unpackF3x9_E1x5(texel) * picture.scale);
    return encode_radiance(picture.width_px, picture.height_px, texels);
}

}  // namespace weft::scene
