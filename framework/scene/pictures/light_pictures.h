// Purpose: the pictures that lights throw, made alike in size, as one array of textures holds them.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::scene {

inline constexpr uint32_t kLightPictureSize_px = 256;

struct LightPictures {
    std::vector<std::vector<uint8_t>> mips;  // sRGB, of all layers one behind the other; the full chain
    std::vector<uint32_t> layer_of;          // of each of Scene::light_functions; kNone: it has no picture
    uint32_t layers = 0;  // at most kMaxLightPictures: light_warnings() names what is left out
};

[[nodiscard]] LightPictures light_pictures(const Scene& scene);

}  // namespace weft::scene
