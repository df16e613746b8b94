// Purpose: finds roughly where a ray meets the surfaces of a scene, to learn on the CPU what a camera sees.
// The tree contains a bounding box for each triangle, or for several neighbouring triangles if the scene has
// very many. A ray ends where it enters the first box. So the result is good for statistics, but it is no
// test of visibility. TriangleTree (scene/probes) is no replacement: it stores all triangles and tests them
// exactly, in double precision. So it needs more time and memory, and its rays end at other points. Pure
// data. Units: metres. Source: Lauterbach et al. 2009, "Fast BVH Construction on GPUs" (the order of the
// boxes).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::render {

class SurfaceTree {
 public:
    SurfaceTree() = default;
    explicit SurfaceTree(std::vector<scene::Bounds> boxes);

    [[nodiscard]] bool empty() const { return nodes_.empty(); }
    // Returns the distance at which a ray enters its first box; nullopt if it enters none before `to_m`.
    // Boxes around the start of the ray do not count. `direction` must have unit length.
    [[nodiscard]] std::optional<float> first_entry(const glm::vec3& from, const glm::vec3& direction,
                                                   float to_m) const;

 private:
    // Fills a node and all nodes below it with boxes. Changes the order of `boxes`.
    void fill(size_t node, std::span<scene::Bounds> boxes);

    // A complete binary tree: the children of node i are the nodes 2 i + 1 and 2 i + 2. The last `leaves_`
    // nodes are the boxes. Boxes of unused leaves are empty: min > max.
    std::vector<scene::Bounds> nodes_;
    size_t leaves_ = 0;
};

// Returns boxes around the opaque and masked surfaces of the instances that do not move, in world space.
// `moves_instances`: the program may move every instance, so none counts.
[[nodiscard]] std::vector<scene::Bounds> still_surfaces(const scene::Scene& scene, bool moves_instances);

}  // namespace weft::render
