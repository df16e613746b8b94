// Purpose: copies of the shipped graphs and shaders without operations whose result Vulkan leaves to the
// driver. Two drivers then have the same input, and a difference between their pictures is a fault. The
// copies differ in four ways:
// - Vertices lie on a grid of 1/16 px. Vulkan lets a driver round vertices to 4 fractional bits of a pixel or
//   more (subPixelPrecisionBits). SwiftShader has 4 and lavapipe 8, so edges would differ by up to 1/32 px.
// - With Triangles::whole, triangles that extend beyond the picture are not drawn. A driver may clip them,
//   and the new vertices would not lie on the grid.
// - Shaders filter material textures themselves, in single precision and at a fixed level. Vulkan does not
//   specify how precisely a driver filters and selects a level; lavapipe filters 8-bit textures in 8 bits.
//   The pass `edges` filters its own result in 8 bits, so it uses a float format instead.
// - sRGB is decoded from the nearest 8-bit code, because drivers decode it with different precision.
#pragma once

#include <filesystem>
#include <string>

namespace weft::test {

enum class Triangles { all, whole };

// The replacements that were made. Tests compare them with the expected ones, because a text that is not
// found would silently stay unchanged.
struct SnappedShaders {
    int vertex = 0;               // number of shaders that project vertices with the view
    int fragment = 0;             // number of shaders that read material textures
    bool has_wide_lines = false;  // true if `edges` filters its lines in the shader and has a float format
                                  // instead of 8 bits
};

[[nodiscard]] SnappedShaders write_snapped_graphs(const std::filesystem::path& folder, Triangles triangles);

// Returns false if `what` is not in the file.
[[nodiscard]] bool replace_in(const std::filesystem::path& file, const std::string& what,
                              const std::string& by);

}  // namespace weft::test
