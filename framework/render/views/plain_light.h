// Purpose: plain lights, which shaders add up in a loop of their own.
#pragma once

#include "shared/light.glsl"

namespace weft::render {

// True if the light has neither an area nor a light function (doors, picture, falloff curve).
[[nodiscard]] inline bool is_plain(const shared::Light& light) {
    return light.type < shared::kLightCapsule && light.function == 0;
}

}  // namespace weft::render
