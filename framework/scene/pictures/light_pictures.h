// Purpose: resizes all pictures that lights project to the same size. Each picture becomes one layer of an
// array texture.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::scene {

inline constexpr uint32_t kLightPictureSize_px = 256;  // Width and height of each layer.

struct LightPictures {
    // For each mip level, the sRGB texels of all layers, one layer after another. The mip chain is complete.
    std::vector<std::vector<uint8_t>> mips;
    // For each of Scene::light_functions, the index of its layer. kNone if the function has no picture, if
    // its picture has no texels, or if there is no layer left.
    std::vector<uint32_t> layer_of;
    // Number of layers, at most kMaxLightPictures. light_warnings() reports the pictures that do not fit.
    uint32_t layers = 0;
};

[[nodiscard]] LightPictures light_pictures(const Scene& scene);

}  // namespace weft::scene
