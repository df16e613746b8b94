// Tests the march of rays through the depth image: the pyramid only skips pixels in which a ray meets no
// surface, and a march that has not reached its end is no hit.
#include <cmath>

#include "tests/render/reflections/reflection_fixture.h"

namespace weft::test {
namespace {

class March : public ReflectionTest {
 protected:
    static constexpr Extent3D kMarchSize{240, 135, 1};
    // Returns the light of the rays of the second frame.
    std::vector<glm::vec4> rays(const scene::Scene& scene, double pyramid, double steps) {
        params_["ssrScale"] = 1;
        params_["ssrRoughest"] = 1;
        params_["ssrPyramid"] = pyramid;
        params_["ssrSteps"] = steps;
        const LastFrame last = draw(scene, scene.cameras.front(), kMarchSize, 2, {"ssrLight.layer(0)"});
        return last.images.at("ssrLight.layer(0)");
    }
    // Rays that hit the same pixel differ only by rounding.
    static bool is_same(const glm::vec4& a, const glm::vec4& b) {
        return glm::all(glm::lessThan(glm::abs(a - b), glm::max(a, b) * 0.02f + 1e-3f));
    }
};

TEST_F(March, HitsTheSamePixelsWithAndWithoutThePyramid) {
    const Result<scene::Scene> scene = scene::make_builtin("atrium");
    ASSERT_TRUE(scene);
    const std::vector<glm::vec4> skipping = rays(*scene, 1, 10000), exhaustive = rays(*scene, 0, 10000);
    ASSERT_EQ(skipping.size(), exhaustive.size());
    size_t hits = 0, same = 0;
    for (size_t i = 0; i < skipping.size(); ++i) {
        const bool hit = skipping[i].a > 0 || exhaustive[i].a > 0;
        hits += hit;
        same += hit && is_same(skipping[i], exhaustive[i]);
    }
    std::printf("%zu hits, %.4f of them the same\n", hits, double(same) / double(hits));
    EXPECT_GT(hits, size_t{6000});
    EXPECT_GE(double(same), 0.99 * double(hits));
}

TEST_F(March, HitsNothingIfTheStepsDoNotSuffice) {
    const Result<scene::Scene> scene = scene::make_builtin("mirror");
    ASSERT_TRUE(scene);
    const std::vector<glm::vec4> all = rays(*scene, 1, 10000), few = rays(*scene, 1, 12);
    size_t hits = 0, kept = 0, others = 0;
    for (size_t i = 0; i < all.size(); ++i) {
        hits += all[i].a > 0;
        kept += few[i].a > 0;
        others += few[i].a > 0 && std::abs(few[i].a - all[i].a) > 0.02f;
    }
    std::printf("%zu hits, with 12 steps %zu hits\n", hits, kept);
    EXPECT_LT(kept, hits / 2);
    EXPECT_EQ(others, 0u);
}

}  // namespace
}  // namespace weft::test
