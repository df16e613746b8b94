// Tests the light of the surroundings for eyes that look at an angle, and the cube of diffuse light: both are
// compared with sums over many directions.
#include <algorithm>

#include "tests/render/shading/ambient_fixture.h"

namespace weft::test {
namespace {

// A bright panel of 40° × 60° in dark surroundings: the sum of nine harmonics has large errors here.
double panel_sky(const glm::dvec3& d) {
    const glm::dvec3 middle = glm::normalize(glm::dvec3(1, 0.4, 0.8)),
                     right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), middle)),
                     up = glm::cross(middle, right);
    const double depth = glm::dot(d, middle);
    const bool inside = depth > 0 && std::abs(glm::dot(d, right)) < std::tan(20 * kPi / 180) * depth &&
                        std::abs(glm::dot(d, up)) < std::tan(30 * kPi / 180) * depth;
    return inside ? 100 : 0.5;
}

// Returns the light that a rough surface mirrors to an eye in the direction v: GGX with height-correlated
// Smith, divided by its directional albedo.
double mirrored_at_angle(const CubeSum& cube, const glm::dvec3& n, const glm::dvec3& v, double roughness) {
    const double alpha = roughness * roughness, n_v = glm::dot(n, v);
    double sum = 0, weights = 0;
    for (size_t i = 0; i < cube.directions.size(); ++i) {
        const double n_l = glm::dot(n, cube.directions[i]);
        if (n_l <= 0) continue;
        const double n_h = glm::dot(n, glm::normalize(cube.directions[i] + v));
        const double weight = ggx(alpha, n_h) * smith_g2_correlated(alpha, n_l, n_v) * cube.angles[i];
        sum += weight * cube.radiance[i];
        weights += weight;
    }
    return sum / weights;
}

// Returns Σ |found − wanted| / Σ wanted.
struct Difference {
    double error = 0, wanted = 0;
    void add(double found, double expected) {
        error += std::abs(found - expected);
        wanted += expected;
    }
    [[nodiscard]] double share() const { return error / wanted; }
};

TEST_F(AmbientLight, MirroredLightAtAnAngleComesFromTheLobeOfTheAngle) {
    constexpr std::array kRoughnesses{0.25, 0.4, 0.6, 0.8};
    constexpr std::array kCosines{0.9, 0.6, 0.35};
    for (const auto& [name, light, most] :
         {std::tuple{"panel", Surroundings(panel_sky), 0.11}, {"sky", Surroundings(smooth_sky), 0.055}}) {
        const std::vector<glm::vec4> found = run(light, {"slanted"})["slanted"];
        ASSERT_EQ(found.size(), kDirections * 12);
        const CubeSum cube = cube_sum(light);
        for (size_t row = 0; row < 12; ++row) {
            const double roughness = kRoughnesses[row / 3], n_v = kCosines[row % 3];
            Difference difference;
            for (size_t i = 0; i < kDirections; i += 4) {
                const glm::dvec3 n = spiral(i);
                const glm::dvec3 axis = std::abs(n.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
                const glm::dvec3 v = n * n_v + glm::normalize(glm::cross(n, axis)) * std::sqrt(1 - n_v * n_v);
                difference.add(found[row * kDirections + i].g, mirrored_at_angle(cube, n, v, roughness));
            }
            std::printf("%s, roughness %.2f, n·v %.2f: L1 %.4f\n", name, roughness, n_v, difference.share());
            EXPECT_LT(difference.share(), most);
        }
    }
}

TEST_F(AmbientLight, TheCubeOfDiffuseLightIsExactForAnySource) {
    for (const Surroundings& light :
         {Surroundings(panel_sky), Surroundings(spot_sky), Surroundings(half_sky)}) {
        const std::vector<glm::vec4> found = run(light, {"irradiance"})["irradiance"];
        ASSERT_EQ(found.size(), kDirections);
        const CubeSum cube = cube_sum(light);
        Difference difference;
        for (size_t i = 0; i < kDirections; ++i) difference.add(found[i].g, filtered(cube, spiral(i), 1));
        std::printf("diffuse light: L1 %.4f\n", difference.share());
        EXPECT_LT(difference.share(), 0.01);
    }
}

}  // namespace
}  // namespace weft::test
