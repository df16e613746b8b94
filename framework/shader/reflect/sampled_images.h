// Purpose: finds the images that a shader stage samples at texture coordinates: for warnings about images of
// which only a part has content, and to know which formats must support linear filtering.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>

namespace weft::shader {

// Returns the names of the variables from which the stage reads with texture(), textureLod(), textureGather()
// and similar functions. Leaves out variables whose size the stage queries, because it may compute the
// coordinates from the size, and variables that it passes to a function. texelFetch() does not count.
[[nodiscard]] std::set<std::string> sampled_images(std::span<const uint32_t> spirv);

// Returns the ids of the variables from which the stage reads with these functions, or that it passes to a
// function. The other images are read with texelFetch() alone, or not at all.
[[nodiscard]] std::set<uint32_t> filtered_images(std::span<const uint32_t> spirv);

}  // namespace weft::shader
