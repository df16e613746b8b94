// Purpose: finds the light probes of a scene for the argument --probes. Errors: W002 there is no such file,
// and the errors of scene::read_probes() and scene::place_probes().
#pragma once

#include <optional>
#include <string>

#include "viewer/options/options.h"
#include "weft/result.h"
#include "weft/scene/scene.h"

namespace weft::viewer {

struct ProbeChoice {
    std::string scene;  // Name of the scene, with the same value as SceneChoice::name.
    // "auto", "none", or a file. Empty: the file NAME.probes.json beside the scene if it exists, otherwise
    // "auto".
    std::string probes;
    glm::vec3 camera{0};  // Place of the camera; in large scenes, the probes are placed around the camera.
};

struct FoundProbes {
    scene::Probes probes;
    std::string source;  // The file, "auto" or "none".
};

// Finds the probes. If this takes longer than a second, the progress is printed to stderr.
[[nodiscard]] Result<FoundProbes> find_probes(const scene::Scene& scene, const ProbeChoice& choice,
                                              const Limits& limits);

}  // namespace weft::viewer
