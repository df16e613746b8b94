// Purpose: "spheres", a 7 × 7 grid of spheres on a ground: roughness increases to the right, metalness to the
// back. The scene has one light and no textures, so that a test can compute the expected colour of a pixel.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_spheres();

}  // namespace weft::scene
