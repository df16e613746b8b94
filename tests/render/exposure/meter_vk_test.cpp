// Tests the light meter of the automatic exposure: the mean EV between two ranks, against exact values and
// against sorted pixels, and pixels that it must not count.
#include <algorithm>
#include <cmath>

#include "tests/render/exposure/exposure_fixture.h"

namespace weft::test {
namespace {

class Meter : public ExposureTest {};

struct Mixture {
    double dark_share, dark, bright;
    // The mean EV of the ranks in [0.5, 0.95], [0.1, 0.9] and [0.8, 0.983].
    std::array<double, 3> expected_ev;
};

constexpr std::array<std::array<double, 2>, 3> kRanks{{{0.5, 0.95}, {0.1, 0.9}, {0.8, 0.983}}};

TEST_F(Meter, MeasuresMixturesOfTwoLuminances) {
    const std::array mixtures{Mixture{0.5, 0.1, 1000, {12.9658, 6.3219, 12.9658}},
                              Mixture{0.9, 0.1, 1000, {1.1545, -0.3219, 5.7047}},
                              Mixture{0.25, 10, 5000, {15.2877, 13.6066, 15.2877}},
                              Mixture{0.75, 100, 400, {10.5327, 10.0189, 11.6439}},
                              Mixture{0.98, 1, 4000, {3.0000, 3.0000, 3.1962}}};
    const std::unique_ptr<render::Session> session = start_meter();
    ASSERT_TRUE(session);
    double worst = 0;
    for (const Mixture& mixture : mixtures) {
        for (size_t i = 0; i < kRanks.size(); ++i) {
            const Adaptation state = after_frame(*session, {{"darkShare", mixture.dark_share},
                                                            {"dark", mixture.dark},
                                                            {"bright", mixture.bright},
                                                            {"meterFrom", kRanks[i][0]},
                                                            {"meterTo", kRanks[i][1]}});
            EXPECT_NEAR(state.metered_ev, mixture.expected_ev[i], kBound_ev)
                << mixture.dark_share << " of " << mixture.dark << ", ranks from " << kRanks[i][0];
            worst = std::max(worst, std::abs(state.metered_ev - mixture.expected_ev[i]));
        }
    }
    std::printf("mixtures: at most %.4f EV from the exact mean\n", worst);
}

// Returns the mean EV of the pixels between two ranks, by sorting all pixels.
double sorted_ev(const std::vector<glm::vec4>& hdr, float pre_exposure, std::array<double, 2> ranks) {
    std::vector<double> evs;
    for (const glm::vec4& texel : hdr)
        evs.push_back(std::log2(8 * (0.2126 * texel.r + 0.7152 * texel.g + 0.0722 * texel.b) / pre_exposure));
    std::ranges::sort(evs);
    const auto rank = [&](double share) { return share * static_cast<double>(evs.size()); };
    double sum = 0, weights = 0;
    for (size_t i = 0; i < evs.size(); ++i) {
        const double at = static_cast<double>(i);
        const double weight = std::max(0.0, std::min(at + 1, rank(ranks[1])) - std::max(at, rank(ranks[0])));
        sum += weight * evs[i];
        weights += weight;
    }
    return sum / weights;
}

TEST_F(Meter, AgreesWithSortedPixels) {
    const std::unique_ptr<render::Session> session = start_meter({"hdr", "adaptation"});
    ASSERT_TRUE(session);
    for (const double stops : {0.05, 3.0, 12.0}) {
        for (const std::array<double, 2>& ranks : kRanks) {
            frame_of(*session).parameters = {
                {"dark", 0.3}, {"stops", stops}, {"meterFrom", ranks[0]}, {"meterTo", ranks[1]}};
            ASSERT_TRUE(draw_frame(*session));
            ASSERT_TRUE(session->finish());
            const std::vector<vk::ReadbackData> readbacks = session->take_readbacks();
            const auto hdr = std::ranges::find(readbacks, "observe:hdr", &vk::ReadbackData::pass);
            ASSERT_NE(hdr, readbacks.end());
            const double expected =
                sorted_ev(render::decode_texels(hdr->format, hdr->bytes), session->pre_exposure(), ranks);
            EXPECT_NEAR(adaptation_of(readbacks).metered_ev, expected, kBound_ev) << stops << " stops";
        }
    }
}

TEST_F(Meter, IgnoresPixelsWithoutUsableLight) {
    const std::unique_ptr<render::Session> session = start_meter();
    ASSERT_TRUE(session);
    const Adaptation clean = after_frame(*session, {{"dark", 2}, {"stops", 8}});
    for (int spoil = 0; spoil <= 4; ++spoil) {
        const Adaptation one = after_frame(*session, {{"spoiled", 1}, {"spoil", spoil}});
        EXPECT_NEAR(one.metered_ev, clean.metered_ev, 1e-3) << "one pixel of kind " << spoil;
        EXPECT_EQ(one.adapted, 1);
    }
    // The values of the pixels do not depend on their place, so half of the picture has nearly the same mean.
    for (int spoil = 0; spoil <= 3; ++spoil) {
        const Adaptation half = after_frame(*session, {{"spoiled", 160 * 180}, {"spoil", spoil}});
        EXPECT_NEAR(half.metered_ev, clean.metered_ev, 0.05) << "half of the picture, kind " << spoil;
    }
    const Adaptation none = after_frame(*session, {{"spoiled", 320 * 180}, {"spoil", 0}}, 1);
    EXPECT_EQ(none.adapted_ev, after_frame(*session, {}, 1).adapted_ev)
        << "without light, nothing is adapted";
    EXPECT_NEAR(none.adapted_ev, clean.metered_ev, 0.05);
}

TEST_F(Meter, ExtremePicturesHaveFiniteExposures) {
    const std::unique_ptr<render::Session> session = start_meter();
    ASSERT_TRUE(session);
    for (const double gain : {1e-9, 1e-3, 1e6, 1e30}) {
        for (const double from : {0.0, 0.5, 1.0}) {
            const Adaptation state =
                after_frame(*session, {{"gain", gain}, {"meterFrom", from}, {"meterTo", 0.3}});
            EXPECT_TRUE(std::isfinite(state.exposure_ev) && std::isfinite(state.adapted_ev))
                << gain << ", " << from;
            EXPECT_LE(std::abs(state.adapted_ev), 22);
        }
    }
}

TEST_F(Meter, LimitsAndCompensationMoveTheExposure) {
    const std::unique_ptr<render::Session> session = start_meter();
    ASSERT_TRUE(session);
    const Adaptation day = after_frame(*session, {{"dark", 1000}, {"bright", 1000}});
    EXPECT_NEAR(day.adapted_ev, std::log2(8000.0), kBound_ev);
    // The metered luminance is shown as 0.25 before the tone curve.
    EXPECT_NEAR(std::exp2(day.exposure_ev + day.adapted_ev - 3), 0.25, 1e-5);
    EXPECT_NEAR(after_frame(*session, {{"compensation", 1.5}}).exposure_ev, day.exposure_ev + 1.5, 1e-5);
    EXPECT_EQ(after_frame(*session, {{"mostEv", 8}}).adapted_ev, 8);
    EXPECT_EQ(after_frame(*session, {{"mostEv", 22}, {"leastEv", 15}}).adapted_ev, 15);
    const Adaptation night =
        after_frame(*session, {{"leastEv", -10}, {"compensation", 0}, {"dark", 1}, {"bright", 1}});
    EXPECT_NEAR(std::exp2(night.exposure_ev + night.adapted_ev - 3), 0.25 * std::exp2(-0.5), 1e-5);
    const Adaptation dusk = after_frame(*session, {{"dark", 25}, {"bright", 25}});
    const double display = std::exp2(dusk.exposure_ev + dusk.adapted_ev - 3);
    EXPECT_GT(display, 0.25 * std::exp2(-0.5) + 0.01);
    EXPECT_LT(display, 0.25 - 0.01);
}

}  // namespace
}  // namespace weft::test
