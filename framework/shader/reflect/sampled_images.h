// Purpose: finds the images that a shader stage samples at texture coordinates, for warnings about images of
// which only a part has content.
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

}  // namespace weft::shader
