#include "scene/probes/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scene/loading/worker_threads.h"
#include "scene/probes/triangle_tests.h"

namespace weft::scene {
namespace {

using Node = TriangleTree::Node;

constexpr uint32_t kLeafTriangles = 4;
// From this depth on, the two children of a node get equal numbers of triangles. At smaller depths, they get
// equal parts of the space of the node. This limits the depth of the tree.
constexpr uint32_t kSpatialDepth = 40;
constexpr size_t kDeepestStack = 96;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A range of the list of triangles. One node of the tree is made from each range.
struct Span {
    uint32_t node = 0;
    uint32_t begin = 0;
    uint32_t end = 0;
    uint32_t depth = 0;
};

glm::vec3 centre_of(const SolidTriangle& triangle) {
    return triangle.corners[0] + triangle.corners[1] + triangle.corners[2];
}

void grow(Bounds& bounds, const glm::vec3& point) {
    bounds.min = glm::min(bounds.min, point);
    bounds.max = glm::max(bounds.max, point);
}

// Makes the box larger by more than the rounding errors of the tests.
Bounds padded(const Bounds& bounds) {
    const glm::vec3 most = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
    const glm::vec3 margin(1e-6f * std::max({most.x, most.y, most.z, 1.0f}));
    return {bounds.min - margin, bounds.max + margin};
}

// Builds nodes for parts of one list of triangles.
class Builder {
 public:
    explicit Builder(std::vector<SolidTriangle>& triangles) : triangles_(triangles) {}

    // Fills the node of the span. Returns false if this node is a leaf. Otherwise, adds its two children to
    // `nodes` and sets the spans of the children.
    bool divide(const Span& span, std::vector<Node>& nodes, std::array<Span, 2>& children) const {
        Bounds centres{glm::vec3(kInfinity), glm::vec3(-kInfinity)}, bounds = centres;
        for (uint32_t i = span.begin; i < span.end; ++i) {
            for (const glm::vec3& corner : triangles_[i].corners) grow(bounds, corner);
            grow(centres, centre_of(triangles_[i]));
        }
        nodes[span.node].bounds = padded(bounds);
        if (span.end - span.begin <= kLeafTriangles) {
            nodes[span.node].first = span.begin;
            nodes[span.node].count = span.end - span.begin;
            return false;
        }
        const uint32_t middle = cut(span, centres);
        const uint32_t first = static_cast<uint32_t>(nodes.size());
        nodes[span.node].first = first;
        nodes.resize(nodes.size() + 2);
        children[0] = {first, span.begin, middle, span.depth + 1};
        children[1] = {first + 1, middle, span.end, span.depth + 1};
        return true;
    }

    [[nodiscard]] std::vector<Node> subtree(Span root) const {
        std::vector<Node> nodes(1);
        root.node = 0;
        std::vector<Span> open{root};
        while (!open.empty()) {
            const Span span = open.back();
            open.pop_back();
            std::array<Span, 2> children;
            if (divide(span, nodes, children)) open.insert(open.end(), children.begin(), children.end());
        }
        return nodes;
    }

 private:
    // Sorts the triangles of the span into two groups. Returns the beginning of the second group.
    [[nodiscard]] uint32_t cut(const Span& span, const Bounds& centres) const {
        const glm::vec3 size = centres.max - centres.min;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto begin = triangles_.begin() + span.begin, end = triangles_.begin() + span.end;
        const float middle = centres.min[axis] + size[axis] * 0.5f;
        const auto found = span.depth >= kSpatialDepth
                               ? end
                               : std::partition(begin, end, [&](const SolidTriangle& triangle) {
                                     return centre_of(triangle)[axis] < middle;
                                 });
        if (found != begin && found != end) return static_cast<uint32_t>(found - triangles_.begin());
        const auto half = begin + (end - begin) / 2;
        std::nth_element(begin, half, end, [&](const SolidTriangle& a, const SolidTriangle& b) {
            return centre_of(a)[axis] < centre_of(b)[axis];
        });
        return static_cast<uint32_t>(half - triangles_.begin());
    }

    std::vector<SolidTriangle>& triangles_;
};

// Divides spans (ranges of the list of triangles) until there are enough spans for all threads. Adds the
// nodes of the divided spans to `nodes`.
std::vector<Span> first_spans(const Builder& builder, uint32_t count, std::vector<Node>& nodes) {
    nodes.assign(1, {});
    std::vector<Span> spans{{0, 0, count, 0}};
    // Number of subtrees that are built in parallel.
    constexpr size_t kSubtrees = 64;
    size_t next = 0;
    while (next < spans.size() && spans.size() - next < kSubtrees) {
        std::array<Span, 2> children;
        if (builder.divide(spans[next++], nodes, children))
            spans.insert(spans.end(), children.begin(), children.end());
    }
    return {spans.begin() + static_cast<std::ptrdiff_t>(next), spans.end()};
}

// Puts the nodes of a subtree behind `nodes`. The root of the subtree replaces the node `root`.
void append_subtree(const std::vector<Node>& subtree, uint32_t root, std::vector<Node>& nodes) {
    // Node 1 of the subtree gets the index nodes.size(). So nodes.size() − 1 is added to each index of a
    // child.
    const uint32_t shift = static_cast<uint32_t>(nodes.size()) - 1;
    for (size_t i = 0; i < subtree.size(); ++i) {
        Node node = subtree[i];
        if (node.count == 0) node.first += shift;
        if (i == 0)
            nodes[root] = node;
        else
            nodes.push_back(node);
    }
}

// A ray in a form that is fast to test against boxes: with the inverse of its direction.
struct Slabs {
    explicit Slabs(const Ray& ray) : origin(ray.origin) {
        for (int i = 0; i < 3; ++i)
            inverse[i] = std::abs(ray.direction[i]) > 1e-30 ? 1 / ray.direction[i] : 1e30;
    }

    // Returns the distance at which the ray enters the box; infinity if it misses the box.
    [[nodiscard]] double enter(const Bounds& box) const {
        const glm::dvec3 a = (glm::dvec3(box.min) - origin) * inverse;
        const glm::dvec3 b = (glm::dvec3(box.max) - origin) * inverse;
        const glm::dvec3 low = glm::min(a, b), high = glm::max(a, b);
        const double near = std::max({low.x, low.y, low.z, 0.0}), far = std::min({high.x, high.y, high.z});
        return near <= far ? near : double{kInfinity};
    }

    glm::dvec3 origin;
    glm::dvec3 inverse{0};
};

bool overlap(const Bounds& a, const Bounds& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
           a.min.z <= b.max.z && b.min.z <= a.max.z;
}

}  // namespace

TriangleTree::TriangleTree(std::vector<SolidTriangle> triangles, const LoadOptions& options)
    : triangles_(std::move(triangles)) {
    if (triangles_.empty()) return;
    bounds_ = {glm::vec3(kInfinity), glm::vec3(-kInfinity)};
    for (const SolidTriangle& triangle : triangles_)
        for (const glm::vec3& corner : triangle.corners) grow(bounds_, corner);
    const Builder builder(triangles_);
    const std::vector<Span> spans = first_spans(builder, static_cast<uint32_t>(triangles_.size()), nodes_);
    StageProgress progress(options, "parts of the tree", spans.size());
    std::vector<std::vector<Node>> subtrees(spans.size());
    run_on_threads(spans.size(), options.threads, [&](size_t i) {
        subtrees[i] = builder.subtree(spans[i]);
        progress.step();
    });
    for (size_t i = 0; i < spans.size(); ++i) append_subtree(subtrees[i], spans[i].node, nodes_);
}

// Visits the triangles of all leaves whose boxes `enters` accepts, until `visit` returns true.
template <class Enter, class Visit>
void TriangleTree::walk(const Enter& enters, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::array<uint32_t, kDeepestStack> stack;
    stack[0] = 0;
    size_t size = 1;
    while (size > 0) {
        const Node& node = nodes_[stack[--size]];
        if (!enters(node.bounds)) continue;
        if (node.count == 0) {
            stack[size++] = node.first;
            stack[size++] = node.first + 1;
            continue;
        }
        for (uint32_t i = node.first; i < node.first + node.count; ++i)
            if (visit(triangles_[i])) return;
    }
}

std::optional<RayHit> TriangleTree::nearest(const Ray& ray) const {
    std::optional<RayHit> best;
    if (nodes_.empty()) return best;
    struct Entry {
        uint32_t node;
        double distance_m;
    };
    const Slabs slabs(ray);
    double reach_m = ray.reach_m;
    std::array<Entry, kDeepestStack> stack;
    stack[0] = {0, slabs.enter(nodes_[0].bounds)};
    for (size_t size = 1; size > 0;) {
        const Entry entry = stack[--size];
        if (!(entry.distance_m <= reach_m)) continue;
        const Node& node = nodes_[entry.node];
        if (node.count == 0) {
            Entry near{node.first, slabs.enter(nodes_[node.first].bounds)};
            Entry far{node.first + 1, slabs.enter(nodes_[node.first + 1].bounds)};
            if (far.distance_m < near.distance_m) std::swap(near, far);
            if (far.distance_m <= reach_m) stack[size++] = far;
            if (near.distance_m <= reach_m) stack[size++] = near;
            continue;
        }
        for (uint32_t i = node.first; i < node.first + node.count; ++i) {
            if (!triangles_[i].blocks) continue;
            const std::optional<RayHit> hit = hit_triangle(triangles_[i], ray);
            if (!hit || hit->distance_m > reach_m) continue;
            if (!best || hit->distance_m < best->distance_m) {
                best = hit;
            } else {
                best->is_inside = best->is_inside && hit->is_inside;
                best->is_back = best->is_back && hit->is_back;
            }
            reach_m = best->distance_m;
        }
    }
    return best;
}

bool TriangleTree::is_blocked(const Ray& ray) const {
    const Slabs slabs(ray);
    bool found = false;
    walk([&](const Bounds& node) { return slabs.enter(node) <= ray.reach_m; },
         [&](const SolidTriangle& triangle) {
             return found = triangle.blocks && hit_triangle(triangle, ray).has_value();
         });
    return found;
}

int TriangleTree::depth_along(const Ray& ray) const {
    const Slabs slabs(ray);
    int depth = 0;
    walk([&](const Bounds& node) { return slabs.enter(node) <= ray.reach_m; },
         [&](const SolidTriangle& triangle) {
             const std::optional<RayHit> hit =
                 triangle.has_inside ? hit_triangle(triangle, ray) : std::nullopt;
             if (hit) depth += hit->is_inside ? 1 : -1;
             return false;
         });
    return depth;
}

bool TriangleTree::touches(const Bounds& box) const {
    bool found = false;
    walk([&](const Bounds& node) { return overlap(node, box); },
         [&](const SolidTriangle& triangle) { return found = found || touches_box(triangle, box); });
    return found;
}

bool TriangleTree::touches_front(const Bounds& box, float reach_m) const {
    bool found = false;
    // Returns true if the triangle, moved by `way`, touches the box. Moving the box by -way gives the same
    // result.
    const auto touches_moved = [&](const SolidTriangle& triangle, const glm::vec3& way) {
        return touches_box(triangle, {box.min - way, box.max - way});
    };
    const auto touches_side = [&](const SolidTriangle& triangle, const glm::vec3& way) {
        return touches_moved(triangle, way * 0.5f) || touches_moved(triangle, way);
    };
    walk(
        [&](const Bounds& node) {
            return overlap(node, {box.min - reach_m, box.max + reach_m});
        },
        [&](const SolidTriangle& triangle) {
            const glm::vec3 way = glm::vec3(normal_of(triangle)) * reach_m;
            return found = found || touches_box(triangle, box) || touches_side(triangle, way) ||
                           (!triangle.has_inside && touches_side(triangle, -way));
        });
    return found;
}

void TriangleTree::visit(const Bounds& box, const std::function<void(const SolidTriangle&)>& visitor) const {
    walk([&](const Bounds& node) { return overlap(node, box); },
         [&](const SolidTriangle& triangle) {
             visitor(triangle);
             return false;
         });
}

bool TriangleTree::is_uneven(const Bounds& box) const {
    // Triangles count as parallel if none of the products of two coordinates of their normals (x², xy and so
    // on) differs by more than this between the triangles.
    constexpr double kPlainSpread = 0.35;
    // If a box has more triangles than this, the function returns true without further tests, as for surfaces
    // that are not parallel. This limits the time of a test.
    constexpr uint32_t kDetailed = 4096;
    // Compares products of two coordinates of the normals, because the two sides of a surface have opposite
    // normals, and these give the same products.
    glm::dvec3 low_squares(2), high_squares(-2), low_mixed(2), high_mixed(-2);
    bool uneven = false;
    uint32_t touching = 0;
    walk([&](const Bounds& node) { return overlap(node, box); },
         [&](const SolidTriangle& triangle) {
             if (!touches_box(triangle, box)) return false;
             const glm::dvec3 n = normal_of(triangle);
             if (n == glm::dvec3(0)) return false;
             const glm::dvec3 squares = n * n, mixed = n * glm::dvec3(n.y, n.z, n.x);
             low_squares = glm::min(low_squares, squares);
             high_squares = glm::max(high_squares, squares);
             low_mixed = glm::min(low_mixed, mixed);
             high_mixed = glm::max(high_mixed, mixed);
             const glm::dvec3 spread = glm::max(high_squares - low_squares, high_mixed - low_mixed);
             uneven = ++touching > kDetailed || std::max({spread.x, spread.y, spread.z}) > kPlainSpread;
             return uneven;
         });
    return uneven;
}

bool TriangleTree::is_near(const glm::vec3& point, float radius_m) const {
    const Bounds box{point - glm::vec3(radius_m), point + glm::vec3(radius_m)};
    const double most = double{radius_m} * radius_m;
    bool found = false;
    walk([&](const Bounds& node) { return overlap(node, box); },
         [&](const SolidTriangle& triangle) {
             return found = triangle.blocks && squared_distance(triangle, glm::dvec3(point)) < most;
         });
    return found;
}

}  // namespace weft::scene
