// Tests the order in which irradiance probes are lit anew, while the camera moves at random.
#include "render/probes/probe_turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace weft::render {
namespace {

std::vector<glm::vec3> random_places(size_t count, std::mt19937& random) {
    std::uniform_real_distribution<float> number(-20, 20);
    std::vector<glm::vec3> places;
    for (size_t i = 0; i < count; ++i) places.emplace_back(number(random), number(random), number(random));
    return places;
}

// The camera: it stands still, walks in small steps, or jumps anywhere in each frame.
enum class Way : uint8_t { stands, walks, jumps };

class Turns : public ::testing::TestWithParam<std::tuple<size_t, Way, uint32_t>> {};

TEST_P(Turns, AreFewApartAndForAllProbesInTime) {
    const auto [count, way, seed] = GetParam();
    std::mt19937 random(seed);
    const std::vector<glm::vec3> places = random_places(count, random);
    std::uniform_real_distribution<float> number(-20, 20);
    std::normal_distribution<float> step(0, 0.5f);
    ProbeTurns turns(places);
    glm::vec3 camera(0);
    // The frame of the last turn, as if all probes had had a turn before the first frame.
    std::vector<int64_t> last(count, -1);
    const int64_t stale = 2 * ((static_cast<int64_t>(count) + 3) / 4);
    const int64_t most_between = std::max<int64_t>(stale, 2 * ProbeTurns::kLeastFramesBetween);
    for (int64_t frame = 0; frame < 6 * stale; ++frame) {
        if (way == Way::walks) camera += glm::vec3(step(random), step(random), step(random));
        if (way == Way::jumps) camera = {number(random), number(random), number(random)};
        const std::vector<uint32_t> now = turns.next(camera);
        ASSERT_LE(now.size(), 4u);
        // 40 probes and more always have four that may run.
        if (count > 40) {
            ASSERT_EQ(now.size(), 4u) << "frame " << frame;
        }
        for (const uint32_t probe : now) {
            ASSERT_LT(probe, count);
            if (last[probe] >= 0) {
                ASSERT_GE(frame - last[probe], 10) << "probe " << probe;
            }
            last[probe] = frame;
        }
        for (size_t probe = 0; probe < count; ++probe)
            ASSERT_LE(frame - last[probe], most_between) << "probe " << probe << " in frame " << frame;
    }
}

INSTANTIATE_TEST_SUITE_P(Cameras, Turns,
                         ::testing::Combine(::testing::Values(255, 100, 41, 12, 3, 1),
                                            ::testing::Values(Way::stands, Way::walks, Way::jumps),
                                            ::testing::Values(1u, 2u, 3u)));

TEST(ProbeTurns, TheNearestProbesComeFirst) {
    std::mt19937 random(7);
    const std::vector<glm::vec3> places = random_places(255, random);
    ProbeTurns turns(places);
    const glm::vec3 camera(3, 1, -4);
    std::vector<uint32_t> order(places.size());
    for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, {},
                             [&](uint32_t i) { return glm::dot(places[i] - camera, places[i] - camera); });
    std::vector<uint32_t> chosen;
    while (chosen.size() < 252)
        for (const uint32_t probe : turns.next(camera)) chosen.push_back(probe);
    order.resize(chosen.size());
    EXPECT_EQ(chosen, order);
}

// In the second round, the order follows the camera that has moved in the meantime.
TEST(ProbeTurns, ANewRoundBeginsAtTheCamera) {
    std::vector<glm::vec3> places;
    for (int i = 0; i < 80; ++i) places.emplace_back(i, 0, 0);
    ProbeTurns turns(places);
    EXPECT_EQ(turns.next({0, 0, 0}), (std::vector<uint32_t>{0, 1, 2, 3}));
    for (int frame = 1; frame < 20; ++frame) static_cast<void>(turns.next({0, 0, 0}));
    EXPECT_EQ(turns.next({30.2f, 0, 0}), (std::vector<uint32_t>{30, 31, 29, 32}));
}

TEST(ProbeTurns, WithoutProbesNothingRuns) {
    EXPECT_TRUE(ProbeTurns().next({0, 0, 0}).empty());
}

}  // namespace
}  // namespace weft::render
