// Purpose: makes random broken scenes. Each file uses every supported part of glTF and has some random
// faults. The same seed gives the same scene on every machine.
#pragma once

#include <cstdint>
#include <string>

namespace weft::test {

// Returns the text of a .gltf file. Its buffers and images are data: URIs, so it needs no other files.
[[nodiscard]] std::string hostile_scene(uint32_t seed);

}  // namespace weft::test
