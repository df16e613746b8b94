// Purpose: answers questions about the triangles of a scene with a tree of bounding boxes: which surface does
// a ray hit first, and does a box or a ball touch a surface? Every answer is a function of the set of
// triangles: the tests of single triangles do not depend on the tree, and the boxes of the tree are a little
// larger than necessary, so that the tree never hides a triangle that passes its test. A library such as
// Embree does not promise this: of two surfaces at the same place it returns the one that its tree visits
// first, and it computes with other instructions on other processors. It is also a new dependency of 40 MiB
// for a few thousand rays.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "scene/probes/triangle_set.h"

namespace weft::scene {

// The most memory for each triangle while a tree is built, or while its frame is searched (grid_frame_of()),
// in bytes.
inline constexpr uint64_t kTreeBytesPerTriangle = sizeof(SolidTriangle) + 56;

struct Ray {
    glm::dvec3 origin{0};
    glm::dvec3 direction{0};  // Unit length.
    double reach_m = 1e30;    // Surfaces at a greater distance do not count.
};

struct RayHit {
    double distance_m = 0;
    bool is_inside = false;  // The ray hits the back of a surface that has an inside.
    bool is_back = false;    // The ray hits the back of a surface of any kind.
};

class TriangleTree {
 public:
    TriangleTree(std::vector<SolidTriangle> triangles, const LoadOptions& options);

    [[nodiscard]] bool empty() const { return triangles_.empty(); }
    [[nodiscard]] const Bounds& bounds() const { return bounds_; }
    // Returns the nearest surface that blocks light. If several surfaces are hit at the same distance,
    // is_inside is true only if it is true for all of them. The same holds for is_back.
    [[nodiscard]] std::optional<RayHit> nearest(const Ray& ray) const;
    // True if a surface that blocks light is on the ray.
    [[nodiscard]] bool is_blocked(const Ray& ray) const;
    // Returns the number of surfaces with an inside that the ray leaves, minus the number of such surfaces
    // that it enters. If the ray begins inside of closed objects, the result is the number of these objects,
    // even if they penetrate each other.
    [[nodiscard]] int depth_along(const Ray& ray) const;
    // True if a surface of any kind touches the box.
    [[nodiscard]] bool touches(const Bounds& box) const;
    // True if the box contains a place on a surface of any kind, or a place at most `reach_m` in front of it.
    // Both sides of a surface without an inside count as its front.
    [[nodiscard]] bool touches_front(const Bounds& box, float reach_m) const;
    // Visits all triangles whose boxes touch this box, in an order that depends on the order of the
    // triangles.
    void visit(const Bounds& box, const std::function<void(const SolidTriangle&)>& visitor) const;
    // True if the surfaces in the box are not parallel, or if they have very many triangles.
    [[nodiscard]] bool is_uneven(const Bounds& box) const;
    // True if a surface that blocks light is nearer to the point than the radius.
    [[nodiscard]] bool is_near(const glm::vec3& point, float radius_m) const;

    // A node of the tree. An inner node has its children at `first` and `first` + 1; a leaf has `count`
    // triangles from `first` on.
    struct Node {
        Bounds bounds;
        uint32_t first = 0;
        uint32_t count = 0;
    };

 private:
    template <class Enter, class Visit>
    void walk(const Enter& enters, const Visit& visit) const;

    std::vector<SolidTriangle> triangles_;
    std::vector<Node> nodes_;
    Bounds bounds_;
};

}  // namespace weft::scene
