// Purpose: makes copies of the shipped graphs and shaders without operations whose result Vulkan leaves to
// the driver. Then two drivers have the same input, and a difference between their pictures is a fault. The
// copies differ from the originals in four ways:
// - Vertices lie on a grid of 1/16 px. Vulkan lets a driver round vertices to 4 fractional bits of a pixel or
//   more (subPixelPrecisionBits). SwiftShader has 4 and lavapipe 8, so edges would differ by up to 1/32 px.
// - With Triangles::whole, triangles that extend beyond the picture are not drawn. A driver may clip them,
//   and the new vertices would not lie on the grid.
// - Shaders filter material textures themselves, in single precision and at a fixed level. Vulkan does not
//   specify how precisely a driver filters and selects a level; lavapipe filters 8-bit textures in 8 bits.
//   The graph `edges` filters its image `lines`, so in the copy this image has a float format, not 8 bits.
// - sRGB is decoded from the nearest 8-bit code, because drivers decode it with different precision.
#pragma once

#include <filesystem>
#include <string>

namespace weft::test {

enum class Triangles { all, whole };

// Counts the replacements in the copies. A text that is not found would stay unchanged without an error, so
// tests compare these counts with the expected ones.
struct SnappedShaders {
    // Number of changed vertex shaders: those that project vertices with the view.
    int vertex = 0;
    // Number of changed fragment shaders: those that read material textures.
    int fragment = 0;
    // True if the lines image of the graph `edges` has a float format instead of 8 bits.
    bool has_wide_lines = false;
};

[[nodiscard]] SnappedShaders write_snapped_graphs(const std::filesystem::path& folder, Triangles triangles);

// Replaces a text in a file. Returns false if `what` is not in the file.
[[nodiscard]] bool replace_in(const std::filesystem::path& file, const std::string& what,
                              const std::string& by);

}  // namespace weft::test
