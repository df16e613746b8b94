// Purpose: finds out where the probes of a scene stand. Either this code places them, as a pure function of
// the geometry, or a file lists them. Errors: S196 a wrong value in the file, S197 too many probes, S199 the
// placement needs too much memory; W001 to W005 the file is not JSON. The result is the same, bit for bit,
// for every order of meshes, instances and triangles, and for every number of threads.
#pragma once

#include <optional>
#include <string>

#include "weft/file_reader.h"
#include "weft/limits.h"
#include "weft/result.h"
#include "weft/scene/load_progress.h"
#include "weft/scene/scene.h"

namespace weft::scene {

struct PlacementParams {
    // Limit of the number of probes: at least 8, at most kMostIrradianceProbes.
    uint32_t most_probes = kMostIrradianceProbes;
    // The finest spacing. Near objects the spacing is at most 4 times as large, on open ground 32 times.
    float min_spacing_m = 0.5f;
    // Large scenes get their probes around this place. nullopt: the centre of the geometry.
    std::optional<glm::vec3> camera;
};

// Places the probes. Instances that move are ignored. If the scene lists reflection probes, the result
// contains exactly the listed reflection probes.
[[nodiscard]] Result<Probes> place_probes(const Scene& scene, const PlacementParams& params = {},
                                          const SceneLimits& limits = {}, const LoadOptions& options = {});

// Reads a file with probes. docs/probes.md describes the format. A volume with "size" is fitted to the
// geometry of `scene`. If the file lists no reflection probes, the result has those of the scene.
[[nodiscard]] Result<Probes> read_probes(const std::string& path, const FileReader& reader,
                                         const Scene& scene, const SceneLimits& limits = {},
                                         const LoadOptions& options = {});

// Returns the probes as the text of a file that read_probes() reads.
[[nodiscard]] std::string probes_to_json(const Probes& probes);

}  // namespace weft::scene
