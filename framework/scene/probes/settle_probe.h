// Purpose: decides whether a probe can stand at a point, and where else it stands if not. A probe from which
// more than a quarter of the directions end at the inside of a surface is inside of an object. So is a probe
// that is inside of closed objects which penetrate each other.
#pragma once

#include <span>

#include "scene/probes/triangle_tree.h"

namespace weft::scene {

struct Surroundings {
    // Few probes are enough around the point: nothing blocks the view in at least 7/16 of all directions, so
    // the light varies slowly; or all directions end at backs of surfaces, so the point is in a closed shell.
    bool is_minor = false;
    // The mean of the inverse distance of what is seen, in 1/m. Light varies faster where this is larger.
    // Source: Ward et al. 1988, "A Ray Tracing Solution for Diffuse Interreflection".
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

// Moves the probe as little as possible. From the inside of an object, it leaves along a ray to the inside of
// a surface, the nearest one first. From a surface, it moves away. It prefers places that are not minor.
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
