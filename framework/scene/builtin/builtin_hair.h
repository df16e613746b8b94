// Purpose: adds hair on a stand to a scene: strands with an opaque part and transparent tips.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

// Adds a head-shaped stand with hair. `base` is the middle of its foot.
void add_hair_on_stand(Scene& scene, const glm::vec3& base);

}  // namespace weft::scene
