// Purpose: writes a scene for other programs: the scene as the bytes of a binary glTF 2.0 file (.glb), and
// its sky as the bytes of a Radiance picture (.hdr). load_gltf() reads the same scene from the glTF file,
// except for the parts that glTF cannot express: the sky, the exposure, motion (the file shows the scene at
// time 0), placed probes, and the angular radius of directional lights. Units: as in scene.h, which are those
// of glTF. Errors: S140 (the scene is too large for a .glb file), X510 (a texture cannot be encoded).
#pragma once

#include <string>

#include "weft/result.h"
#include "weft/scene/scene.h"

namespace weft::scene {

[[nodiscard]] Result<std::string> encode_glb(const Scene& scene);

// True if the scene has an environment picture or a sky that is not black.
[[nodiscard]] bool has_sky(const Scene& scene);

// Returns the sky as an equirectangular Radiance picture. Its values are cd/m², without a scale. Row 0 is the
// direction +y (up), and the middle column is the direction −z. A gradient sky has 1024 × 512 texels; an
// environment picture keeps its size.
[[nodiscard]] std::string encode_sky(const Scene& scene);

}  // namespace weft::scene
