// Purpose: pictures from files: PNG (8 bits a channel, finer ones are rounded; display-encoded), EXR (one
// part, channels R, G and B, or one alone) and PFM (raw values). What a file is, its first bytes say, not its
// name. Alpha is left out. Shapes: row 0 on top. Sizes are read from the header before anything is decoded.
// Errors: X530 no such picture, or it can't be decoded; X531 too large.
#pragma once

#include <string>

#include "weft/image/image.h"
#include "weft/limits.h"
#include "weft/result.h"

namespace weft::viewer {

[[nodiscard]] Result<image::Image> read_image(const std::string& path, const PictureLimits& limits);

}  // namespace weft::viewer
