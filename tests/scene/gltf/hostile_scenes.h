// Purpose: makes random broken scenes: a file that uses every supported part of glTF, with random faults. The
// same seed gives the same scene on every machine.
#pragma once

#include <cstdint>
#include <string>

namespace weft::test {

// The text of a .gltf whose buffers and images are data: URIs.
[[nodiscard]] std::string hostile_scene(uint32_t seed);

}  // namespace weft::test
