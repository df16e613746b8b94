// Purpose: reads pictures from PNG files (encoded for display, rounded to 8 bits per channel), EXR files (one
// part; channels R, G and B, or a single channel) and PFM files (raw values). The first bytes of the file
// determine the format, not the file name. Alpha is ignored. Row 0 is at the top. The size in the header is
// checked before anything is decoded. Errors: X530 the file does not exist, is too large, or cannot be
// decoded; X531 the picture has too many pixels or none; X571 memory ran out.
#pragma once

#include <string>

#include "weft/image/image.h"
#include "weft/limits.h"
#include "weft/result.h"

namespace weft::viewer {

[[nodiscard]] Result<image::Image> read_image(const std::string& path, const PictureLimits& limits);

}  // namespace weft::viewer
