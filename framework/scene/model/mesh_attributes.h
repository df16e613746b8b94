// Purpose: computes data that a mesh may lack: normals, tangents and bounds. Shapes: the inputs are
// `positions`, `uvs` (may be empty) and `indices`; every index is below positions.size(). Convention: a
// tangent is (x, y, z, w), and w is 1 or -1. (x, y, z) points towards increasing u. cross(normal, tangent) *
// w points towards decreasing v, because glTF's v runs down the image and the green channel of a normal map
// means "up". Source: M. Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008 (angle-weighted,
// per-vertex tangents).
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

// Computes a smooth, area-weighted normal for every vertex. A vertex whose triangles have no area gets +y.
void generate_normals(Mesh& mesh);

// Gives every triangle its own three vertices, and gives these vertices the normal of the triangle. glTF
// requires flat normals for a mesh that has no normals.
void make_flat(Mesh& mesh);

// Computes the tangents; the mesh must already have normals. A vertex that belongs to triangles with mirrored
// and with unmirrored uvs is split in two. Without uvs, each vertex gets any tangent that is perpendicular to
// its normal. `uv_set` 1 uses second_uvs if the mesh has them.
void generate_tangents(Mesh& mesh, uint32_t uv_set = 0);

// Returns the unit vector that is perpendicular to the unit vector `normal` and nearest to `tangent`. If
// `tangent` is zero or parallel to `normal`, the result is any perpendicular unit vector.
[[nodiscard]] glm::vec3 orthonormal_tangent(const glm::vec3& normal, const glm::vec3& tangent);

void compute_bounds(Mesh& mesh);

}  // namespace weft::scene
