// Purpose: the lights of a frame, which the program passes to the `light_upload` pass as HostInputs "lights".
// Shape: any number; lights beyond the capacity of the graph's buffer are dropped, so the program should put
// the brightest first. Units: see shaders/include/shared/light.glsl, which defines the struct Light of this
// list.
#pragma once

#include <span>

#include "shared/light.glsl"

namespace weft {

struct LightList {
    std::span<const shared::Light> lights;
};

}  // namespace weft
