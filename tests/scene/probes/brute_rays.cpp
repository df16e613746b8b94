#include "tests/scene/probes/brute_rays.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace weft::scene::test {

BruteRays::BruteRays(const Scene& scene) {
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        const bool mirrored = glm::determinant(glm::mat3(instance.transform)) < 0;
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            glm::vec3 p[3];
            for (size_t k = 0; k < 3; ++k)
                p[k] = glm::vec3(instance.transform * glm::vec4(mesh.positions[mesh.indices[i + k]], 1));
            const glm::vec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
            if (glm::length(normal) < 1e-9f) continue;
            triangles_.push_back({p[0], p[1], p[2], glm::normalize(normal) * (mirrored ? -1.0f : 1.0f)});
        }
    }
}

float BruteRays::distance(const Triangle& t, const glm::vec3& from, const glm::vec3& direction) {
    const float along = glm::dot(direction, t.normal);
    if (std::abs(along) < 1e-6f) return -1;
    const float distance = glm::dot(t.a - from, t.normal) / along;
    if (distance < 0) return -1;
    const glm::vec3 p = from + direction * distance;
    // The point is inside if it is on the same side of all edges.
    const float s = glm::dot(glm::cross(t.b - t.a, p - t.a), t.normal);
    const float u = glm::dot(glm::cross(t.c - t.b, p - t.b), t.normal);
    const float v = glm::dot(glm::cross(t.a - t.c, p - t.c), t.normal);
    const bool inside = (s >= 0 && u >= 0 && v >= 0) || (s <= 0 && u <= 0 && v <= 0);
    return inside ? distance : -1;
}

double BruteRays::back_share(const glm::vec3& point) const {
    constexpr int kRays = 64;
    std::mt19937 random(7);
    const auto coordinate = [&] { return static_cast<float>(random() % 20'001) / 10'000.0f - 1; };
    int back = 0;
    for (int ray = 0; ray < kRays;) {
        const glm::vec3 direction(coordinate(), coordinate(), coordinate());
        const float length = glm::length(direction);
        if (length < 0.1f || length > 1) continue;
        ++ray;
        float best = 1e30f;
        bool is_back = false;
        for (const Triangle& triangle : triangles_) {
            const float reached = distance(triangle, point, direction / length);
            if (reached < 0 || reached >= best) continue;
            best = reached;
            is_back = glm::dot(triangle.normal, direction) > 0;
        }
        back += is_back ? 1 : 0;
    }
    return static_cast<double>(back) / kRays;
}

bool BruteRays::sees(const glm::vec3& from, const glm::vec3& to) const {
    const float length = glm::distance(from, to);
    if (length < 1e-4f) return true;
    for (const Triangle& triangle : triangles_) {
        const float reached = distance(triangle, from, (to - from) / length);
        if (reached >= 0 && reached < length) return false;
    }
    return true;
}

std::vector<glm::vec3> BruteRays::points_before_surfaces(float distance_m, uint32_t per_triangle) const {
    std::mt19937 random(11);
    const auto fraction = [&] { return static_cast<float>(random() % 10'001) / 10'000.0f; };
    std::vector<glm::vec3> points;
    for (const Triangle& t : triangles_)
        for (uint32_t i = 0; i < per_triangle; ++i) {
            const float u = std::sqrt(fraction()), v = fraction();
            points.push_back(t.a * (1 - u) + t.b * (u * (1 - v)) + t.c * (u * v) + t.normal * distance_m);
        }
    return points;
}

std::vector<glm::vec3> BruteRays::random_points(uint32_t count, float distance_m, uint32_t seed) const {
    std::vector<double> sums;
    double area = 0;
    for (const Triangle& t : triangles_) {
        area += double{glm::length(glm::cross(t.b - t.a, t.c - t.a))};
        sums.push_back(area);
    }
    std::mt19937 random(seed);
    const auto fraction = [&] { return static_cast<float>(random() % 100'003) / 100'003.0f; };
    std::vector<glm::vec3> points;
    for (uint32_t i = 0; i < count; ++i) {
        const auto found = std::ranges::upper_bound(sums, double{fraction()} * area);
        const Triangle& t = triangles_[static_cast<size_t>(found - sums.begin())];
        const float u = std::sqrt(fraction()), v = fraction();
        points.push_back(t.a * (1 - u) + t.b * (u * (1 - v)) + t.c * (u * v) + t.normal * distance_m);
    }
    return points;
}

}  // namespace weft::scene::test
