#include "weft/scene/place_probes.h"
#include "graph/diagnostics/make_error.h"

#include <algorithm>

#include "scene/loading/memory_budget.h"
#include "scene/probes/grid_frame.h"
#include "scene/probes/place_reflections.h"
#include "scene/probes/refine_grid.h"
#include "scene/probes/scene_tree.h"

namespace weft::scene {

Result<std::vector<SolidTriangle>> scene_triangles(const Scene& scene, const SceneLimits& limits,
                                                   const LoadOptions& options) {
    constexpr uint64_t kBytesPerMiB = 1ull << 20;
    const uint64_t triangles = count_triangles(scene);
    const uint64_t left_bytes = limits.memory_bytes - std::min(limits.memory_bytes, scene.memory_bytes);
    const bool fits = triangles <= left_bytes / kTreeBytesPerTriangle && triangles < kNone;
    if (fits) return collect_triangles(scene, options);
    return make_error(
        "S199",
        "placing probes among the " + std::to_string(triangles) + " triangles of the scene needs " +
            std::to_string(saturating_mul(triangles, kTreeBytesPerTriangle) / kBytesPerMiB) +
            " MiB of memory; the limit leaves " + std::to_string(left_bytes / kBytesPerMiB) + " MiB",
        {"list the probes in a file and use --probes FILE, " + raise_limit_text("scene.memoryBytes")});
}

Result<TriangleTree> scene_tree(const Scene& scene, const SceneLimits& limits, const LoadOptions& options) {
    Result<std::vector<SolidTriangle>> triangles = scene_triangles(scene, limits, options);
    if (!triangles) return triangles.take_errors();
    return TriangleTree(std::move(*triangles), options);
}

Result<Probes> place_probes(const Scene& scene, const PlacementParams& params, const SceneLimits& limits,
                            const LoadOptions& options) {
    Result<std::vector<SolidTriangle>> triangles = scene_triangles(scene, limits, options);
    if (!triangles) return triangles.take_errors();
    const GridFrame frame = grid_frame_of(*triangles, double{params.min_spacing_m});
    move_to_grid_frame(*triangles, frame);
    const TriangleTree tree(std::move(*triangles), options);
    PlacementParams in_frame = params;
    if (params.camera) in_frame.camera = to_grid_frame(frame, *params.camera);
    Probes probes;
    std::optional<ProbeVolume> volume = fit_volume(tree, in_frame, options.threads);
    // Around a camera, the origin of the grid does not move with the scene.
    const glm::vec3 fixed = to_grid_frame(frame, glm::vec3(0.5f * params.min_spacing_m));
    probes.volume = volume ? std::move(*volume) : surround_camera(tree, fixed, in_frame, options.threads);
    probes.reflections = scene.probes.reflections;
    if (probes.reflections.empty()) {
        probes.reflections = place_reflections(tree, probes.volume, options.threads);
        for (ReflectionProbe& probe : probes.reflections) probe.position = to_world(frame, probe.position);
    }
    probes.volume.origin = to_world(frame, probes.volume.origin);
    probes.volume.yaw_deg = frame.yaw_deg;
    return probes;
}

}  // namespace weft::scene
