// Tests the frustum of a view against points: no point of a box that is left out may lie in the picture.
#include <gtest/gtest.h>

#include <random>

#include "render/frame_data.h"
#include "render/views/frustum.h"
#include "render/views/view_matrices.h"

namespace weft::render {
namespace {

class Frusta : public ::testing::Test {
 protected:
    float number(float least, float most) {
        return std::uniform_real_distribution<float>(least, most)(random_);
    }
    glm::vec3 point(float most) { return {number(-most, most), number(-most, most), number(-most, most)}; }
    // A random view: a camera, a face of a cube, or a parallel projection with a far plane.
    shared::ViewConstants view(int kind) {
        if (kind % 3 == 1)
            return constants_of(cube_face(point(5), static_cast<uint32_t>(kind) % kCubeFaces, 0.1));
        scene::Camera camera;
        const glm::vec3 back = glm::normalize(point(1) + glm::vec3(0.001f)),
                        side = glm::normalize(glm::cross({0.1f, 1, 0}, back));
        camera.transform = {glm::vec4(side, 0), glm::vec4(glm::cross(back, side), 0), glm::vec4(back, 0),
                            glm::vec4(point(5), 1)};
        camera.near_m = 0.2f;
        shared::ViewConstants made = view_constants(camera, glm::mat4(1), 64, 48, {0.3f, -0.2f});
        if (kind % 3 == 0) return made;
        glm::mat4 parallel(1);
        parallel[0][0] = 0.2f, parallel[1][1] = -0.3f, parallel[2][2] = 0.1f, parallel[3][2] = 1;
        return constants_of({made.view, parallel});
    }

    std::mt19937 random_{91};
};

TEST_F(Frusta, LeaveOutNoBoxWithAPointInThePicture) {
    int left_out = 0, kept = 0, kept_without_point = 0;
    for (int i = 0; i < 3000; ++i) {
        const shared::ViewConstants constants = view(i);
        const bool clamp = i % 4 == 0;
        const glm::vec3 center = point(12), half = glm::abs(point(i % 2 == 0 ? 3 : 0.3f));
        const bool outside = is_outside(frustum_of(constants), {center - half, center + half}, clamp);
        (outside ? left_out : kept) += 1;
        bool any = false;
        for (int k = 0; k < 200; ++k) {
            const glm::vec4 clip = constants.view_projection * glm::vec4(center + half * point(1), 1);
            const bool depth = clamp || (clip.z >= 0 && clip.z <= clip.w);
            any |= depth && clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
        }
        EXPECT_FALSE(any && outside) << i;
        kept_without_point += !any && !outside ? 1 : 0;
    }
    EXPECT_GT(left_out, 1200);
    EXPECT_GT(kept, 300);
    EXPECT_LT(kept_without_point, 700) << "the test should leave out most boxes that it can";
}

TEST_F(Frusta, HaveNoFarPlaneIfTheViewHasNone) {
    scene::Camera camera;
    const Frustum frustum = frustum_of(view_constants(camera, glm::mat4(1), 64, 64));
    const auto box = [](float z) { return scene::Bounds{{-1, -1, z - 1}, {1, 1, z + 1}}; };
    EXPECT_FALSE(is_outside(frustum, box(-1e9f), false));
    EXPECT_TRUE(is_outside(frustum, box(5), false)) << "behind the eye";
}

TEST_F(Frusta, KeepWhatTheDepthClampDraws) {
    glm::mat4 parallel(1);
    parallel[2][2] = 0.1f, parallel[3][2] = 1;
    const Frustum frustum = frustum_of(constants_of({glm::mat4(1), parallel}));
    const scene::Bounds before{{0, 0, 1}, {0.5f, 0.5f, 2}}, behind{{0, 0, -20}, {0.5f, 0.5f, -15}};
    for (const scene::Bounds& box : {before, behind}) {
        EXPECT_TRUE(is_outside(frustum, box, false));
        EXPECT_FALSE(is_outside(frustum, box, true));
    }
}

TEST_F(Frusta, BoxesContainTheTransformedPoints) {
    for (int i = 0; i < 300; ++i) {
        glm::mat4 to_world(1);
        for (int column = 0; column < 4; ++column)
            to_world[column] = glm::vec4(point(column < 3 ? 2 : 1000), column < 3 ? 0 : 1);
        const glm::vec3 center = point(4), half = glm::abs(point(2));
        const scene::Bounds box = box_in_world({center - half, center + half}, to_world);
        for (int k = 0; k < 20; ++k) {
            const glm::vec3 p(to_world * glm::vec4(center + half * point(1), 1));
            EXPECT_TRUE(glm::all(glm::lessThanEqual(box.min, p)) && glm::all(glm::lessThanEqual(p, box.max)));
        }
    }
}

}  // namespace
}  // namespace weft::render
