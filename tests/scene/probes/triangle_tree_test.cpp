// Purpose: tests the tree of triangles against asking every triangle, for any order of the triangles.
#include "scene/probes/triangle_tree.h"

#include <gtest/gtest.h>

#include <random>

#include "scene/probes/triangle_tests.h"

namespace weft::scene::test {
namespace {

class Numbers {
 public:
    explicit Numbers(uint32_t seed) : random_(seed) {}
    float between(float low, float high) {
        return low + (high - low) * static_cast<float>(random_() % 100'003) / 100'003.0f;
    }
    glm::vec3 point(float extent) {
        return {between(-extent, extent), between(-extent, extent), between(-extent, extent)};
    }
    std::mt19937& engine() { return random_; }

 private:
    std::mt19937 random_;
};

// Small and large triangles; some are twice in the list.
std::vector<SolidTriangle> random_triangles(Numbers& numbers, size_t count) {
    std::vector<SolidTriangle> triangles;
    while (triangles.size() < count) {
        const glm::vec3 middle = numbers.point(10);
        const float size = triangles.size() % 17 == 0 ? 15.0f : 0.7f;
        triangles.push_back({{middle, middle + numbers.point(size), middle + numbers.point(size)},
                             triangles.size() % 5 != 0,
                             triangles.size() % 3 != 0});
        if (triangles.size() % 11 == 0) triangles.push_back(triangles.back());
    }
    return triangles;
}

std::optional<RayHit> nearest_of_all(const std::vector<SolidTriangle>& triangles, const Ray& ray) {
    std::optional<RayHit> best;
    for (const SolidTriangle& triangle : triangles) {
        const std::optional<RayHit> hit = triangle.blocks ? hit_triangle(triangle, ray) : std::nullopt;
        if (hit && (!best || hit->distance_m < best->distance_m)) best = hit;
    }
    return best;
}

TEST(TriangleTreeTest, AnswersAreThoseOfAllTriangles) {
    Numbers numbers(3);
    const std::vector<SolidTriangle> triangles = random_triangles(numbers, 400);
    const TriangleTree tree(triangles, {});
    uint32_t hits = 0, touching = 0, near = 0;
    for (int i = 0; i < 400; ++i) {
        const glm::dvec3 direction = glm::normalize(glm::dvec3(numbers.point(1)) + glm::dvec3(1e-4));
        const Ray ray{glm::dvec3(numbers.point(12)), direction, i % 4 == 0 ? 5.0 : 1e30};
        const std::optional<RayHit> expected = nearest_of_all(triangles, ray), found = tree.nearest(ray);
        ASSERT_EQ(found.has_value(), expected.has_value()) << i;
        if (found) {
            EXPECT_EQ(found->distance_m, expected->distance_m);
        }
        hits += found ? 1 : 0;
        int depth = 0;
        for (const SolidTriangle& triangle : triangles)
            if (const auto hit = hit_triangle(triangle, ray); hit && triangle.has_inside)
                depth += hit->is_inside ? 1 : -1;
        EXPECT_EQ(tree.depth_along(ray), depth);
        const glm::vec3 corner = numbers.point(10);
        const Bounds box{corner, corner + glm::abs(numbers.point(1.5f))};
        const bool touches =
            std::ranges::any_of(triangles, [&](const SolidTriangle& t) { return touches_box(t, box); });
        EXPECT_EQ(tree.touches(box), touches);
        touching += touches ? 1 : 0;
        const bool is_near = std::ranges::any_of(triangles, [&](const SolidTriangle& t) {
            return t.blocks && squared_distance(t, corner) < 0.25;
        });
        EXPECT_EQ(tree.is_near(corner, 0.5f), is_near);
        near += is_near ? 1 : 0;
    }
    for (const uint32_t count : {hits, touching, near}) {
        EXPECT_GT(count, 40u);
        EXPECT_LT(count, 390u);
    }
}

TEST(TriangleTreeTest, OfCoincidentSurfacesTheFrontCounts) {
    const SolidTriangle front{{glm::vec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}}, true, true};
    SolidTriangle back = front;
    std::swap(back.corners[1], back.corners[2]);
    const Ray ray{{0.2, 0.2, 3}, {0, 0, -1}};
    for (const std::vector<SolidTriangle>& list : {std::vector{front, back}, std::vector{back, front}}) {
        const std::optional<RayHit> hit = TriangleTree(list, {}).nearest(ray);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->distance_m, 3);
        EXPECT_FALSE(hit->is_inside);
    }
    EXPECT_TRUE(TriangleTree({back}, {}).nearest(ray)->is_inside);
}

// Rays that touch the edge of a flat triangle, and boxes that end at its plane, are not lost.
TEST(TriangleTreeTest, FlatBoxesAreFound) {
    const SolidTriangle wall{{glm::vec3(2, -1, -1), {2, 3, -1}, {2, -1, 3}}, true, true};
    const TriangleTree tree({wall}, {});
    EXPECT_TRUE(tree.nearest({{0, -1, 0}, {1, 0, 0}}));
    EXPECT_TRUE(tree.nearest({{0, 0, 0}, {1, 0, 0}}));
    EXPECT_FALSE(tree.nearest({{2, 0, -5}, {0, 0, 1}}));
    EXPECT_TRUE(tree.touches({{1, 0, 0}, {2, 1, 1}}));
    EXPECT_FALSE(tree.touches({{1, 0, 0}, {1.99f, 1, 1}}));
    EXPECT_TRUE(tree.is_near({1.6f, 0, 0}, 0.45f));
    EXPECT_FALSE(tree.is_near({1.6f, 0, 0}, 0.35f));
}

TEST(TriangleTreeTest, ParallelSurfacesAreEven) {
    const auto quad = [](float y, float slope) {
        return SolidTriangle{{glm::vec3(-1, y, -1), {0, y, 2}, {2, y + slope, -1}}, true, true};
    };
    SolidTriangle below = quad(-0.1f, 0);
    std::swap(below.corners[0], below.corners[1]);
    const Bounds box{glm::vec3(-2), glm::vec3(2)};
    EXPECT_FALSE(TriangleTree({quad(0, 0), below}, {}).is_uneven(box));
    EXPECT_FALSE(TriangleTree({quad(0, 0), quad(0.5f, 0.2f)}, {}).is_uneven(box));
    EXPECT_TRUE(TriangleTree({quad(0, 0), quad(0.5f, 3)}, {}).is_uneven(box));
    EXPECT_FALSE(TriangleTree({quad(0, 0), quad(0.5f, 3)}, {})
                     .is_uneven({glm::vec3(-2, -1, -2), glm::vec3(2, 0.2f, 2)}));
    EXPECT_TRUE(TriangleTree(std::vector<SolidTriangle>(5000, quad(0, 0)), {}).is_uneven(box));
}

TEST(TriangleTreeTest, ManyEqualTrianglesMakeATree) {
    const SolidTriangle one{{glm::vec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}}, true, true};
    const TriangleTree tree(std::vector<SolidTriangle>(100'000, one), {});
    EXPECT_TRUE(tree.nearest({{0.2, 0.2, 3}, {0, 0, -1}}));
    EXPECT_FALSE(tree.nearest({{0.9, 0.9, 3}, {0, 0, -1}}));
}

}  // namespace
}  // namespace weft::scene::test
