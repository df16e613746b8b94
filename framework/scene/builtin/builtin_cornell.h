// Purpose: "cornell", the standard box for comparing rendered light, and "mirror", a polished floor with matt
// and metal objects. Units: metres; the box is 5.5 m wide. Both scenes have one camera, "front". Source:
// Cornell University Program of Computer Graphics, "The Cornell Box": its measured corners (in centimetres),
// and the usual Rec.709 averages of its spectra.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_cornell();
[[nodiscard]] Scene make_mirror();

}  // namespace weft::scene
