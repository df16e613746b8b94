#include "render/views/surface_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>

namespace weft::render {
namespace {

// The largest number of boxes of a scene. If it has more triangles, several of them share a box.
constexpr size_t kMostBoxes = size_t{1} << 18;
// Bits of each coordinate of a Morton code.
constexpr uint32_t kMortonBits = 10;

constexpr scene::Bounds kEmptyBox{glm::vec3(std::numeric_limits<float>::max()),
                                  glm::vec3(std::numeric_limits<float>::lowest())};

void add_point(scene::Bounds& box, const glm::vec3& point) {
    box.min = glm::min(box.min, point);
    box.max = glm::max(box.max, point);
}

scene::Bounds joined(const scene::Bounds& a, const scene::Bounds& b) {
    return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

// Puts two zero bits between all bits of a number of kMortonBits bits.
uint32_t spread(uint32_t x) {
    x = (x | x << 16) & 0x030000ffu;
    x = (x | x << 8) & 0x0300f00fu;
    x = (x | x << 4) & 0x030c30c3u;
    return (x | x << 2) & 0x09249249u;
}

// Returns the indices of the points along a Morton curve, so that neighbours in the list are close together.
std::vector<uint32_t> morton_order(std::span<const glm::vec3> points) {
    scene::Bounds all = kEmptyBox;
    for (const glm::vec3& point : points) add_point(all, point);
    const glm::vec3 scale =
        glm::vec3((1 << kMortonBits) - 1) / glm::max(all.max - all.min, glm::vec3(1e-20f));
    std::vector<uint64_t> keys(points.size());
    for (size_t i = 0; i < points.size(); ++i) {
        const glm::uvec3 cell((points[i] - all.min) * scale);
        const uint32_t code = spread(cell.x) | spread(cell.y) << 1 | spread(cell.z) << 2;
        keys[i] = uint64_t{code} << 32 | i;
    }
    std::ranges::sort(keys);
    std::vector<uint32_t> order(points.size());
    std::ranges::transform(keys, order.begin(), [](uint64_t key) { return static_cast<uint32_t>(key); });
    return order;
}

// Returns a corner of a triangle. A wrong index in a mesh of the program gives the point 0.
glm::vec3 corner_of(const scene::Mesh& mesh, size_t triangle, size_t corner) {
    const uint32_t vertex = mesh.indices[3 * triangle + corner];
    return vertex < mesh.positions.size() ? mesh.positions[vertex] : glm::vec3(0);
}

// Returns the triangles of a mesh along a Morton curve. A triangle is the index of its first element in
// Mesh::indices, divided by 3.
std::vector<uint32_t> ordered_triangles(const scene::Mesh& mesh) {
    std::vector<glm::vec3> centers(mesh.indices.size() / 3);
    for (size_t i = 0; i < centers.size(); ++i)
        for (size_t corner = 0; corner < 3; ++corner) centers[i] += corner_of(mesh, i, corner) / 3.0f;
    return morton_order(centers);
}

struct StillInstances {
    std::vector<const scene::Instance*> instances;
    size_t triangles = 0;
};

StillInstances still_instances(const scene::Scene& scene) {
    StillInstances still;
    for (const scene::Instance& instance : scene.instances) {
        if (instance.node != scene::kNone) continue;
        if (scene.materials[instance.material].alpha_mode == scene::AlphaMode::blend) continue;
        still.instances.push_back(&instance);
        still.triangles += scene.meshes[instance.mesh].indices.size() / 3;
    }
    return still;
}

// Returns the distances at which a ray enters and leaves a box.
glm::vec2 span_in(const scene::Bounds& box, const glm::vec3& from, const glm::vec3& inverse) {
    const glm::vec3 a = (box.min - from) * inverse, b = (box.max - from) * inverse;
    const glm::vec3 in = glm::min(a, b), out = glm::max(a, b);
    return {std::max({in.x, in.y, in.z}), std::min({out.x, out.y, out.z})};
}

}  // namespace

SurfaceTree::SurfaceTree(std::vector<scene::Bounds> boxes) {
    if (boxes.empty()) return;
    leaves_ = std::bit_ceil(boxes.size());
    nodes_.assign(2 * leaves_ - 1, kEmptyBox);
    fill(0, boxes);
}

void SurfaceTree::fill(size_t node, std::span<scene::Bounds> boxes) {
    if (boxes.empty()) return;
    if (boxes.size() == 1 && node + 1 >= leaves_) {
        nodes_[node] = boxes.front();
        return;
    }
    scene::Bounds centers = kEmptyBox;
    for (const scene::Bounds& box : boxes) add_point(centers, box.min + box.max);
    const glm::vec3 size = centers.max - centers.min;
    const int axis = size.x > size.y && size.x > size.z ? 0 : (size.y > size.z ? 1 : 2);
    const size_t half = (boxes.size() + 1) / 2;
    const auto center = [&](const scene::Bounds& box) { return box.min[axis] + box.max[axis]; };
    std::ranges::nth_element(boxes, boxes.begin() + static_cast<std::ptrdiff_t>(half), {}, center);
    fill(2 * node + 1, boxes.first(half));
    fill(2 * node + 2, boxes.subspan(half));
    nodes_[node] = joined(nodes_[2 * node + 1], nodes_[2 * node + 2]);
}

std::optional<float> SurfaceTree::first_entry(const glm::vec3& from, const glm::vec3& direction,
                                              float to_m) const {
    if (empty()) return std::nullopt;
    // A component of 0 becomes very small, so that no product below is 0 times infinity.
    glm::vec3 inverse;
    for (int axis = 0; axis < 3; ++axis)
        inverse[axis] = 1 / (std::abs(direction[axis]) > 1e-12f ? direction[axis] : 1e-12f);
    float best_m = to_m;
    std::array<size_t, 64> open{};
    size_t count = 1;
    while (count > 0) {
        const size_t at = open[--count];
        const glm::vec2 span = span_in(nodes_[at], from, inverse);
        if (!(std::max(span.x, 0.0f) <= std::min(span.y, best_m))) continue;
        if (at + 1 >= leaves_) {
            if (span.x > 0) best_m = span.x;
            continue;
        }
        // The nearer child comes first, because its boxes may hide the other child.
        const size_t left = 2 * at + 1, right = left + 1;
        const bool swaps = span_in(nodes_[right], from, inverse).x < span_in(nodes_[left], from, inverse).x;
        open[count++] = swaps ? left : right;
        open[count++] = swaps ? right : left;
    }
    return best_m < to_m ? std::optional(best_m) : std::nullopt;
}

std::vector<scene::Bounds> still_surfaces(const scene::Scene& scene, bool moves_instances) {
    std::vector<scene::Bounds> boxes;
    if (moves_instances) return boxes;
    const StillInstances still = still_instances(scene);
    size_t run = 1;  // Number of triangles in a box.
    while (still.triangles / run > kMostBoxes) run *= 2;
    std::vector<std::vector<uint32_t>> orders(scene.meshes.size());
    for (const scene::Instance* instance : still.instances) {
        const scene::Mesh& mesh = scene.meshes[instance->mesh];
        std::vector<uint32_t>& order = orders[instance->mesh];
        if (order.empty()) order = ordered_triangles(mesh);
        for (size_t i = 0; i < order.size(); ++i) {
            if (i % run == 0) boxes.push_back(kEmptyBox);
            for (size_t corner = 0; corner < 3; ++corner) {
                const glm::vec3 position = corner_of(mesh, order[i], corner);
                add_point(boxes.back(), glm::vec3(instance->transform * glm::vec4(position, 1)));
            }
        }
    }
    return boxes;
}

}  // namespace weft::render
