// Purpose: makes random graphs with rest units for tests, as text. The graphs have images that keep their
// content, transients that only one unit uses, imports, and passes that run in every frame. Each graph ends
// with readback passes. The shaders are those of rest_shaders().
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weft/shader_interface.h"

namespace weft::test {

struct RandomRest {
    std::string text;  // The body of the graph, without the outer braces and the version.
    // References to observe, as with `--resource`. They name transients that only a rest unit uses.
    std::vector<std::string> observed;
    uint32_t rest_passes = 0;  // Number of passes with "rest" in the text.
};

// Equal seeds give equal graphs. Most graphs can be resolved; a few have a cycle.
[[nodiscard]] RandomRest random_rest(uint32_t seed);

[[nodiscard]] ShaderCatalog rest_shaders();

}  // namespace weft::test
