// Tests the module fxaa.json: edges of all directions come closer to the picture with the exact coverage of
// each pixel, and pictures without edges do not change.
#include <algorithm>
#include <random>

#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr const char* kEdges = WEFT_SOURCE_DIR "/tests/render/fxaa/edges.json";
constexpr int kSide = 64;
constexpr double kDark = 0.2, kBright = 0.9;

class Fxaa : public SessionTest {
 protected:
    // The red channel of the picture with the given parameters, from 0 to 1.
    std::vector<double> picture(const render::ParameterValues& parameters) {
        if (!session_) {
            session_ = start(kEdges, {kSide, kSide, 1});
            if (!session_) return {};
        }
        frame_of(*session_).parameters = parameters;
        EXPECT_TRUE(draw_frame(*session_));
        std::vector<double> red;
        EXPECT_TRUE(session_->finish());
        const Result<vk::ReadbackData> output = session_->read_output();
        EXPECT_TRUE(output) << to_text(output.errors());
        if (!output) return {};
        const std::vector<std::byte>& bytes = output->bytes;
        for (size_t i = 0; i < bytes.size(); i += 4) red.push_back(std::to_integer<int>(bytes[i]) / 255.0);
        EXPECT_EQ(red.size(), size_t{kSide} * kSide);
        return red;
    }

    std::unique_ptr<render::Session> session_;
};

double half_plane(double x, double y, double slope, double offset) {
    return y - kSide / 2 > slope * (x - kSide / 2) + offset ? 1 : 0;
}

// The mean square of the differences from the exact coverage, with and without anti-aliasing. Pixels near the
// sides of the picture do not count, because the edge ends there.
struct Errors {
    double with = 0, without = 0;
};
Errors errors_of(const std::vector<double>& picture, double slope, double offset) {
    constexpr int kSamples = 16, kMargin = 12;
    Errors errors;
    for (int y = kMargin; y < kSide - kMargin; ++y)
        for (int x = kMargin; x < kSide - kMargin; ++x) {
            double coverage = 0;
            for (int i = 0; i < kSamples * kSamples; ++i)
                coverage += half_plane(x + (i % kSamples + 0.5) / kSamples,
                                       y + (i / kSamples + 0.5) / kSamples, slope, offset);
            const double exact = kDark + (kBright - kDark) * coverage / (kSamples * kSamples);
            const double aliased = kDark + (kBright - kDark) * half_plane(x + 0.5, y + 0.5, slope, offset);
            errors.with += std::pow(picture[size_t(y) * kSide + size_t(x)] - exact, 2);
            errors.without += std::pow(aliased - exact, 2);
        }
    return errors;
}

TEST_F(Fxaa, EdgesComeCloserToTheExactCoverage) {
    std::mt19937 random(20261128);
    std::uniform_real_distribution<double> angle(-1.3, 1.3), offset(-4, 4);
    std::vector<double> shares;
    for (int i = 0; i < 48; ++i) {
        const double slope = std::tan(angle(random)), away = offset(random);
        const std::vector<double> seen = picture({{"slope", slope}, {"offset", away}});
        ASSERT_FALSE(seen.empty());
        const Errors errors = errors_of(seen, slope, away);
        if (errors.without < 1e-3) continue;
        shares.push_back(errors.with / errors.without);
    }
    std::ranges::sort(shares);
    std::printf(
        "square of the error at edges, as a share of that without FXAA: median %.3f, worst %.3f of %zu\n",
        shares[shares.size() / 2], shares.back(), shares.size());
    EXPECT_GE(shares.size(), 40u);
    EXPECT_LE(shares[shares.size() / 2], 0.35);
    EXPECT_LE(shares.back(), 0.8);
}

TEST_F(Fxaa, StraightEdgesAndGradientsStayAsTheyAre) {
    const std::vector<double> edge = picture({{"slope", 0}, {"offset", 0}});
    ASSERT_FALSE(edge.empty());
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            EXPECT_NEAR(edge[size_t(y) * kSide + size_t(x)], y < kSide / 2 ? kDark : kBright, 0.05)
                << x << " " << y;
    const std::vector<double> gradient = picture({{"gradient", 1}});
    for (int i = 0; i < kSide * kSide; ++i)
        EXPECT_NEAR(gradient[size_t(i)], (i % kSide + 0.5) / kSide, 0.003) << i;
}

}  // namespace
}  // namespace weft::test
