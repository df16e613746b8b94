// Purpose: describes how the nodes of a scene move, as plain data, and computes their transforms at a time.
// Units: seconds, metres. Quaternions are stored as (x, y, z, w). Source: "glTF 2.0 Specification", Khronos
// Group, 2021, appendix C (interpolation).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

namespace weft::scene {

inline constexpr uint32_t kNone = UINT32_MAX;

enum class Interpolation : uint8_t { step, linear, cubic_spline };
enum class MotionPath : uint8_t { translation, rotation, scale };

// A value over time. Before the first key, it is the value of the first key; after the last key, it is the
// value of the last key.
struct MotionSampler {
    Interpolation interpolation = Interpolation::linear;
    bool rotates = false;        // True: the values are quaternions. False: w is not used.
    std::vector<float> times_s;  // The times of the keys: at least one; finite, not negative, ascending.
    // One value for each key. With cubic_spline three for each key: the in-tangent, the value and the
    // out-tangent, where the tangents are per second.
    std::vector<glm::vec4> values;
};

struct MotionChannel {
    uint32_t node = 0;  // Index into Motion::nodes.
    MotionPath path = MotionPath::translation;
    uint32_t sampler = 0;  // Index into Animation::samplers.
};

// A set of channels that repeat together every `length_s` seconds.
struct Animation {
    std::string name;
    double length_s = 0;  // Time of the last key of all channels; 0: the animation does not move.
    std::vector<MotionSampler> samplers;
    std::vector<MotionChannel> channels;
};

// A node that moves, because a channel moves it or one of its parents. Its transform in the world is
// world(parent) * before * translation * rotation * scale.
struct MovingNode {
    // Index into Motion::nodes, smaller than the index of this node; kNone: no parent moves.
    uint32_t parent = kNone;
    glm::mat4 before{1};
    glm::vec3 translation{0};
    glm::quat rotation{1, 0, 0, 0};
    glm::vec3 scale{1};
};

struct Motion {
    std::vector<MovingNode> nodes;
    std::vector<Animation> animations;
};

// Returns the value at `time_s`. A quaternion of the result has length 1.
[[nodiscard]] glm::vec4 value_at(const MotionSampler& sampler, double time_s);

// Returns the transform from object space to world space of every node of `motion`, at a time of any size and
// sign: each animation repeats. A transform that is not finite or has a number above 1e15 becomes a matrix
// that moves all points to the origin, so that the node is invisible.
[[nodiscard]] std::vector<glm::mat4> transforms_at(const Motion& motion, double time_s);

}  // namespace weft::scene
