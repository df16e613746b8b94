// Purpose: the lights of a frame as the program hands them to the `light_upload` pass: HostInputs "lights".
// Shape: any number; what the graph's buffer cannot hold is left out, brightest kept by the program's own
// order. Units: see shaders/include/shared/light.glsl, whose struct Light this list is made of.
#pragma once

#include <span>

#include "shared/light.glsl"

namespace weft {

struct LightList {
    std::span<const shared::Light> lights;
};

}  // namespace weft
