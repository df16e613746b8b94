// Purpose: computes missing vertex streams of a mesh: normals, tangents, bounds. Shapes: `positions`, `uvs`
// (or empty) and `indices` are inputs; every index is below positions.size(). Convention: a tangent points
// towards increasing u; cross(normal, tangent) * w points towards decreasing v, because glTF's v runs down
// the image and the green channel of a normal map means "up". Source: M. Mikkelsen, "Simulation of Wrinkled
// Surfaces Revisited", 2008 (angle-weighted, per-vertex tangents).
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

// Smooth, area-weighted normals for every vertex; a vertex without area gets +y.
void generate_normals(Mesh& mesh);

// Gives every triangle its own three vertices and its face normal, as glTF requires when normals are absent.
void make_flat(Mesh& mesh);

// Requires normals. A vertex shared by triangles of mirrored and unmirrored uvs is split in two. Without uvs,
// any orthonormal tangent is used. `uv_set` 1 uses second_uvs if the mesh has them.
void generate_tangents(Mesh& mesh, uint32_t uv_set = 0);

// The unit tangent orthogonal to the unit vector `normal` that is nearest to `tangent`; any orthogonal vector
// when `tangent` is parallel to `normal`.
[[nodiscard]] glm::vec3 orthonormal_tangent(const glm::vec3& normal, const glm::vec3& tangent);

void compute_bounds(Mesh& mesh);

}  // namespace weft::scene
