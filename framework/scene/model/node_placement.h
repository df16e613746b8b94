// Purpose: places lights and cameras at the transform of a node. Units: metres.
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

// True if all numbers of the matrix are finite and at most 1e15.
[[nodiscard]] bool is_usable_transform(const glm::mat4& transform);
// Returns a transform that makes an object invisible: it moves all points to the origin.
[[nodiscard]] glm::mat4 invisible_transform();

// Returns the quaternion (x, y, z, w), scaled to length 1. If the length of the quaternion is nearly 0 or not
// finite, returns (0, 0, 0, 1), which is no rotation.
[[nodiscard]] glm::vec4 unit_quaternion(const glm::vec4& xyzw);

// Sets the position, direction and side of a light from `world`, the transform of its node. The shape of a
// light extends along the x axis of the node. The light faces along the −z axis of the node.
void place_light(const glm::mat4& world, Light& light);

// Returns the transform without scale and shear, for a camera. A camera looks along its −z axis, and the
// scale of its parent nodes must not distort the picture.
[[nodiscard]] glm::mat4 rigid_transform(const glm::mat4& world);

// Moves the instances, lights and cameras of the scene that belong to moving nodes to the given transforms,
// the result of transforms_at().
void apply_pose(const std::vector<glm::mat4>& nodes, Scene& scene);

}  // namespace weft::scene
