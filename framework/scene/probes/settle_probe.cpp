#include "scene/probes/settle_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace weft::scene {
namespace {

constexpr size_t kDirections = 64;
// If more rays than this end at the inside of a surface, the point is inside of an object.
constexpr size_t kMostInside = kDirections / 4;
// If at least this many rays hit no surface, the point sees much of the sky.
constexpr size_t kLeastSky = kDirections * 7 / 16;
// is_buried() counts all surfaces along kDepthRays rays. A point is inside of an object if at least
// kLeastBuried of these rays leave more objects than they enter.
constexpr size_t kDepthRays = 8;
constexpr size_t kLeastBuried = 6;
// Nearer surfaces count as if they had this distance, so that a wall beside a probe does not count too much.
constexpr double kLeastDistance_m = 1;
// Number of ways out of an object that are tried.
constexpr size_t kMostExits = 12;

struct Move {
    glm::dvec3 offset{0};
    double length_m = 0;
};

// Returns directions that are spread evenly over the sphere, along a spiral from pole to pole.
std::array<glm::dvec3, kDirections> make_directions() {
    std::array<glm::dvec3, kDirections> out;
    for (size_t i = 0; i < kDirections; ++i) {
        const double y = 1 - (2 * static_cast<double>(i) + 1) / kDirections;
        const double radius = std::sqrt(1 - y * y);
        const double angle =
            2 * std::numbers::pi * static_cast<double>(i) / (std::numbers::phi * std::numbers::phi);
        out[i] = {radius * std::cos(angle), y, radius * std::sin(angle)};
    }
    return out;
}

const std::array<glm::dvec3, kDirections>& directions() {
    static const std::array<glm::dvec3, kDirections> kAll = make_directions();
    return kAll;
}

// True if most rays leave more objects than they enter. This also finds the inside of an object whose own
// surface is hidden by other objects in it.
bool is_buried(const TriangleTree& tree, const glm::vec3& point) {
    size_t inside = 0;
    for (size_t i = 0; i < kDirections; i += kDirections / kDepthRays)
        inside += tree.depth_along({glm::dvec3(point), directions()[i]}) > 0 ? 1 : 0;
    return inside >= kLeastBuried;
}

// Returns moves that lead out of an object, the shortest first. Each move follows a ray to the inside of a
// surface of the object, and ends a little beyond this surface. No move is longer than limits.reach_m. The
// result is empty if the point is not inside of an object.
std::vector<Move> exits_from(const TriangleTree& tree, const glm::vec3& point, const SettleLimits& limits) {
    const double behind_m = 2.0 * double{limits.clearance_m};
    std::vector<Move> exits;
    size_t inside = 0;
    for (const glm::dvec3& direction : directions()) {
        const std::optional<RayHit> hit = tree.nearest({glm::dvec3(point), direction});
        if (!hit || !hit->is_inside) continue;
        ++inside;
        const double length_m = hit->distance_m + behind_m;
        if (length_m <= double{limits.reach_m}) exits.push_back({direction * length_m, length_m});
    }
    if (inside <= kMostInside && !is_buried(tree, point)) exits.clear();
    std::ranges::stable_sort(exits, {}, &Move::length_m);
    if (exits.size() > kMostExits) exits.resize(kMostExits);
    return exits;
}

// Returns moves along the axes and the space diagonals. One of them may lead away from a surface that is too
// near.
std::vector<Move> steps_aside(const SettleLimits& limits) {
    std::vector<Move> steps;
    for (const double factor : {2.0, 4.0}) {
        const double length_m = factor * double{limits.clearance_m};
        if (length_m > double{limits.reach_m}) continue;
        for (int i = 0; i < 27; ++i) {
            const glm::dvec3 way(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            const double axes = glm::dot(way, way);
            if (axes == 1 || axes == 3) steps.push_back({way * (length_m / std::sqrt(axes)), length_m});
        }
    }
    return steps;
}

}  // namespace

bool can_stand(const TriangleTree& tree, const glm::vec3& point, float clearance_m) {
    if (tree.is_near(point, clearance_m)) return false;
    size_t inside = 0;
    for (const glm::dvec3& direction : directions()) {
        const std::optional<RayHit> hit = tree.nearest({glm::dvec3(point), direction});
        if (hit && hit->is_inside && ++inside > kMostInside) return false;
    }
    return !is_buried(tree, point);
}

Settled settle_probe(const TriangleTree& tree, const glm::vec3& point, const SettleLimits& limits) {
    if (can_stand(tree, point, limits.clearance_m))
        return {ProbeState::kept, glm::vec3(0), look_around(tree, point)};
    std::vector<Move> moves = exits_from(tree, point, limits);
    if (tree.is_near(point, limits.clearance_m)) {
        const std::vector<Move> steps = steps_aside(limits);
        moves.insert(moves.end(), steps.begin(), steps.end());
        std::ranges::stable_sort(moves, {}, &Move::length_m);
    }
    Settled best{ProbeState::dropped, glm::vec3(0), {}};
    for (const Move& move : moves) {
        const glm::vec3 offset(move.offset);
        if (!can_stand(tree, point + offset, limits.clearance_m)) continue;
        const Surroundings around = look_around(tree, point + offset);
        if (best.state == ProbeState::dropped || !around.is_minor) best = {ProbeState::moved, offset, around};
        if (!around.is_minor) break;
    }
    return best;
}

Surroundings look_around(const TriangleTree& tree, const glm::vec3& point) {
    size_t sky = 0, backs = 0;
    double nearness = 0;
    for (const glm::dvec3& direction : directions()) {
        const std::optional<RayHit> hit = tree.nearest({glm::dvec3(point), direction});
        sky += hit ? 0 : 1;
        backs += hit && hit->is_back ? 1 : 0;
        if (hit) nearness += 1 / std::max(hit->distance_m, kLeastDistance_m);
    }
    return {sky >= kLeastSky || backs == kDirections, nearness / kDirections};
}

double room_size_at(const TriangleTree& tree, const glm::vec3& point) {
    constexpr double kNoRoom = std::numeric_limits<double>::infinity();
    double least = kNoRoom;
    int closed = 0;
    bool only_backs = true;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 direction(0);
        direction[axis] = 1;
        const std::optional<RayHit> ahead = tree.nearest({glm::dvec3(point), direction});
        const std::optional<RayHit> behind = tree.nearest({glm::dvec3(point), -direction});
        if ((ahead && ahead->is_inside) || (behind && behind->is_inside)) return kNoRoom;
        if (!ahead || !behind) continue;
        ++closed;
        only_backs = only_backs && ahead->is_back && behind->is_back;
        least = std::min(least, ahead->distance_m + behind->distance_m);
    }
    return closed >= 2 && !only_backs ? least : kNoRoom;
}

bool sees(const TriangleTree& tree, const glm::vec3& from, const glm::vec3& to) {
    const glm::dvec3 way = glm::dvec3(to) - glm::dvec3(from);
    const double length_m = glm::length(way);
    return length_m == 0 || !tree.is_blocked({glm::dvec3(from), way / length_m, length_m});
}

}  // namespace weft::scene
