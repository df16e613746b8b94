// Purpose: resizes the pictures that lights project to one size, so that they fit into one array texture.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::scene {

inline constexpr uint32_t kLightPictureSize_px = 256;

struct LightPictures {
    std::vector<std::vector<uint8_t>> mips;  // for each mip level the sRGB texels of all layers, one layer
                                             // after another; full mip chain
    std::vector<uint32_t> layer_of;          // for each of Scene::light_functions its layer; kNone: it has no
                                             // picture
    uint32_t layers = 0;  // at most kMaxLightPictures; light_warnings() reports the pictures that are ignored
};

[[nodiscard]] LightPictures light_pictures(const Scene& scene);

}  // namespace weft::scene
