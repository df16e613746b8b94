// Purpose: copies of the shipped graphs and shaders that leave out what Vulkan leaves to the driver. Two drivers then have
// the same input, and a difference between their pictures is a fault. The copies differ in four things:
// - Vertices lie on a grid of 1/16 px. Vulkan lets a driver round vertices to 4 fractional bits of a pixel or more
//   (subPixelPrecisionBits). SwiftShader has 4 and lavapipe 8, so that edges would differ by up to 1/32 px.
// - With Triangles::whole, triangles that reach beyond the picture are not drawn. A driver may clip them, and the new
//   vertices are off the grid.
// - Shaders filter the textures of materials themselves, in single precision and at a fixed level. Vulkan does not say how
//   precisely a driver filters and chooses a level; lavapipe filters 8-bit textures in 8 bits. `edges` filters what it drew
//   into 8 bits, and has a format with floats in its place.
// - sRGB is decoded from the nearest code of 8 bits. Drivers decode it with different precision.
#pragma once

#include <filesystem>
#include <string>

namespace weft::test {

enum class Triangles { all, whole };

// What was changed. A test compares it with what it expects, because text that is not found is not changed.
struct SnappedShaders {
    int vertex = 0;               // they project vertices with the view
    int fragment = 0;             // they read the textures of materials
    bool has_wide_lines = false;  // `edges` filters its lines, too, and has floats in place of 8 bits
};

[[nodiscard]] SnappedShaders write_snapped_graphs(const std::filesystem::path& folder, Triangles triangles);

// False when `what` is not there.
[[nodiscard]] bool replace_in(const std::filesystem::path& file, const std::string& what,
                              const std::string& by);

}  // namespace weft::test
