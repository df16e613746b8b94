// Purpose: the lights of a frame, which the program gives to the `light_upload` pass as HostInputs "lights":
// any number, in the program's order. Lights for which the graph's buffer has no room are dropped from the
// end. Layout and units: struct Light of shaders/include/shared/light.glsl.
#pragma once

#include <cstddef>
#include <span>

namespace weft {

struct LightList {
    std::span<const std::byte> bytes;  // of an array of Light
};

}  // namespace weft
