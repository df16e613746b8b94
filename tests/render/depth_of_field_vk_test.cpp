// Tests the depth-of-field passes of graphs/modules/depth_of_field.json on pictures with known depths: sharp objects do not leak
// into the background, and small bright lamps become uniform discs.
#include <algorithm>
#include <cmath>

#include "tests/render/effects_fixture.h"
#include "tests/render/shading/reference_brdf.h"

namespace weft::test {
namespace {

class DepthOfField : public ShippedEffects {
 protected:
    static constexpr Extent3D kSize{128, 64, 1};

    // Returns the test picture (pictures/halves.frag) after the depth-of-field passes. The right half of the
    // picture is at the distance `right_m`; the left half is in focus.
    Image through_lens(double right_m) {
        const Json picture{{"type", "fullscreen"},
                           {"shader", "halves.frag"},
                           {"out", {"hdr"}},
                           {"depth", "depth"},
                           {"params", {{"right_m", right_m}}},
                           {"state", {{"depth", "always_write"}}}};
        Json graph = behind_picture("depth_of_field", picture, {"part", "reach", "blur", "lens"},
                                    {"behind", "before", "hidden", "soft", "circles", "reach"});
        graph["params"]["aperture"]["default"] = 2;
        return this->picture(graph, kSize, {"hdr"})["hdr"];
    }
    static const glm::vec4& at(const Image& image, uint32_t x, uint32_t y) {
        return image[size_t{y} * kSize.width + x];
    }
    // Returns the difference between the largest and the smallest blue value in rows 24 to 39 of column x.
    // The difference is 0 where the blur has merged the blue and green stripes to one colour.
    static float contrast(const Image& image, uint32_t x) {
        float low = 100, high = 0;
        for (uint32_t y = 24; y < 40; ++y) {
            low = std::min(low, at(image, x, y).b);
            high = std::max(high, at(image, x, y).b);
        }
        return high - low;
    }
};

TEST_F(DepthOfField, WhatIsSharpLeaksIntoNothingBehindIt) {
    const Image image = through_lens(1000);
    ASSERT_EQ(image.size(), size_t{kSize.width} * kSize.height);
    for (uint32_t y = 0; y < kSize.height; ++y) {
        for (uint32_t x = 0; x < kSize.width / 2; ++x)
            ASSERT_EQ(glm::vec3(at(image, x, y)), glm::vec3(100, 0, 0))
                << x << ", " << y << ": what is sharp stays";
        for (uint32_t x = kSize.width / 2; x < kSize.width; ++x) {
            ASSERT_EQ(at(image, x, y).r, 0) << x << ", " << y << ": red leaks";
            ASSERT_GT(at(image, x, y).g + at(image, x, y).b, 0.9f) << x << ", " << y << ": a dark fringe";
        }
    }
    EXPECT_LT(contrast(image, 100), 0.3f) << "blurred";
}

TEST_F(DepthOfField, WhatIsBlurredBeforeTheFocusSpreadsAndLetsThroughAtItsBorderOnly) {
    const Image image = through_lens(3);
    ASSERT_EQ(image.size(), size_t{kSize.width} * kSize.height);
    // Largest radius of blur in pixels (24), plus 4 pixels for the error of blurring at half resolution.
    constexpr uint32_t kWidestCircle = 24 + 4;
    for (uint32_t y = 0; y < kSize.height; ++y)
        for (uint32_t x = kSize.width / 2 + kWidestCircle; x < kSize.width; ++x)
            ASSERT_EQ(at(image, x, y).r, 0) << x << ", " << y;
    EXPECT_EQ(glm::vec3(at(image, 8, 32)), glm::vec3(100, 0, 0)) << "out of its reach";
    const glm::vec4& beside = at(image, kSize.width / 2 - 2, 32);
    EXPECT_LT(beside.r, 90);
    EXPECT_GT(beside.g + beside.b, 0.05f) << "it covers a part of what is sharp";
    EXPECT_LT(contrast(image, 100), 0.3f) << "blurred";
}

// Computes exactly what the depth-of-field passes approximate: for each pixel it gathers the light of all
// pixels around it, at full resolution and in double precision. Valid only if all objects in the foreground
// hide the same plain colour.
class LampReference {
 public:
    LampReference(const Image& color, const Image& depth, Extent3D size, const shared::ViewConstants& view,
                  double focus_m, double aperture_m)
        : color_(color), size_(size) {
        const double pixels_per_rad = 0.5 * size.height * std::abs(view.projection[1][1]);
        for (const glm::vec4& texel : depth) {
            const double diameter_rad = aperture_m * (1 / focus_m - double{texel.r} / view.near_m);
            radius_px_.push_back(std::clamp(0.5 * pixels_per_rad * diameter_rad, -24.0, 24.0));
        }
    }

    glm::dvec3 at(int x, int y) const {
        const double own_px = radius_px_[index(x, y)];
        const glm::dvec4 far = gathered(x, y, std::max(own_px, 1.0), 1), close = gathered(x, y, 24, -1);
        const glm::dvec3 sharp(color_[index(x, y)]), lit = far.a > 0 ? glm::dvec3(far) / far.a : sharp;
        const glm::dvec3 below = glm::mix(sharp, lit, blurred(own_px));
        const double covered = std::min(close.a, 1.0);
        const glm::dvec3 front = close.a > 1 ? glm::dvec3(close) / close.a : glm::dvec3(close);
        // A blurred pixel in the foreground is partly transparent and reveals the colour behind it.
        return front + (own_px < 0 ? glm::mix(sharp, hidden_, blurred(-own_px)) : below) * (1 - covered);
    }
    void set_hidden(const glm::dvec3& color) { hidden_ = color; }

 private:
    size_t index(int x, int y) const {
        const auto column = static_cast<size_t>(std::clamp(x, 0, static_cast<int>(size_.width) - 1));
        return static_cast<size_t>(std::clamp(y, 0, static_cast<int>(size_.height) - 1)) * size_.width +
               column;
    }
    static double blurred(double radius_px) {
        const double t = std::clamp((radius_px / 2 - 0.25) / 0.6, 0.0, 1.0);
        return t * t * (3 - 2 * t);
    }
    // Gathers the light of the pixels behind the focus (side 1) or in front of it (side -1), at most
    // `reach_px` away. Returns their premultiplied colour. Alpha is the sum of the shares of their light that
    // fall on pixel (x, y), and may exceed 1.
    glm::dvec4 gathered(int x, int y, double reach_px, double side) const {
        const int reach = static_cast<int>(std::ceil(reach_px));
        glm::dvec4 sum(0);
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx) {
                const size_t from = index(x + dx, y + dy);
                const double wide_px = std::max(radius_px_[from] * side, 1.0), far_px = std::hypot(dx, dy);
                if (far_px > reach_px) continue;
                const double share = std::clamp(wide_px - far_px + 0.5, 0.0, 1.0) / (kPi * wide_px * wide_px);
                sum += glm::dvec4(glm::dvec3(color_[from]), 1) * (share * blurred(radius_px_[from] * side));
            }
        return sum;
    }

    const Image& color_;
    Extent3D size_;
    // Radius of each pixel's circle of confusion, in pixels of the full resolution.
    std::vector<double> radius_px_;
    glm::dvec3 hidden_{0};
};

// The largest relative differences of all compared pixels. `above`: a pixel is larger than the maximum of the
// nearby reference values. `below`: a pixel is smaller than their minimum.
struct Overshoot {
    double above = 0, below = 0;
};

class Lamps : public ShippedEffects {
 protected:
    static constexpr Extent3D kSize{128, 96, 1};

    Overshoot measure(double lamp_m, double wall_m) {
        const Json picture{{"type", "fullscreen"},
                           {"shader", "lamps.frag"},
                           {"out", {"hdr"}},
                           {"depth", "depth"},
                           {"params", {{"lamp_m", lamp_m}, {"wall_m", wall_m}}},
                           {"state", {{"depth", "always_write"}}}};
        Json graph = behind_picture("depth_of_field", picture, {"part", "reach", "blur", "lens"},
                                    {"behind", "before", "hidden", "soft", "circles", "reach"});
        graph["params"]["aperture"]["default"] = 2;
        const auto seen = this->picture(graph, kSize, {"hdr", "hdr@glass", "depth"});
        if (seen.size() != 3) return {1e9, 1e9};
        LampReference reference(seen.at("hdr@glass"), seen.at("depth"), kSize, view_,
                                graph["params"]["focus"]["default"].get<double>(), 2);
        reference.set_hidden({0.1, 0.1, 0.1});
        return compare(seen.at("hdr"), reference);
    }

 private:
    // Blurring at half resolution and the upsampling filter may move light by this many pixels, so a pixel is
    // compared with all reference values within this distance.
    static constexpr int kNear = 5;

    static Overshoot compare(const Image& image, const LampReference& reference) {
        const int width = kSize.width, height = kSize.height;
        std::vector<double> wanted;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) wanted.push_back(reference.at(x, y).g);
        Overshoot worst;
        for (int y = kNear; y < height - kNear; ++y)
            for (int x = kNear; x < width - kNear; ++x) {
                double low = 1e9, high = 0;
                for (int dy = -kNear; dy <= kNear; ++dy)
                    for (int dx = -kNear; dx <= kNear; ++dx) {
                        const double value = wanted[static_cast<size_t>((y + dy) * width + x + dx)];
                        low = std::min(low, value), high = std::max(high, value);
                    }
                const double found = image[static_cast<size_t>(y * width + x)].g;
                worst.above = std::max(worst.above, found / high - 1);
                worst.below = std::max(worst.below, 1 - found / low);
            }
        return worst;
    }
};

TEST_F(Lamps, BecomeEvenDiscsWithoutSparks) {
    struct View {
        const char* name;
        double lamp_m, wall_m;
    };
    for (const View& view :
         {View{"behind the focus, before the sky", 13, 1e6}, View{"hardly blurred, before the sky", 9.3, 1e6},
          View{"before a wall of nearly their own distance", 20, 24}, View{"before the focus", 6, 9}}) {
        SCOPED_TRACE(view.name);
        const Overshoot worst = measure(view.lamp_m, view.wall_m);
        std::printf("%s: %.0f %% above and %.0f %% below the reference nearby\n", view.name,
                    worst.above * 100, worst.below * 100);
        EXPECT_LT(worst.above, 0.25);
        EXPECT_LT(worst.below, 0.25);
    }
}

}  // namespace
}  // namespace weft::test
