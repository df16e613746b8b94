// Tests the highlights of capsule and rectangle lights on a white metal floor against the exact integral of
// the reflection over the light. The shaders use one representative point per light, which is an
// approximation, so the tests limit its error.
#include <array>

#include "tests/render/shading/area_reference.h"
#include "tests/render/shading/irradiance_fixture.h"
#include "tests/render/shading/reference_brdf.h"

namespace weft::test {
namespace {

struct Expectation {
    // `least` and `most` limit the sum of the shaders' highlights over the floor, divided by the exact sum.
    double roughness, least, most;
};
// One element for each of the first three roughnesses in irradiance.json (the first three channels of its
// image `highlight`). Measured ratios for these roughnesses: 0.85 to 1.16, 0.75 to 1.09, 0.66 to 1.03.
constexpr std::array kExpectations{Expectation{0.1, 0.8, 1.2}, Expectation{0.3, 0.7, 1.15},
                                   Expectation{0.6, 0.62, 1.08}};
// Limit for the sum of |shader − exact| over all points of the floor, divided by the sum of the exact values.
// The largest measured value is 0.46.
constexpr double kMostOff = 0.5;
// Number of positions of a light along x, and along z. They are a quarter of a metre apart, so that lights
// are also tested between the points of the floor.
constexpr int kMoves = 4;
// Position of the eye in metres; must be the same as in irradiance.comp.
const glm::dvec3 kEye(0.5, 2.5, 6);

using Highlights = std::array<double, kExpectations.size()>;

// Returns the light that a white metal at the point `at` reflects to the eye, for each roughness, by
// integration over the light's surface.
Highlights mirrored(const shared::Light& light, const glm::dvec3& at) {
    const glm::dvec3 v = glm::normalize(kEye - at);
    Highlights sum{};
    for (size_t i = 0; i < kExpectations.size(); ++i) {
        const double roughness = kExpectations[i].roughness;
        const ReferenceSurface mirror{kUp, glm::dvec3(1), 1, roughness};
        const auto add = [&](const glm::dvec3& l, double solid_angle) {
            sum[i] += reflected(mirror, v, l).x * solid_angle;
        };
        // With α = roughness², the reflection lobe is about 2 α × distance wide at the light. The patches
        // are about half as long, except on the round ends of a capsule.
        visit_light(light, at, add, roughness * roughness * distance_to_light(light, at));
    }
    return sum;
}

class Highlight : public Irradiance {
 protected:
    // Tests each light at kMoves² positions, because a highlight may lie between the points of the floor.
    void expect_highlights(scene::LightType type, std::span<const Placement> placements) {
        constexpr size_t kPlaces = size_t{kMoves} * kMoves;
        std::vector<Placement> all;
        for (const Placement& placement : placements) {
            for (size_t i = 0; i < kPlaces; ++i) {
                all.push_back(placement);
                all.back().position += glm::vec3(i % kMoves, 0, i / kMoves) / float{kMoves};
            }
        }
        const Measured m = measure(placed(type, all));
        ASSERT_EQ(m.lights.size(), all.size());
        for (size_t i = 0; i < placements.size(); ++i)
            expect_highlight(m, i * kPlaces, kPlaces, placements[i].name);
    }

 private:
    static void expect_highlight(const Measured& m, size_t first, size_t lights, const char* name) {
        Highlights found{}, wanted{}, different{};
        for (size_t i = first * kPoints; i < (first + lights) * kPoints; ++i) {
            const Highlights reference = mirrored(m.lights[i / kPoints], point_of(i % kPoints));
            for (size_t k = 0; k < kExpectations.size(); ++k) {
                const double seen = m.highlight[i][static_cast<int>(k)];
                found[k] += seen;
                wanted[k] += reference[k];
                different[k] += std::abs(seen - reference[k]);
            }
        }
        for (size_t k = 0; k < kExpectations.size(); ++k) {
            const auto& [roughness, least, most] = kExpectations[k];
            const double share = found[k] / wanted[k], off = different[k] / wanted[k];
            std::printf("%-16s roughness %.1f: %.2f of the light, off by %.2f of it\n", name, roughness,
                        share, off);
            EXPECT_GE(share, least) << name << ", roughness " << roughness;
            EXPECT_LE(share, most) << name << ", roughness " << roughness;
            EXPECT_LE(off, kMostOff) << name << ", roughness " << roughness;
        }
    }
};

TEST_F(Highlight, OfRectanglesAddsUpToAboutTheIntegral) {
    expect_highlights(
        scene::LightType::rectangle,
        std::array{Placement{"hanging, tilted", {0, 1.5f, -2}, {0, -0.5f, 1}, {1, 0, 0}, {0.5f, 0.3f}},
                   Placement{"overhead", {0, 1.5f, 0}, {0, -1, 0}, {1, 0, 0}, {0.4f, 0.4f}},
                   Placement{"a wall", {0, 0.9f, -3}, {0, 0, 1}, {1, 0, 0}, {1.2f, 0.8f}},
                   Placement{"a small one", {0, 1, -1}, {0, -0.5f, 1}, {1, 0, 0}, {0.1f, 0.1f}},
                   Placement{"a strip across", {0, 1, -1}, {0, -0.5f, 1}, {1, 0, 0}, {0.9f, 0.05f}},
                   Placement{"a strip away", {0, 1, -1}, {0, -1, 0}, {0, 0, 1}, {0.9f, 0.05f}}});
}

TEST_F(Highlight, OfCapsulesAddsUpToAboutTheIntegral) {
    expect_highlights(scene::LightType::capsule,
                      std::array{Placement{"lying across", {0, 1, -1}, {1, 0, 0}, {}, {0.6f, 0.08f}},
                                 Placement{"lying away", {0, 1, -1}, {0, 0, 1}, {}, {0.6f, 0.08f}},
                                 Placement{"standing", {0, 0.7f, -1}, {0, 1, 0}, {}, {0.5f, 0.05f}},
                                 Placement{"slanting", {0, 0.9f, -1}, {1, 0.6f, 0.5f}, {}, {0.6f, 0.15f}},
                                 Placement{"a sphere", {0, 1, -1}, {1, 0, 0}, {}, {0, 0.25f}},
                                 Placement{"a thin one", {0, 1, -1}, {1, 0, 0}, {}, {0.9f, 0.02f}}});
}

}  // namespace
}  // namespace weft::test
