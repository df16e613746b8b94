// Makes the text of small glTF scenes for tests.
#pragma once

#include <string>

namespace weft::test {

// Returns a valid glTF scene: a red, rough, double-sided square of 2 m × 2 m on the ground, in front of a
// camera. The buffer is inside the file. Tests use replaced() to make faulty variants of the scene.
[[nodiscard]] std::string square_gltf();

// Returns `text` with the first occurrence of `from` replaced by `to`. `from` must occur in `text`.
[[nodiscard]] std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace weft::test
