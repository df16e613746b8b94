// Purpose: writes pictures to files; the extension selects the format. PNG is display-encoded (sRGB, 8 bits);
// EXR (32-bit float) and PFM contain raw values. Shapes: width × height RGBA texels, row 0 on top. Errors:
// X510 cannot be written, X511 unknown extension.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>

#include "weft/result.h"

namespace weft::viewer {

enum class ImageFileKind : uint8_t { png, exr, pfm };

// A pipe or a device without an extension (/dev/stdout) gets a PNG.
[[nodiscard]] Result<ImageFileKind> image_file_kind(const std::string& path);

// For texels that are already display-encoded.
[[nodiscard]] Status write_png(const std::string& path, uint32_t width_px, uint32_t height_px,
                               std::span<const std::byte> rgba8);
// For linear values: a PNG gets them clamped to [0, 1] and display-encoded, other formats unchanged. PFM has
// no alpha.
[[nodiscard]] Status write_image(const std::string& path, uint32_t width_px, uint32_t height_px,
                                 std::span<const glm::vec4> texels);

}  // namespace weft::viewer
