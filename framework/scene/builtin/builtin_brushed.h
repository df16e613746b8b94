// Purpose: "brushed", a scene of brushed metal on a dark table: anisotropic surfaces beside isotropic ones of
// the same roughness. On turned (lathe) objects the grain runs around the axis, on flat objects from left to
// right. One plate reads its grain from a texture.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_brushed();

}  // namespace weft::scene
