// Purpose: the lights of a frame. The program gives a LightList to the `light_upload` pass as the value
// "lights" in HostInputs. There may be any number of lights, in the order that the program chooses. If the
// graph's buffer is too small, the last lights are dropped. Layout and units: struct Light in
// shaders/include/shared/light.glsl.
#pragma once

#include <cstddef>
#include <span>

namespace weft {

struct LightList {
    std::span<const std::byte> bytes;  // The bytes of an array of struct Light.
};

}  // namespace weft
