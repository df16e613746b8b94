// Tests the lookup of the light of the probes (include/probes.glsl): against a reference on the CPU, on
// random volumes with random content, and its continuity along lines.
#include <random>
#include <set>

#include "tests/render/probes/probe_fixture.h"
#include "tests/render/probes/probe_reference.h"

namespace weft::test {
namespace {

constexpr const char* kLookupGraph = WEFT_SOURCE_DIR "/tests/render/probes/lookup.json";
constexpr uint32_t kSteps = 512, kLines = 96;  // As in lookup.json.
// The reference looks up every fourth point.
constexpr uint32_t kStride = 4, kCompared = kSteps * kLines / kStride;

// The same numbers as hash.glsl.
float hash01(uint32_t a, uint32_t b, uint32_t c) {
    uint32_t x = a * 0x9e3779b1u + b;
    x = (x ^ x >> 15) * 0x85ebca77u + c;
    x = (x ^ x >> 13) * 0xc2b2ae3du;
    return float((x ^ x >> 16) >> 8) / 16777216.0f;
}

glm::dvec3 direction_of(uint32_t line, uint32_t which) {
    return glm::normalize(glm::dvec3(hash01(line, which, 6), hash01(line, which, 7), hash01(line, which, 8)) -
                          0.5);
}

// How likely a random volume splits a cell, uses a part of a split cell, and moves or drops a probe.
struct VolumeOdds {
    double split = 0.6, used = 0.8, moved = 0.3, dropped = 0.1;
};

// Returns a volume with three levels: 2 × 1 × 2 cells of 2 m, some of them split once or twice.
scene::ProbeVolume random_volume(uint32_t seed, const VolumeOdds& odds) {
    std::mt19937 random(seed);
    const auto chance = [&](double odds_of) { return std::uniform_real_distribution<>()(random) < odds_of; };
    const auto before = [](const glm::ivec3& a, const glm::ivec3& b) {
        return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
    };
    std::set<glm::ivec3, decltype(before)> points(before);
    const std::function<void(glm::ivec3, int)> add = [&](glm::ivec3 at, int stride) {
        const bool split = stride > 1 && chance(odds.split);
        for (int i = 0; i < 8; ++i) {
            const glm::ivec3 part(i & 1, i >> 1 & 1, i >> 2 & 1);
            if (!split)
                points.insert(at + part * stride);
            else if (chance(odds.used))
                add(at + part * (stride / 2), stride / 2);
        }
    };
    for (int i = 0; i < 4; ++i) add({4 * (i & 1) - 4, 0, 4 * (i >> 1)}, 4);
    scene::ProbeVolume volume;
    volume.origin = {0.31f, -0.27f, 0.13f};
    volume.spacing_m = 0.5f;
    volume.strides = {1, 2, 4};
    for (const glm::ivec3& at : points) {
        scene::Probe probe{at};
        if (chance(odds.moved)) {
            std::uniform_real_distribution<float> way(-0.125f, 0.125f);
            probe.offset = {way(random), way(random), way(random)};
            probe.state = scene::ProbeState::moved;
        }
        if (chance(odds.dropped)) probe = {at, 0, glm::vec3(0), scene::ProbeState::dropped};
        volume.probes.push_back(probe);
    }
    return volume;
}

class ProbeLookup : public ProbeTest {
 protected:
    ProbeResults run(const scene::ProbeVolume& volume, const std::map<std::string, double>& params) {
        const Result<scene::Scene> scene = scene::make_builtin("spheres");
        const std::unique_ptr<render::Session> session =
            start_with_probes(*scene, {volume, {}}, kLookupGraph, {16, 16, 1},
                              {"place", "facing", "mirrored", "probeMoments"}, params);
        if (!session || !draw_frame(*session) || !session->finish()) {
            ADD_FAILURE() << "the graph cannot run";
            return {};
        }
        return take_results(*session);
    }
};

// Returns true if the point is so near to a side of a cell that rounding may change the cell.
bool is_at_side(const scene::ProbeVolume& volume, const glm::dvec3& position) {
    const glm::dmat3 to_grid(glm::transpose(scene::yaw_rotation(volume.yaw_deg)));
    const glm::dvec3 grid = to_grid * (position - glm::dvec3(volume.origin)) / double(volume.spacing_m);
    const glm::dvec3 away = glm::abs(grid - glm::round(grid));
    return std::min({away.x, away.y, away.z}) < 1e-4;
}

TEST_F(ProbeLookup, OfRandomVolumesIsThatOfTheReference) {
    struct Case {
        uint32_t seed;
        double unlit;
        VolumeOdds odds;
        float yaw_deg = 0;
    };
    for (const Case& c : {Case{1, 0, {}}, Case{2, 0.3, {}}, Case{3, 0, {0.9, 1, 0, 0}},
                          Case{4, 0, {0, 1, 1, 0.4}}, Case{7, 0, {}, 28.5f}}) {
        scene::ProbeVolume volume = random_volume(c.seed, c.odds);
        volume.yaw_deg = c.yaw_deg;
        const ProbeResults found = run(volume, {{"unlit", c.unlit}});
        ASSERT_EQ(found.images.size(), 4u);
        ProbeContent content{std::vector<glm::vec4>(found.buffers.at("keepSh").size() / sizeof(glm::vec4)),
                             found.images.at("probeMoments")};
        std::memcpy(content.harmonics.data(), found.buffers.at("keepSh").data(),
                    found.buffers.at("keepSh").size());
        const ProbeReference reference(volume, std::move(content));
        double worst = 0, errors = 0, sum = 0, most_validity = 0;
        for (uint32_t i = 0; i < kSteps * kLines; i += kStride) {
            const uint32_t line = i / kSteps;
            const glm::dvec3 place(found.images.at("place")[i]);
            if (is_at_side(volume, place)) continue;
            const LookedUp wanted = reference.look_up(
                {place, direction_of(line, 2), direction_of(line, 3), direction_of(line, 4)});
            const glm::dvec4 facing(found.images.at("facing")[i]);
            const glm::dvec3 mirrored(found.images.at("mirrored")[i]);
            const double error =
                std::max({glm::length(glm::dvec3(facing) - wanted.facing),
                          glm::length(mirrored - wanted.mirrored), std::abs(facing.w - wanted.validity)});
            worst = std::max(worst, error);
            errors += error;
            sum += wanted.validity;
            most_validity = std::max(most_validity, wanted.validity);
            ASSERT_LE(error, 1e-3) << "seed " << c.seed << ", line " << line << ", step " << i % kSteps
                                   << ": " << facing.x << " when it should be " << wanted.facing.x
                                   << ", validity " << facing.w << " and " << wanted.validity;
        }
        std::printf("seed %u: %zu grid points, mean validity %.3f, mean error %.1e, largest error %.1e\n",
                    c.seed, volume.probes.size(), sum / kCompared, errors / kCompared, worst);
        EXPECT_LE(errors / kCompared, 1e-5);
        EXPECT_GT(most_validity, 0.5);
        EXPECT_LT(sum, 0.99 * kCompared) << "some points are outside of the cells";
    }
}

// The light has no jumps where cells of different levels meet. All parts of split cells exist, so each fine
// cell lies in a coarser one. Nothing hides the points.
TEST_F(ProbeLookup, HasNoJumpsAtTheBordersOfLevels) {
    for (const uint32_t seed : {5u, 6u}) {
        const scene::ProbeVolume volume = random_volume(seed, {0.5, 1, 0, 0});
        const ProbeResults found = run(volume, {{"blocked", 0}});
        ASSERT_EQ(found.images.size(), 4u);
        const std::vector<glm::vec4>&place = found.images.at("place"), &light = found.images.at("facing");
        double worst = 0;
        for (uint32_t i = 1; i + 1 < kSteps * kLines; ++i) {
            if (i % kSteps == 0 || i % kSteps == kSteps - 1) continue;
            const auto at = [&](uint32_t j) { return glm::dvec3(light[j]) * double(light[j].w); };
            const double way_m = glm::distance(glm::dvec3(place[i - 1]), glm::dvec3(place[i + 1]));
            // A jump is a change that the step before does not have. A kink has a small one, because the
            // steps are short: at most 0.03 spacings.
            const double jump = glm::length(at(i + 1) - 2.0 * at(i) + at(i - 1));
            worst = std::max(worst, jump);
            EXPECT_LE(jump, 0.1) << "seed " << seed << ", line " << i / kSteps << ", step " << i % kSteps
                                 << " of " << way_m / 2 << " m";
        }
        std::printf("seed %u: largest jump %.4f\n", seed, worst);
    }
}

}  // namespace
}  // namespace weft::test
