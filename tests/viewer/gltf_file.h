// Small generated glTF scenes for tests.
#pragma once

#include <string>

namespace weft::test {

// A red, rough, double-sided square of 2 m on the ground, in front of a camera, with its buffer inside the
// file. It is valid; tests use `replaced` to make faulty variants.
[[nodiscard]] std::string square_gltf();

// `text` with the first `from` replaced; `from` must occur in it.
[[nodiscard]] std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace weft::test
