// Purpose: loads a Radiance picture (.hdr, "#?RADIANCE", equirectangular) as an Environment. The values in
// the file are interpreted as cd/m², after a multiplication by `gain`. The file is untrusted: the size of the
// picture is read from the header before a texel is decoded. Errors: S180 the file cannot be read, or is not
// a complete picture of this format; S181 the size of the picture exceeds the limits. Source: G. Ward, "Real
// Pixels", in "Graphics Gems II", 1991.
#pragma once

#include <filesystem>

#include "weft/result.h"
#include "weft/scene/environment.h"
#include "weft/scene/load_gltf.h"

namespace weft::scene {

[[nodiscard]] Result<Environment> load_environment(const std::filesystem::path& file,
                                                   const SceneLimits& limits = {}, float gain = 1);

}  // namespace weft::scene
