// Purpose: a look at a JPEG's Huffman tables before they are decoded. A table has 256 codes at most, and
// stb_image (2.27, DHT in stbi__process_marker) writes past its own where a file says that one has more.
// Source: "Digital compression and coding of continuous-tone still images", ITU-T T.81, 1992, annex B.
#pragma once

#include <cstdint>
#include <span>

namespace weft::scene {

// False for a JPEG with a table of more than 256 codes. True for whatever else, broken files among them.
[[nodiscard]] bool jpeg_tables_fit(std::span<const uint8_t> encoded);

}  // namespace weft::scene
