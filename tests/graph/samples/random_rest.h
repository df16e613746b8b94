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
    uint32_t params = 0;       // Number of parameters; see RestShaders.
};

// `fake`: the shaders are those of rest_shaders(), and the graph reads an import "noise". `real`: the shaders
// are the files in tests/render/rest/random/. The graph has no import, and each shader has a parameter: "p0",
// "p1" and so on.
enum class RestShaders : uint8_t { fake, real };

// `has_unwoken`: some passes with "rest" read changing images through ports with "wakes": false. Equal
// arguments give equal graphs.
[[nodiscard]] RandomRest random_rest(uint32_t seed, RestShaders shaders = RestShaders::fake,
                                     bool has_unwoken = false);

[[nodiscard]] ShaderCatalog rest_shaders();

}  // namespace weft::test
