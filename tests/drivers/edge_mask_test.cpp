// Tests the comparison of pictures from two drivers. `edge_share` must tolerate an edge that moves by one
// texel, but not by two. `off_edges_steps` must ignore texels near edges. `mean_flip` counts every
// difference.
#include "tests/drivers/edge_mask.h"

#include <gtest/gtest.h>

namespace weft::test {
namespace {

// Returns a picture that is dark in the columns left of `edge_px`, and bright from column `edge_px` on.
image::Image two_halves(uint32_t edge_px) {
    image::Image picture{64, 64, image::Encoding::display, {}};
    for (uint32_t i = 0; i < 64 * 64; ++i) picture.texels.emplace_back(i % 64 < edge_px ? 0.2f : 0.8f);
    return picture;
}

TEST(EdgeMask, SamePicturesDoNotDiffer) {
    const DriverDifference same = compare_drivers(two_halves(32), two_halves(32));
    EXPECT_EQ(same.off_edges_steps, 0);
    EXPECT_EQ(same.edge_share, 0);
    EXPECT_EQ(same.mean_flip, 0);
    EXPECT_TRUE(is_within_bounds(same));
}

TEST(EdgeMask, RoundingCountsOffEdgesOnly) {
    image::Image test = two_halves(32);
    for (glm::vec3& texel : test.texels) texel += 2 / 255.0f;
    const DriverDifference rounding = compare_drivers(two_halves(32), test);
    EXPECT_NEAR(rounding.off_edges_steps, 2, 0.01);
    EXPECT_EQ(rounding.edge_share, 0);
    EXPECT_TRUE(is_same_off_edges(rounding));
    EXPECT_FALSE(is_within_bounds(rounding)) << "in the whole picture: FLIP sees it";
}

TEST(EdgeMask, ASpotInAFlatPartIsAForeignTexelAtAnEdgeOfItsOwn) {
    image::Image test = two_halves(32);
    test.texels[10 * 64 + 10] = glm::vec3(1.0f);
    const DriverDifference spot = compare_drivers(two_halves(32), test);
    EXPECT_EQ(spot.off_edges_steps, 0);
    EXPECT_DOUBLE_EQ(spot.edge_share, 1.0 / (64 * 64));
    EXPECT_GT(spot.mean_flip, 0);
}

TEST(EdgeMask, AShadeTooDarkIsSeenOffEdges) {
    image::Image test = two_halves(32);
    for (size_t y = 0; y < 64; ++y)
        for (size_t x = 0; x < 20; ++x) test.texels[y * 64 + x] -= 3 / 255.0f;
    const DriverDifference shade = compare_drivers(two_halves(32), test);
    EXPECT_NEAR(shade.off_edges_steps, 3, 0.01);
    EXPECT_FALSE(is_same_off_edges(shade));
    EXPECT_GT(shade.edge_share, 0.2);
    EXPECT_GT(shade.mean_flip, 0);
}

TEST(EdgeMask, AnEdgeMayMoveByOneTexelAndNotByTwo) {
    EXPECT_EQ(compare_drivers(two_halves(32), two_halves(33)).edge_share, 0);
    EXPECT_GT(compare_drivers(two_halves(32), two_halves(33)).mean_flip, 0.005)
        << "all along it: FLIP sees it";
    EXPECT_GT(compare_drivers(two_halves(32), two_halves(34)).edge_share, 0.01);
}

}  // namespace
}  // namespace weft::test
