// Purpose: casts rays against the triangles of a scene, for references that are independent of the tested
// code. It uses a tree of bounding boxes, split at the median triangle. Opaque surfaces stop a ray. Masked
// surfaces stop a ray where the alpha of the nearest texel of mip 0 is at least the cutoff. Transparent
// (blended) surfaces are left out.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::test {

struct RayHit {
    double distance_m = 0;
    // Unit normal of the triangle, on the side from which the ray comes.
    glm::dvec3 normal{0};
    uint32_t material = 0;
};

// How rays treat masked surfaces: as they are drawn, as if they were opaque, or as if they were absent.
enum class Masks : uint8_t { as_drawn, solid, absent };

class RayScene {
 public:
    explicit RayScene(const scene::Scene& scene) : scene_(scene) {
        for (const scene::Instance& instance : scene.instances)
            if (scene.materials[instance.material].alpha_mode != scene::AlphaMode::blend) add(instance);
        order_.resize(triangles_.size());
        std::iota(order_.begin(), order_.end(), 0u);
        split(0, static_cast<uint32_t>(order_.size()));
    }

    // Returns the nearest hit at a distance of more than `from_m` metres. `direction` must have unit length.
    [[nodiscard]] std::optional<RayHit> first(const glm::dvec3& origin, const glm::dvec3& direction,
                                              double from_m) const {
        return cast(origin, direction, from_m, Masks::as_drawn, false);
    }
    // Returns the distance of the nearest hit at more than `from_m` metres.
    [[nodiscard]] std::optional<double> first_distance(const glm::dvec3& origin, const glm::dvec3& direction,
                                                       double from_m, Masks masks) const {
        const std::optional<RayHit> hit = cast(origin, direction, from_m, masks, false);
        return hit ? std::optional(hit->distance_m) : std::nullopt;
    }
    [[nodiscard]] bool is_blocked(const glm::dvec3& origin, const glm::dvec3& direction, double from_m,
                                  Masks masks) const {
        return cast(origin, direction, from_m, masks, true).has_value();
    }

 private:
    struct Triangle {
        glm::dvec3 a, ab, ac;
        glm::vec2 uv[3];
        uint32_t material;
    };
    struct Node {
        glm::dvec3 least{std::numeric_limits<double>::infinity()},
            most{-std::numeric_limits<double>::infinity()};
        // A leaf has `count` triangles, from index `first` of order_. An inner node has count 0; its children
        // are the next node in nodes_ and the node `second`.
        uint32_t first = 0, count = 0;
        uint32_t second = 0;
    };

    void add(const scene::Instance& instance) {
        const scene::Mesh& mesh = scene_.meshes[instance.mesh];
        for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            std::array<glm::dvec3, 3> corners;
            Triangle triangle{};
            for (size_t k = 0; k < 3; ++k) {
                const uint32_t vertex = mesh.indices[i + k];
                corners[k] =
                    glm::dvec3(glm::dmat4(instance.transform) * glm::dvec4(mesh.positions[vertex], 1));
                triangle.uv[k] = mesh.uvs[vertex];
            }
            triangle.a = corners[0];
            triangle.ab = corners[1] - corners[0];
            triangle.ac = corners[2] - corners[0];
            triangle.material = instance.material;
            triangles_.push_back(triangle);
        }
    }

    [[nodiscard]] glm::dvec3 middle(uint32_t triangle) const {
        const Triangle& t = triangles_[triangle];
        return t.a + (t.ab + t.ac) / 3.0;
    }

    void split(uint32_t begin, uint32_t end) {
        const auto at = nodes_.size();
        nodes_.emplace_back();
        Node node;
        glm::dvec3 least(std::numeric_limits<double>::infinity()), most(-least);
        for (uint32_t i = begin; i < end; ++i) {
            const Triangle& t = triangles_[order_[i]];
            for (const glm::dvec3& corner : {t.a, t.a + t.ab, t.a + t.ac}) {
                node.least = glm::min(node.least, corner);
                node.most = glm::max(node.most, corner);
            }
            least = glm::min(least, middle(order_[i]));
            most = glm::max(most, middle(order_[i]));
        }
        const glm::dvec3 size = most - least;
        const int axis = size.x > size.y && size.x > size.z ? 0 : (size.y > size.z ? 1 : 2);
        if (end - begin <= 4 || size[axis] <= 0) {
            node.first = begin;
            node.count = end - begin;
            nodes_[at] = node;
            return;
        }
        const uint32_t half = begin + (end - begin) / 2;
        std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                         [&](uint32_t a, uint32_t b) { return middle(a)[axis] < middle(b)[axis]; });
        split(begin, half);
        node.second = static_cast<uint32_t>(nodes_.size());
        nodes_[at] = node;
        split(half, end);
    }

    [[nodiscard]] static bool meets(const Node& node, const glm::dvec3& origin, const glm::dvec3& inverse,
                                    double from_m, double to_m) {
        const glm::dvec3 a = (node.least - origin) * inverse, b = (node.most - origin) * inverse;
        const glm::dvec3 in = glm::min(a, b), out = glm::max(a, b);
        return std::max({in.x, in.y, in.z, from_m}) <= std::min({out.x, out.y, out.z, to_m});
    }

    [[nodiscard]] std::optional<RayHit> cast(const glm::dvec3& origin, const glm::dvec3& direction,
                                             double from_m, Masks masks, bool any) const {
        std::optional<RayHit> best;
        const glm::dvec3 inverse = 1.0 / direction;
        double to_m = std::numeric_limits<double>::infinity();
        for (std::vector<uint32_t> open{0}; !open.empty();) {
            const uint32_t at = open.back();
            open.pop_back();
            const Node& node = nodes_[at];
            if (!meets(node, origin, inverse, from_m, to_m)) continue;
            if (node.count == 0) {
                open.push_back(node.second);
                open.push_back(at + 1);
                continue;
            }
            for (uint32_t i = node.first; i < node.first + node.count; ++i) {
                const Triangle& t = triangles_[order_[i]];
                const std::optional<double> distance_m = hit(t, origin, direction, from_m, to_m, masks);
                if (!distance_m) continue;
                const glm::dvec3 normal = glm::normalize(glm::cross(t.ab, t.ac));
                best = RayHit{*distance_m, glm::dot(normal, direction) < 0 ? normal : -normal, t.material};
                to_m = *distance_m;
                if (any) return best;
            }
        }
        return best;
    }

    // Returns the distance at which a ray hits a triangle, if it does. Algorithm: Möller and Trumbore 1997,
    // "Fast, Minimum Storage Ray-Triangle Intersection".
    [[nodiscard]] std::optional<double> hit(const Triangle& t, const glm::dvec3& origin,
                                            const glm::dvec3& direction, double from_m, double to_m,
                                            Masks masks) const {
        const glm::dvec3 p = glm::cross(direction, t.ac);
        const double determinant = glm::dot(t.ab, p);
        if (determinant == 0) return std::nullopt;
        const glm::dvec3 from_a = origin - t.a, q = glm::cross(from_a, t.ab);
        const double u = glm::dot(from_a, p) / determinant, v = glm::dot(direction, q) / determinant;
        const double distance_m = glm::dot(t.ac, q) / determinant;
        if (u < 0 || v < 0 || u + v > 1 || distance_m <= from_m || distance_m >= to_m) return std::nullopt;
        if (is_hole(t, static_cast<float>(u), static_cast<float>(v), masks)) return std::nullopt;
        return distance_m;
    }

    [[nodiscard]] bool is_hole(const Triangle& t, float u, float v, Masks masks) const {
        const scene::Material& material = scene_.materials[t.material];
        if (material.alpha_mode != scene::AlphaMode::mask || masks == Masks::solid) return false;
        if (masks == Masks::absent) return true;
        float alpha = material.base_color.a;
        if (const scene::TextureSlot& slot = material.base_color_texture; slot.texture != scene::kNone) {
            const scene::Texture& texture = scene_.textures[slot.texture];
            const glm::vec2 at =
                slot.transform * glm::vec3(t.uv[0] * (1 - u - v) + t.uv[1] * u + t.uv[2] * v, 1);
            const auto texel = [](float x, uint32_t size) {
                return std::min(static_cast<uint32_t>((x - std::floor(x)) * static_cast<float>(size)),
                                size - 1);
            };
            const size_t i =
                size_t{texel(at.y, texture.height_px)} * texture.width_px + texel(at.x, texture.width_px);
            alpha *= static_cast<float>(texture.mips[0][i * 4 + 3]) / 255;
        }
        return alpha < material.alpha_cutoff;
    }

    const scene::Scene& scene_;
    std::vector<Triangle> triangles_;
    std::vector<uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace weft::test
