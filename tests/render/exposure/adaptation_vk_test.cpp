// Tests the adaptation over time: its speed does not depend on the frame rate, it does not swing, and it
// continues after a change of the size and after a reload.
#include <cmath>

#include "tests/render/exposure/exposure_fixture.h"

namespace weft::test {
namespace {

class AdaptationOverTime : public ExposureTest {
 protected:
    // Starts a session that has adapted to 32 cd/m².
    std::unique_ptr<render::Session> start_adapted(double brighter_s, double darker_s) {
        std::unique_ptr<render::Session> session = start_meter();
        if (!session) return nullptr;
        first_ = after_frame(
            *session, {{"dark", 32}, {"bright", 32}, {"brighter_s", brighter_s}, {"darker_s", darker_s}},
            1.0 / 60);
        EXPECT_EQ(first_.adapted_ev, first_.metered_ev) << "the first frame is adapted";
        return session;
    }
    // Returns the part of the difference from the metered EV that is left.
    [[nodiscard]] double rest(const Adaptation& state) const {
        return (double{state.adapted_ev} - state.metered_ev) / (double{first_.adapted_ev} - state.metered_ev);
    }

    Adaptation first_;
};

TEST_F(AdaptationOverTime, TheRestFallsExponentially) {
    for (const double gain : {16.0, 1.0 / 16}) {
        const std::unique_ptr<render::Session> session =
            start_adapted(gain > 1 ? 1 : 0.1, gain > 1 ? 0.1 : 1);
        ASSERT_TRUE(session);
        double time_s = 0;
        for (const double step_s : {1.0 / 60, 0.1 - 1.0 / 60, 0.4, 0.5, 1.0}) {
            time_s += step_s;
            const double left = rest(after_frame(*session, {{"gain", gain}}, step_s));
            EXPECT_NEAR(left, std::exp(-time_s), 1e-5) << "after " << time_s << " s, gain " << gain;
        }
    }
}

TEST_F(AdaptationOverTime, DoesNotDependOnTheFrameRate) {
    for (const double time_constant_s : {1.0, 0.25}) {
        for (const int rate : {30, 60, 144}) {
            const std::unique_ptr<render::Session> session = start_adapted(time_constant_s, 9);
            ASSERT_TRUE(session);
            Adaptation state;
            for (int i = 0; i < rate; ++i) state = after_frame(*session, {{"gain", 4}}, 1.0 / rate);
            EXPECT_NEAR(rest(state), std::exp(-1 / time_constant_s), 1e-4) << rate << " Hz";
        }
    }
}

TEST_F(AdaptationOverTime, FollowsALargeChangeWithoutSwinging) {
    for (const double gain : {256.0, 1.0 / 256}) {
        const std::unique_ptr<render::Session> session = start_adapted(0.4, 1.2);
        ASSERT_TRUE(session);
        const double sign = gain > 1 ? 1 : -1;
        double before = first_.adapted_ev;
        Adaptation state;
        for (int i = 0; i < 150; ++i) {
            state = after_frame(*session, {{"gain", gain}}, 0.1);
            EXPECT_GE(sign * (state.adapted_ev - before), 0) << "frame " << i;
            EXPECT_LE(sign * (state.adapted_ev - state.metered_ev), 0) << "frame " << i;
            before = state.adapted_ev;
        }
        EXPECT_NEAR(state.adapted_ev, first_.adapted_ev + 8 * sign, 1e-3);
    }
}

TEST_F(AdaptationOverTime, AFrameWithoutTimeIsAdaptedAtOnce) {
    const std::unique_ptr<render::Session> session = start_adapted(1, 1);
    ASSERT_TRUE(session);
    const Adaptation state = after_frame(*session, {{"gain", 64}}, 0);
    EXPECT_EQ(state.adapted_ev, state.metered_ev);
    EXPECT_NEAR(state.metered_ev, first_.metered_ev + 6, 1e-3);
}

TEST_F(AdaptationOverTime, ContinuesAfterAResizeAndAReload) {
    const std::unique_ptr<render::Session> session = start_adapted(1, 1);
    ASSERT_TRUE(session);
    const Status resized = session->resize({200, 100, 1}, warnings_);
    ASSERT_TRUE(resized) << to_text(resized.errors());
    EXPECT_NEAR(rest(after_frame(*session, {{"gain", 16}}, 0.5)), std::exp(-0.5), 1e-5);
    render::PrepareResult prepared = session->prepare(session->selection());
    ASSERT_TRUE(prepared.result) << to_text(prepared.result.errors());
    const Result<bool> swapped = session->swap_in(std::move(*prepared.result));
    ASSERT_TRUE(swapped && *swapped);
    EXPECT_NEAR(rest(after_frame(*session, {}, 0.5)), std::exp(-1), 1e-5);
}

// The values in hdr do not depend on the adaptation, and the picture is as bright as the exposure says,
// whatever the pre-exposure is.
TEST_F(AdaptationOverTime, DoesNotDependOnThePreExposure) {
    const std::unique_ptr<render::Session> session = start_adapted(1, 1);
    ASSERT_TRUE(session);
    const std::vector<std::byte> picture = output_of(*session);
    frame_of(*session).exposure_ev = kStored_ev + 5;
    const Adaptation other = after_frame(*session, {}, 1.0 / 60);
    EXPECT_EQ(other.adapted_ev, first_.adapted_ev);
    EXPECT_TRUE(output_of(*session) == picture);
    EXPECT_NEAR(std::to_integer<int>(picture.at(0)), shown(32 * std::exp2(first_.exposure_ev)), 1);
}

}  // namespace
}  // namespace weft::test
