// Purpose: makes random graphs with live switches for tests, as text. Passes with switches modify images in
// place, overwrite them, write images that other passes read with "else" or "optional", and write images that
// keep their content. Each graph ends with readback passes. The shaders are those of switch_shaders().
#pragma once

#include <cstdint>
#include <string>

#include "weft/shader_interface.h"

namespace weft::test {

struct RandomSwitches {
    std::string text;       // The body of the graph, without the outer braces and the version.
    uint32_t switches = 0;  // Number of switches: the parameters "s0", "s1" and so on.
};

// Equal seeds give equal graphs.
[[nodiscard]] RandomSwitches random_switches(uint32_t seed);

[[nodiscard]] ShaderCatalog switch_shaders();

}  // namespace weft::test
