// Source of clip(): Sutherland and Hodgman 1974, "Reentrant Polygon Clipping".
#include "scene/probes/cell_view.h"

#include <algorithm>
#include <cmath>

#include "scene/probes/settle_probe.h"
#include "scene/probes/triangle_tests.h"

namespace weft::scene {
namespace {

// Surfaces in a box are tested at places in front of them. The box is divided into this many parts along each
// axis. Each part has at most one place for each of the six directions (±x, ±y, ±z) that surfaces can face.
constexpr int kParts = 3;
constexpr size_t kPlaces = size_t{kParts} * kParts * kParts * 6;
// The places before a polygon are chosen on lines from its centre to its corners, and to the middles of its
// edges. The constants are positions on such a line: 0 is the centre, 1 is the end. Lines to corners have
// places at both positions, lines to the middles of edges only at kNearCorner.
constexpr double kNearCorner = 0.85, kNearMiddle = 0.5;

using Polygon = std::vector<glm::dvec3>;

// Returns the part of the polygon on one side of a plane that is perpendicular to an axis.
Polygon clip_at(const Polygon& polygon, int axis, double plane, double side) {
    Polygon out;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double from = (a[axis] - plane) * side, to = (b[axis] - plane) * side;
        if (from >= 0) out.push_back(a);
        if ((from >= 0) != (to >= 0)) out.push_back(a + (b - a) * (from / (from - to)));
    }
    return out;
}

Polygon clip_to(const Bounds& box, Polygon polygon) {
    for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
        polygon = clip_at(polygon, axis, double{box.min[axis]}, 1);
        polygon = clip_at(polygon, axis, double{box.max[axis]}, -1);
    }
    return polygon;
}

bool is_smaller(const glm::vec3& a, const glm::vec3& b) {
    if (a.x != b.x) return a.x < b.x;
    return a.y != b.y ? a.y < b.y : a.z < b.z;
}

// Keeps at most one place for each part of the box and each of the six directions. Of several places, the one
// with the smallest coordinates is kept, so that the order of the triangles does not matter.
class PlaceList {
 public:
    explicit PlaceList(const Bounds& box) : box_(box), places_(kPlaces) {}

    void add(const glm::dvec3& place, const glm::dvec3& facing) {
        const glm::vec3 at(place);
        const glm::ivec3 part = glm::clamp(
            glm::ivec3(glm::floor((at - box_.min) / (box_.max - box_.min) * float{kParts})), 0, kParts - 1);
        const glm::dvec3 size = glm::abs(facing);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const int direction = 2 * axis + (facing[axis] < 0 ? 1 : 0);
        std::optional<glm::vec3>& kept =
            places_[static_cast<size_t>(((part.z * kParts + part.y) * kParts + part.x) * 6 + direction)];
        if (!kept || is_smaller(at, *kept)) kept = at;
    }

    [[nodiscard]] std::vector<glm::vec3> take() const {
        std::vector<glm::vec3> out;
        for (const std::optional<glm::vec3>& place : places_)
            if (place) out.push_back(*place);
        return out;
    }

 private:
    Bounds box_;
    std::vector<std::optional<glm::vec3>> places_;
};

void add_places(const SolidTriangle& triangle, const glm::dvec3& shift, const glm::dvec3& facing,
                const Bounds& box, PlaceList& out) {
    std::array<glm::dvec3, 3> c;
    for (size_t i = 0; i < 3; ++i) c[i] = glm::dvec3(triangle.corners[i]) + shift;
    const glm::dvec3 low = glm::min(c[0], glm::min(c[1], c[2])), high = glm::max(c[0], glm::max(c[1], c[2]));
    const glm::dvec3 box_low(box.min), box_high(box.max);
    if (glm::any(glm::greaterThan(low, box_high)) || glm::any(glm::lessThan(high, box_low))) return;
    const bool is_small = glm::all(glm::lessThan((high - low) * (2.0 * kParts), box_high - box_low));
    if (is_small) {
        const glm::dvec3 middle = (c[0] + c[1] + c[2]) / 3.0;
        if (glm::all(glm::greaterThanEqual(middle, box_low)) &&
            glm::all(glm::lessThanEqual(middle, box_high)))
            out.add(middle, facing);
        return;
    }
    const Polygon polygon = clip_to(box, {c.begin(), c.end()});
    if (polygon.size() < 3) return;
    glm::dvec3 centre(0);
    for (const glm::dvec3& corner : polygon) centre += corner / static_cast<double>(polygon.size());
    out.add(centre, facing);
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 middle = (polygon[i] + polygon[(i + 1) % polygon.size()]) * 0.5;
        out.add(glm::mix(centre, polygon[i], kNearCorner), facing);
        out.add(glm::mix(centre, middle, kNearCorner), facing);
        out.add(glm::mix(centre, polygon[i], kNearMiddle), facing);
    }
}

}  // namespace

std::vector<glm::vec3> places_before_surfaces(const TriangleTree& tree, const Bounds& box, float distance_m) {
    PlaceList places(box);
    tree.visit({box.min - distance_m, box.max + distance_m}, [&](const SolidTriangle& triangle) {
        const glm::dvec3 normal = normal_of(triangle);
        if (normal == glm::dvec3(0)) return;
        const glm::dvec3 shift = normal * double{distance_m};
        add_places(triangle, shift, normal, box, places);
        if (!triangle.has_inside) add_places(triangle, -shift, -normal, box, places);
    });
    return places.take();
}

CellView view_of_cell(const TriangleTree& tree, const Bounds& box,
                      const std::array<std::optional<glm::vec3>, 8>& probes, const ViewLimits& limits) {
    CellView view;
    // Returns true if a probe sees the place. Also marks the probes that see the place in view.useful.
    const auto is_seen = [&](const glm::vec3& place) {
        bool seen = false;
        for (size_t i = 0; i < probes.size(); ++i) {
            const auto bit = static_cast<uint8_t>(1u << i);
            if (!probes[i] || (seen && (view.useful & bit) != 0) || !sees(tree, place, *probes[i])) continue;
            view.useful = static_cast<uint8_t>(view.useful | bit);
            seen = true;
        }
        return seen;
    };
    uint8_t all = 0;
    for (size_t i = 0; i < probes.size(); ++i)
        if (probes[i]) all = static_cast<uint8_t>(all | 1u << i);
    for (const glm::vec3& place : places_before_surfaces(tree, box, limits.close_m)) {
        if (view.has_dark_place && view.useful == all) return view;
        if (!is_seen(place) && !view.has_dark_place)
            view.has_dark_place = can_stand(tree, place, limits.clearance_m);
    }
    if (view.useful == all) return view;
    for (const glm::vec3& place : places_before_surfaces(tree, box, limits.far_m)) (void)is_seen(place);
    return view;
}

}  // namespace weft::scene
