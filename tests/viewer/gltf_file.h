// Small glTF scenes for the tests, written from nothing.
#pragma once

#include <string>

namespace weft::test {

// A square of 2 m on the ground, in front of a camera, rough red, double-sided, with its buffer in the file.
// Valid as it is; `replace` makes the faulty ones.
[[nodiscard]] std::string square_gltf();

// `text` with the first `from` replaced; `from` must be there.
[[nodiscard]] std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace weft::test
