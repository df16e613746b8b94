#include "weft/scene/motion.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/model/node_placement.h"

namespace weft::scene {
namespace {

glm::quat quaternion(const glm::vec4& xyzw) {
    return {xyzw.w, xyzw.x, xyzw.y, xyzw.z};
}

glm::vec4 between(const MotionSampler& sampler, size_t key, double seconds, double span_s) {
    const auto u = static_cast<float>(seconds / span_s);
    const auto span = static_cast<float>(span_s);
    if (sampler.interpolation == Interpolation::cubic_spline) {
        const glm::vec4 *from = &sampler.values[3 * key], *to = from + 3;
        const float u2 = u * u, u3 = u2 * u;
        return (2 * u3 - 3 * u2 + 1) * from[1] + (u3 - 2 * u2 + u) * span * from[2] +
               (3 * u2 - 2 * u3) * to[1] + (u3 - u2) * span * to[0];
    }
    const glm::vec4 &from = sampler.values[key], &to = sampler.values[key + 1];
    if (!sampler.rotates) return glm::mix(from, to, u);
    const glm::quat turned = glm::slerp(quaternion(from), quaternion(to), u);
    return {turned.x, turned.y, turned.z, turned.w};
}

// Returns the time within one repetition of an animation: at least 0 and less than `length_s`.
double repeated(double time_s, double length_s) {
    if (!(length_s > 0) || !std::isfinite(time_s)) return 0;
    const double rest = std::fmod(time_s, length_s);
    return rest < 0 ? rest + length_s : rest;
}

void apply(const glm::vec4& value, MotionPath path, MovingNode& node) {
    switch (path) {
        case MotionPath::translation:
            node.translation = glm::vec3(value);
            return;
        case MotionPath::rotation:
            node.rotation = quaternion(value);
            return;
        case MotionPath::scale:
            node.scale = glm::vec3(value);
            return;
    }
}

}  // namespace

glm::vec4 value_at(const MotionSampler& sampler, double time_s) {
    const std::vector<float>& times = sampler.times_s;
    const bool is_spline = sampler.interpolation == Interpolation::cubic_spline;
    const auto next = static_cast<size_t>(std::ranges::upper_bound(times, time_s) - times.begin());
    const size_t key = next == 0 ? 0 : next - 1;
    glm::vec4 value = sampler.values[is_spline ? 3 * key + 1 : key];
    if (next > 0 && next < times.size() && sampler.interpolation != Interpolation::step)
        value = between(sampler, key, time_s - times[key], double{times[next]} - double{times[key]});
    return sampler.rotates ? unit_quaternion(value) : value;
}

std::vector<glm::mat4> transforms_at(const Motion& motion, double time_s) {
    std::vector<MovingNode> nodes = motion.nodes;
    for (const Animation& animation : motion.animations) {
        const double seconds = repeated(time_s, animation.length_s);
        for (const MotionChannel& channel : animation.channels)
            apply(value_at(animation.samplers[channel.sampler], seconds), channel.path, nodes[channel.node]);
    }
    std::vector<glm::mat4> world;
    world.reserve(nodes.size());
    for (const MovingNode& node : nodes) {
        const glm::mat4 before = node.parent == kNone ? node.before : world[node.parent] * node.before;
        const glm::mat4 turned =
            glm::translate(before, node.translation) * glm::mat4_cast(node.rotation);
        const glm::mat4 placed = glm::scale(turned, node.scale);
        world.push_back(is_usable_transform(placed) ? placed : invisible_transform());
    }
    return world;
}

}  // namespace weft::scene
