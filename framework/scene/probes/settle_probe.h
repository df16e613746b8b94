// Purpose: decides whether a probe can stand at a point, and where else it stands if not. A probe from which
// more than a quarter of the directions end at the inside of a surface is inside of an object. So is a probe
// that is inside of closed objects which penetrate each other.
#pragma once

#include <span>

#include "scene/probes/triangle_tree.h"

namespace weft::scene {

struct Settled {
    ProbeState state = ProbeState::kept;
    glm::vec3 offset{0};
    bool is_open = false;  // The probe sees the sky in many directions.
};

struct SettleLimits {
    float clearance_m = 0.05f;  // A probe is at least this far from each surface that blocks light.
    float reach_m = 0;          // A probe moves at most this far.
};

// Moves the probe as little as possible. From the inside of an object, it leaves along a ray to the inside of
// a surface, the nearest one first. From a surface, it moves away. It prefers places that are not open.
[[nodiscard]] Settled settle_probe(const TriangleTree& tree, const glm::vec3& point,
                                   const SettleLimits& limits);

// True if the point is outside of all objects and at least this far from each surface that blocks light.
[[nodiscard]] bool can_stand(const TriangleTree& tree, const glm::vec3& point, float clearance_m);

// True if nothing blocks the view from the point in at least 7/16 of all directions. Around an open point,
// the light varies slowly.
[[nodiscard]] bool is_open(const TriangleTree& tree, const glm::vec3& point);

// Returns the smallest dimension of the room that contains the point: the distance between two surfaces on
// opposite sides, along x, y or z. Returns infinity if fewer than two axes have surfaces on both sides, or if
// the point is inside of an object.
[[nodiscard]] double room_size_at(const TriangleTree& tree, const glm::vec3& point);

// True if no surface that blocks light is between the two points.
[[nodiscard]] bool sees(const TriangleTree& tree, const glm::vec3& from, const glm::vec3& to);

}  // namespace weft::scene
