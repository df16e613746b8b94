// Purpose: pictures as files; the extension says which kind. PNG is display-encoded (sRGB, 8 bits); EXR
// (32-bit float) and PFM hold raw values. Shapes: width × height RGBA texels, row 0 on top. Errors: X510
// cannot be written, X511 unknown extension.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>

#include "weft/result.h"

namespace weft::viewer {

enum class ImageFileKind : uint8_t { png, exr, pfm };

// A pipe or a device without an extension (/dev/stdout) gets a PNG.
[[nodiscard]] Result<ImageFileKind> image_file_kind(const std::string& path);

// Bytes that are display-encoded already.
[[nodiscard]] Status write_png(const std::string& path, uint32_t width_px, uint32_t height_px,
                               std::span<const std::byte> rgba8);
// Linear values: clamped to [0, 1] and encoded for a PNG, untouched otherwise. PFM drops alpha.
[[nodiscard]] Status write_image(const std::string& path, uint32_t width_px, uint32_t height_px,
                                 std::span<const glm::vec4> texels);

}  // namespace weft::viewer
