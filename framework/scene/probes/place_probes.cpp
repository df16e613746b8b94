#include "weft/scene/place_probes.h"

#include <algorithm>

#include "scene/loading/memory_budget.h"
#include "scene/probes/place_reflections.h"
#include "scene/probes/refine_grid.h"
#include "scene/probes/scene_tree.h"

namespace weft::scene {

Result<TriangleTree> scene_tree(const Scene& scene, const SceneLimits& limits, const LoadOptions& options) {
    constexpr uint64_t kBytesPerMiB = 1ull << 20;
    const uint64_t triangles = count_triangles(scene);
    const uint64_t left_bytes = limits.memory_bytes - std::min(limits.memory_bytes, scene.memory_bytes);
    const bool fits = triangles <= left_bytes / kTreeBytesPerTriangle && triangles < kNone;
    if (fits) return TriangleTree(collect_triangles(scene, options), options);
    Diagnostic fault;
    fault.code = "S199";
    fault.message = "placing probes among the " + std::to_string(triangles) +
                    " triangles of the scene needs " +
                    std::to_string(saturating_mul(triangles, kTreeBytesPerTriangle) / kBytesPerMiB) +
                    " MiB of memory; the limit leaves " + std::to_string(left_bytes / kBytesPerMiB) + " MiB";
    fault.help = {"list the probes in a file and use --probes FILE, " +
                  raise_limit_text("scene.memoryBytes")};
    return fault;
}

Result<Probes> place_probes(const Scene& scene, const PlacementParams& params, const SceneLimits& limits,
                            const LoadOptions& options) {
    Result<TriangleTree> tree = scene_tree(scene, limits, options);
    if (!tree) return tree.take_errors();
    Probes probes;
    std::optional<ProbeVolume> volume = fit_volume(*tree, params, options.threads);
    probes.volume = volume ? std::move(*volume) : surround_camera(*tree, params, options.threads);
    probes.reflections = scene.probes.reflections;
    if (probes.reflections.empty())
        probes.reflections = place_reflections(*tree, probes.volume, options.threads);
    return probes;
}

}  // namespace weft::scene
