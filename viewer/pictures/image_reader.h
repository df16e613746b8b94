// Purpose: reads pictures from files: PNG (display-encoded, rounded to 8 bits per channel), EXR (one part;
// channels R, G and B, or a single one) and PFM (raw values). The first bytes of a file determine its format,
// not its name. Alpha is ignored. Shapes: row 0 on top. Sizes are read from the header before anything is
// decoded. Errors: X530 the picture does not exist or cannot be decoded; X531 too large.
#pragma once

#include <string>

#include "weft/image/image.h"
#include "weft/limits.h"
#include "weft/result.h"

namespace weft::viewer {

[[nodiscard]] Result<image::Image> read_image(const std::string& path, const PictureLimits& limits);

}  // namespace weft::viewer
