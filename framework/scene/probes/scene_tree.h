// Purpose: the triangles of a scene, and the tree of them. Error: S199 the tree needs more memory than the
// limit leaves.
#pragma once

#include "scene/probes/triangle_tree.h"
#include "weft/limits.h"
#include "weft/result.h"

namespace weft::scene {

[[nodiscard]] Result<std::vector<SolidTriangle>> scene_triangles(const Scene& scene,
                                                                 const SceneLimits& limits,
                                                                 const LoadOptions& options);
[[nodiscard]] Result<TriangleTree> scene_tree(const Scene& scene, const SceneLimits& limits,
                                              const LoadOptions& options);

}  // namespace weft::scene
