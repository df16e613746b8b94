// Purpose: the vertex streams a mesh lacks: normals, tangents, bounds.
// Shapes: `positions`, `uvs` (or empty) and `indices` are inputs; every index is below positions.size().
// Convention: a tangent points where u grows; cross(normal, tangent) * w points where v falls, because glTF's
// v runs down the image and the green channel of a normal map means "up". Source: M. Mikkelsen, "Simulation
// of Wrinkled Surfaces Revisited", 2008 (angle-weighted, per-vertex tangents).
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

// Smooth, area-weighted normals for every vertex; a vertex of no area gets +y.
void generate_normals(Mesh& mesh);

// Gives every triangle its own three vertices and its face normal, as glTF asks when normals are absent.
void make_flat(Mesh& mesh);

// Needs normals. A vertex shared by triangles of mirrored uvs is split in two. Without uvs, any orthonormal
// tangent. `uv_set` 1: of second_uvs, where the mesh has them.
void generate_tangents(Mesh& mesh, uint32_t uv_set = 0);

// Unit tangent orthogonal to unit `normal`, as near to `tangent` as possible; any one when it has no such
// part.
[[nodiscard]] glm::vec3 orthonormal_tangent(const glm::vec3& normal, const glm::vec3& tangent);

void compute_bounds(Mesh& mesh);

}  // namespace weft::scene
