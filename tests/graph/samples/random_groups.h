// Purpose: makes random graphs with groups for tests, as text. The rounds of a group share transients of
// their own, write layers or mips of images that keep their content, and read each other's results. Some
// groups have "rest". Passes outside the groups read the results. The shaders are those of group_shaders(),
// or the files in tests/render/rest/random/ (RestShaders::real).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/graph/samples/random_rest.h"

namespace weft::test {

struct RandomGroups {
    std::string text;  // The body of the graph, without the outer braces and the version.
    // References to observe, as with `--resource`. They name transients of groups.
    std::vector<std::string> observed;
    uint32_t params = 0;             // Number of parameters; see RestShaders.
    std::vector<std::string> turns;  // Names of the imports of kind "turns".
};

// `pure`: all groups have "rest", no group limits the number of rounds per frame, and no port has
// "wakes": false. Then a frame in which rounds rest gives the same results as a frame in which all run. Equal
// arguments give equal graphs.
[[nodiscard]] RandomGroups random_groups(uint32_t seed, bool pure = false,
                                         RestShaders shaders = RestShaders::fake);

[[nodiscard]] ShaderCatalog group_shaders();

}  // namespace weft::test
