// Purpose: decides whether a probe can stand at a point, and if it cannot, finds another place near the
// point. A point is inside of an object if more than a quarter of the rays from it end at the inside of a
// surface. It is also inside if most rays leave more objects than they enter: this finds points in closed
// objects that penetrate each other.
#pragma once

#include <span>

#include "scene/probes/triangle_tree.h"

namespace weft::scene {

struct Surroundings {
    // True if few probes are enough around the point, for one of two reasons. Nothing blocks the view in at
    // least 7/16 of all directions, so the light varies slowly. Or all directions end at backs of surfaces,
    // so the point is in a closed shell.
    bool is_minor = false;
    // The mean over all directions of 1 / distance to the nearest surface, in 1/m. Distances below 1 m count
    // as 1 m, and the sky counts as 0. Light varies faster where the mean is larger. Source: Ward et al.
    // 1988, "A Ray Tracing Solution for Diffuse Interreflection".
    double nearness_per_m = 0;
};

struct Settled {
    ProbeState state = ProbeState::kept;
    glm::vec3 offset{0};
    Surroundings around;
};

struct SettleLimits {
    float clearance_m = 0.05f;  // A probe is at least this far from each surface that blocks light.
    float reach_m = 0;          // A probe moves at most this far.
};

// Keeps the probe at the point if it can stand there. Otherwise tries moves, the shortest first: out of an
// object along a ray through the inside of a surface, and away from a surface that is too near. Takes the
// first place where the probe is not minor. If all places are minor, takes the first place where the probe
// can stand. If the probe can stand at no place, drops it.
[[nodiscard]] Settled settle_probe(const TriangleTree& tree, const glm::vec3& point,
                                   const SettleLimits& limits);

// True if the point is outside of all objects and at least this far from each surface that blocks light.
[[nodiscard]] bool can_stand(const TriangleTree& tree, const glm::vec3& point, float clearance_m);

[[nodiscard]] Surroundings look_around(const TriangleTree& tree, const glm::vec3& point);

// Returns the smallest dimension of the room that contains the point: the distance between two surfaces on
// opposite sides, along x, y or z. Returns infinity if fewer than two axes have surfaces on both sides, or if
// the point is inside of an object or a closed shell.
[[nodiscard]] double room_size_at(const TriangleTree& tree, const glm::vec3& point);

// True if no surface that blocks light is between the two points.
[[nodiscard]] bool sees(const TriangleTree& tree, const glm::vec3& from, const glm::vec3& to);

}  // namespace weft::scene
