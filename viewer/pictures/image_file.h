// Purpose: writes pictures to files. The extension of the file name selects the format. A PNG is encoded for
// display (sRGB, 8 bits); EXR (32-bit float) and PFM contain raw values. The input has width × height RGBA
// texels, with row 0 at the top. Errors: X510 the file cannot be written, X511 the extension is unknown.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>

#include "weft/result.h"

namespace weft::viewer {

enum class ImageFileKind : uint8_t { png, exr, pfm };

// Returns the format that belongs to the extension of the path. A pipe or a device without an extension, such
// as /dev/stdout, gets a PNG.
[[nodiscard]] Result<ImageFileKind> image_file_kind(const std::string& path);

// Writes a PNG from RGBA texels of 8 bits per channel that are already encoded for display.
[[nodiscard]] Status write_png(const std::string& path, uint32_t width_px, uint32_t height_px,
                               std::span<const std::byte> rgba8);
// Writes linear values to a file. For a PNG, the values are clamped to [0, 1] and encoded for display, and
// alpha is 1. EXR and PFM files contain the unchanged values, but PFM has no alpha.
[[nodiscard]] Status write_image(const std::string& path, uint32_t width_px, uint32_t height_px,
                                 std::span<const glm::vec4> texels);

}  // namespace weft::viewer
