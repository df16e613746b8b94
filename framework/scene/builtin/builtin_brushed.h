// Purpose: "brushed", a scene of brushed metal on a dark table: anisotropic surfaces beside isotropic ones of
// the same roughness. The grain runs around turned objects and along flat ones; one plate reads its grain
// from a texture.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_brushed();

}  // namespace weft::scene
