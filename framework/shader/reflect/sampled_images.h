// Purpose: finds the images that a shader stage samples at texture coordinates: for warnings about images of
// which only a part has content, and to know which formats must support linear filtering.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>

namespace weft::shader {

// Returns the names of the variables from which the stage reads with texture(), textureLod(), textureGather()
// and similar functions. texelFetch() does not count. Leaves out variables that the stage passes to a
// function. Also leaves out variables whose size the stage queries: the stage may compute the coordinates
// from the size.
[[nodiscard]] std::set<std::string> sampled_images(std::span<const uint32_t> spirv);

// Returns the ids of the variables from which the stage reads with texture(), textureLod(), textureGather()
// and similar functions, and of the variables that the stage passes to a function. The stage reads all other
// images with texelFetch() alone, or not at all.
[[nodiscard]] std::set<uint32_t> filtered_images(std::span<const uint32_t> spirv);

}  // namespace weft::shader
