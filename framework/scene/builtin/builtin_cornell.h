// Purpose: "cornell", the standard box for comparing rendered light, and "mirror", a polished floor with matt
// and metal objects. Units: metres; the box is 5.5 m wide. Both scenes have one camera, "front". Source:
// Cornell University Program of Computer Graphics, "The Cornell Box": the measured corners of the box (one
// unit is taken as 1 cm). The colours are the usual Rec.709 averages of the measured spectra.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_cornell();
[[nodiscard]] Scene make_mirror();

}  // namespace weft::scene
