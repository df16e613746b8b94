// Tests the sub-pixel camera offsets (jitter), and their effect on the view constants for shaders.
#include "render/jitter.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/gtc/matrix_transform.hpp>

#include "render/frame_data.h"

namespace weft::render {
namespace {

TEST(Jitter, MirrorsTheDigits) {
    constexpr std::array<double, 8> kBase2{0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875, 0.0625};
    constexpr std::array<double, 8> kBase3{1.0 / 3, 2.0 / 3, 1.0 / 9, 4.0 / 9,
                                           7.0 / 9, 2.0 / 9, 5.0 / 9, 8.0 / 9};
    EXPECT_EQ(radical_inverse(0, 2), 0);
    for (uint32_t i = 0; i < 8; ++i) {
        EXPECT_DOUBLE_EQ(radical_inverse(i + 1, 2), kBase2[i]);
        EXPECT_DOUBLE_EQ(radical_inverse(i + 1, 3), kBase3[i]);
    }
}

TEST(Jitter, IsNoneUnlessAskedFor) {
    for (const uint32_t length : {0u, 1u})
        for (uint64_t frame = 0; frame < 4; ++frame) EXPECT_EQ(jitter_px(frame, length), glm::vec2(0));
}

TEST(Jitter, StartsOverIsDifferentInEachFrameAndOnAverageNothing) {
    for (uint32_t length = 2; length <= 64; ++length) {
        glm::dvec2 sum(0);
        for (uint32_t frame = 0; frame < length; ++frame) {
            const glm::vec2 offset = jitter_px(frame, length);
            EXPECT_EQ(offset, jitter_px(frame + 1000ull * length, length));
            EXPECT_LT(glm::max(std::abs(offset.x), std::abs(offset.y)), 0.6f) << "within about a pixel";
            for (uint32_t other = 0; other < frame; ++other) EXPECT_NE(offset, jitter_px(other, length));
            sum += glm::dvec2(offset);
        }
        EXPECT_NEAR(sum.x / length, 0, 1e-7);
        EXPECT_NEAR(sum.y / length, 0, 1e-7);
    }
}

glm::dvec2 pixel_of(const glm::mat4& view_projection, const glm::vec4& world, const glm::dvec2& size_px) {
    const glm::dvec4 clip = glm::dmat4(view_projection) * glm::dvec4(world);
    return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * size_px;
}

TEST(Jitter, MovesWhatIsSeenByItselfAtAllDistances) {
    scene::Camera camera;
    camera.transform = glm::inverse(glm::lookAt(glm::vec3(3, 2, 5), glm::vec3(0, 1, 0), glm::vec3(0, 1, 0)));
    const glm::vec2 offset(0.375f, -0.25f);
    const shared::ViewConstants still = view_constants(camera, glm::mat4(1), 640, 360);
    const shared::ViewConstants moved = view_constants(camera, glm::mat4(1), 640, 360, offset);
    EXPECT_EQ(still.jitter_uv, glm::vec2(0));
    EXPECT_EQ(still.view_projection, still.steady_view_projection);
    EXPECT_EQ(moved.steady_view_projection, still.view_projection) << "velocities compare these";
    for (const float away : {0.0f, 1.0f, 10.0f, 1000.0f}) {
        const glm::vec4 world(-0.5f * away, 1 - 0.1f * away, -away, 1);
        const glm::dvec2 from = pixel_of(still.view_projection, world, {640, 360});
        const glm::dvec2 to = pixel_of(moved.view_projection, world, {640, 360});
        EXPECT_NEAR(to.x - from.x, offset.x, 1e-3);
        EXPECT_NEAR(to.y - from.y, offset.y, 1e-3);
        const glm::vec4 clip = moved.view_projection * world;
        const glm::vec4 back = moved.inverse_view_projection * (clip / clip.w);
        EXPECT_NEAR(glm::distance(glm::vec3(back) / back.w, glm::vec3(world)) / (1 + away), 0, 1e-4);
    }
}

// The mean of n frames has √n samples along each axis, so textures become finer by ½ log2(n) mips, at most by 2.
TEST(Jitter, MakesTexturesFinerByTheNumberOfFrames) {
    for (const uint32_t length : {0u, 1u}) EXPECT_EQ(mip_bias(length), 0.0f);
    EXPECT_FLOAT_EQ(mip_bias(4), -1.0f);
    EXPECT_FLOAT_EQ(mip_bias(8), -1.5f);
    EXPECT_FLOAT_EQ(mip_bias(16), -2.0f);
    EXPECT_FLOAT_EQ(mip_bias(64), -2.0f);
}

}  // namespace
}  // namespace weft::render
