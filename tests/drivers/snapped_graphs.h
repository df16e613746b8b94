// Purpose: the shipped graphs and shaders in a folder of their own, where vertices lie on a grid of 1/16 px. Vulkan lets
// a driver round vertices to 4 bits behind the point of a pixel or more (subPixelPrecisionBits). SwiftShader has 4 and
// lavapipe 8, so the edges of their triangles differ by up to 1/32 px, and at 320×180 one texel of eighty in the atrium
// shows another surface. On the grid both rasterise the same triangles, and what is left to differ is Weft's.
#pragma once

#include <filesystem>

namespace weft::test {

// The number of vertex shaders that were changed.
[[nodiscard]] int write_snapped_graphs(const std::filesystem::path& folder);

}  // namespace weft::test
