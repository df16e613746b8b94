// Purpose: makes random broken scenes. Each file starts as one valid scene that uses most supported parts of
// glTF; then random places are changed. The same seed gives the same scene on every machine.
#pragma once

#include <cstdint>
#include <string>

namespace weft::test {

// Returns the text of a .gltf file. Its buffers and images are data: URIs, so it needs no other files.
[[nodiscard]] std::string hostile_scene(uint32_t seed);

}  // namespace weft::test
