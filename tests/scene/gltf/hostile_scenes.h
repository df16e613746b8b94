// Purpose: scenes that nobody would export: a file that uses every part of glTF that is read, with random
// faults. The same seed gives the same scene everywhere.
#pragma once

#include <cstdint>
#include <string>

namespace weft::test {

// Text of a .gltf whose buffers and images are data: URIs.
[[nodiscard]] std::string hostile_scene(uint32_t seed);

}  // namespace weft::test
