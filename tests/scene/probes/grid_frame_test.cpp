// Tests the frame of the grid of probes: its angle and its origin for small buildings.
#include "scene/probes/grid_frame.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/scene/probes/probe_scenes.h"

namespace weft::scene::test {
namespace {

constexpr double kSpacing_m = 0.5;

// A room of 4 m × 2.4 m × 3 m with walls of 0.2 m. Its inner walls have the phases 0.1 m, 0.3 m and 0.2 m.
BoxScene room() {
    BoxScene scene;
    scene.add_room({1.1f, 0.3f, -2.3f}, {5.1f, 2.7f, 0.7f}, 0.2f);
    return scene;
}

std::vector<SolidTriangle> triangles_of(const BoxScene& boxes, const glm::mat4& motion = glm::mat4(1)) {
    Scene scene = boxes.scene;
    for (Instance& instance : scene.instances) instance.transform = motion * instance.transform;
    return collect_triangles(scene, {});
}

TEST(GridFrame, HasThePhaseOfTheInnerWallsAndLiesOnTheFloor) {
    const GridFrame frame = grid_frame_of(triangles_of(room()), kSpacing_m);
    EXPECT_EQ(frame.yaw_deg, 0);
    EXPECT_LE(glm::distance(frame.origin, glm::vec3(3.1f, 0.3f, -0.8f)), 1e-5f);
}

TEST(GridFrame, TurnsWithTheWalls) {
    for (const float angle_deg : {12.5f, -44.0f, 30.0f}) {
        const glm::mat4 motion = glm::rotate(glm::mat4(1), glm::radians(angle_deg), glm::vec3(0, 1, 0));
        const GridFrame frame = grid_frame_of(triangles_of(room(), motion), kSpacing_m);
        EXPECT_NEAR(frame.yaw_deg, angle_deg, 1e-3f);
        EXPECT_LE(glm::distance(frame.origin, glm::vec3(motion * glm::vec4(3.1f, 0.3f, -0.8f, 1))), 1e-3f);
    }
}

TEST(GridFrame, WithoutWallsStandsStraight) {
    EXPECT_EQ(grid_frame_of(collect_triangles(terrain(16), {}), kSpacing_m).yaw_deg, 0);
    EXPECT_EQ(grid_frame_of({}, kSpacing_m).origin, glm::vec3(0));
}

TEST(GridFrame, TrianglesInItDoNotDependOnThePlaceOfTheScene) {
    std::vector<SolidTriangle> still = triangles_of(room());
    move_to_grid_frame(still, grid_frame_of(still, kSpacing_m));
    const glm::mat4 motion = glm::rotate(glm::translate(glm::mat4(1), glm::vec3(17.3f, -0.6f, 4.1f)),
                                         glm::radians(20.0f), glm::vec3(0, 1, 0));
    std::vector<SolidTriangle> moved = triangles_of(room(), motion);
    move_to_grid_frame(moved, grid_frame_of(moved, kSpacing_m));
    ASSERT_EQ(still.size(), moved.size());
    for (size_t i = 0; i < still.size(); ++i) EXPECT_EQ(still[i].corners, moved[i].corners);
}

TEST(GridFrame, PlacesComeBackFromIt) {
    const GridFrame frame{33, {1, 2, 3}};
    const glm::vec3 place(-4, 0.5f, 7);
    EXPECT_LE(glm::distance(to_world(frame, to_grid_frame(frame, place)), place), 1e-5f);
    EXPECT_LE(glm::distance(to_grid_frame(frame, frame.origin), glm::vec3(0)), 1e-6f);
}

}  // namespace
}  // namespace weft::scene::test
