// Purpose: "brushed", metal with a grain on a dark table: anisotropic surfaces beside plain ones of the same
// roughness. Grain runs around what is turned and along what is flat; one plate has it in a texture.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_brushed();

}  // namespace weft::scene
