// Purpose: "materials", a table with hair, silk, ice, a paper lantern and plaster: materials that a G-buffer
// cannot describe.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_materials();

}  // namespace weft::scene
