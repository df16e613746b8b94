// Purpose: "cornell", the box in which pictures of light are compared, and "mirror", a polished floor among
// matt and metal things. Units: metres; the box is 5.5 m wide. Both have one camera, "front".
// Source: Cornell University Program of Computer Graphics, "The Cornell Box": its measured corners (taken as
// centimetres), and the usual Rec.709 means of its spectra.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Scene make_cornell();
[[nodiscard]] Scene make_mirror();

}  // namespace weft::scene
