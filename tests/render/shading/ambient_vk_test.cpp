// Tests the module environment.json: filtered light and spherical harmonics are compared with sums over many
// directions and with closed forms.
#include <algorithm>

#include "tests/render/shading/ambient_fixture.h"

namespace weft::test {
namespace {

// Root of the mean square, and the largest error, as shares of the root mean square of the reference.
struct Errors {
    double rms = 0, most = 0;
};

// `expected` returns the reference for a direction.
Errors errors_of(const std::vector<glm::vec4>& found, int roughness10, const Surroundings& expected) {
    double squares = 0, reference = 0, most = 0;
    for (size_t i = 0; i < kDirections; ++i) {
        const double wanted = expected(spiral(i));
        const double error = found[size_t(roughness10 - 1) * kDirections + i].g - wanted;
        squares += error * error;
        reference += wanted * wanted;
        most = std::max(most, std::abs(error));
    }
    const double scale = std::sqrt(reference / kDirections);
    return {std::sqrt(squares / kDirections) / scale, most / scale};
}

// Compares the filtered light of the roughnesses 0.1, 0.2, 0.4, 0.6, 0.8 and 1 with references.
void expect_errors(const char* name, const std::vector<glm::vec4>& found, const Surroundings& light,
                   const std::array<Errors, 6>& allowed) {
    ASSERT_EQ(found.size(), kDirections * 10);
    const CubeSum cube = cube_sum(light);
    constexpr std::array kTenths{1, 2, 4, 6, 8, 10};
    for (size_t i = 0; i < kTenths.size(); ++i) {
        const double roughness = kTenths[i] / 10.0;
        const Errors e = errors_of(found, kTenths[i], [&](const glm::dvec3& n) {
            return kTenths[i] == 1 ? sampled(light, n, roughness) : filtered(cube, n, roughness);
        });
        std::printf("%s, roughness %.1f: RMS %.2f %%, largest %.2f %%\n", name, roughness, e.rms * 100,
                    e.most * 100);
        EXPECT_LE(e.rms, allowed[i].rms);
        EXPECT_LE(e.most, allowed[i].most);
    }
}

TEST_F(AmbientLight, ASmoothSkyIsFiltered) {
    expect_errors(
        "sky", run(smooth_sky)["mirrored"], smooth_sky,
        {{{0.008, 0.06}, {0.003, 0.015}, {0.002, 0.015}, {0.003, 0.015}, {0.005, 0.02}, {0.007, 0.02}}});
}
TEST_F(AmbientLight, AHalfWhiteSphereIsFiltered) {
    expect_errors(
        "half", run(half_sky)["mirrored"], half_sky,
        {{{0.01, 0.07}, {0.004, 0.016}, {0.002, 0.015}, {0.003, 0.018}, {0.007, 0.025}, {0.002, 0.004}}});
}
// A spot of 5° that is 1000 times as bright as its surroundings has larger errors, most of all next to the
// spot with the roughness 0.1.
TEST_F(AmbientLight, ASpotIsFiltered) {
    expect_errors("spot", run(spot_sky)["mirrored"], spot_sky,
                  {{{0.3, 6}, {0.03, 0.3}, {0.06, 0.4}, {0.05, 0.3}, {0.1, 0.5}, {0.05, 0.12}}});
}

// Direction of the middle of a texel of a cube map, in the order of Vulkan's faces.
glm::dvec3 cube_direction(size_t face, double u, double v) {
    const std::array<glm::dvec3, 6> directions{glm::dvec3(1, -v, -u), {-1, -v, u}, {u, 1, v},
                                               {u, -1, -v},           {u, -v, 1},  {-u, -v, -1}};
    return glm::normalize(directions[face]);
}

// The lobe of each mip multiplies harmonics of order l by c_l: the table is computed from GGX with N = V.
TEST_F(AmbientLight, ZonalHarmonicsAreMultipliedByTheTable) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, -2));
    struct Row {
        const char* mip;
        double c1, c2;
    };
    constexpr std::array kTable{
        Row{"environmentCube.mip(2)", 0.98765, 0.96526}, Row{"environmentCube.mip(3)", 0.91816, 0.78420},
        Row{"environmentCube.mip(4)", 0.81509, 0.54473}, Row{"environmentCube.mip(5)", 0.72549, 0.36014}};
    const auto order = [&](int l, const glm::dvec3& d) {
        const double x = glm::dot(d, axis);
        return l == 1 ? x : 1.5 * x * x - 0.5;
    };
    for (const int l : {1, 2}) {
        std::vector<std::string> observed;
        for (const Row& row : kTable) observed.emplace_back(row.mip);
        auto found = run([&](const glm::dvec3& d) { return 2 + order(l, d); }, observed);
        for (const Row& row : kTable) {
            const std::vector<glm::vec4>& texels = found[row.mip];
            ASSERT_FALSE(texels.empty());
            const auto side = static_cast<size_t>(std::lround(std::sqrt(double(texels.size()) / 6)));
            ASSERT_EQ(texels.size(), side * side * 6);
            double product = 0, squares = 0;
            for (size_t i = 0; i < texels.size(); ++i) {
                const double u = (2.0 * double(i % side) + 1) / double(side) - 1,
                             v = (2.0 * double(i / side % side) + 1) / double(side) - 1,
                             weight = std::pow(1 + u * u + v * v, -1.5);
                const double y = order(l, cube_direction(i / (side * side), u, v));
                // The texels are divided by the unit of the cube, which is 2⁻¹² for values up to 3.
                product += weight * y * (texels[i].g / 4096 - 2);
                squares += weight * y * y;
            }
            const double expected = l == 1 ? row.c1 : row.c2;
            std::printf("%s: c%d = %.5f, expected %.5f\n", row.mip, l, product / squares, expected);
            EXPECT_NEAR(product / squares, expected, expected * 0.005);
        }
    }
}

// Returns the largest error of the diffuse light, and checks that no value is negative.
double diffuse_error(const std::vector<glm::vec4>& found, const Surroundings& expected) {
    double most = 0;
    for (size_t i = 0; i < found.size(); ++i) {
        EXPECT_GE(found[i].g, 0);
        most = std::max(most, std::abs(found[i].g - expected(spiral(i))));
    }
    return most;
}

TEST_F(AmbientLight, HarmonicsOfNineTermsAreExactWhereTheyShouldBe) {
    EXPECT_LT(diffuse_error(run([](const glm::dvec3&) { return 3; })["diffuse"],
                            [](const glm::dvec3&) { return 3; }),
              0.002);
    const glm::dvec3 b(0.5, -0.7, 0.9);
    EXPECT_LT(diffuse_error(run([&](const glm::dvec3& d) { return 2 + glm::dot(b, d); })["diffuse"],
                            [&](const glm::dvec3& n) { return 2 + glm::dot(b, n) * 2 / 3; }),
              0.004);
    EXPECT_LT(diffuse_error(run([](const glm::dvec3& d) { return d.z * d.z; })["diffuse"],
                            [](const glm::dvec3& n) { return 1 / 3.0 + (n.z * n.z - 1 / 3.0) / 4; }),
              0.001);
    EXPECT_LT(diffuse_error(run([](const glm::dvec3& d) { return d.y > 0 ? 1.0 : 0.0; })["diffuse"],
                            [](const glm::dvec3& n) { return (1 + n.y) / 2; }),
              0.003);
}

// An overcast sky over black ground: exact upwards 7/9, downwards 0. The sum of nine terms would be negative
// downwards.
TEST_F(AmbientLight, AnOvercastSkyDoesNotRing) {
    const auto sky = [](const glm::dvec3& d) { return d.y > 0 ? (1 + 2 * d.y) / 3 : 0; };
    const std::vector<glm::vec4> found = run(sky)["diffuse"];
    const CubeSum cube = cube_sum(sky);
    EXPECT_LT(diffuse_error(found, [&](const glm::dvec3& n) { return filtered(cube, n, 1); }), 0.012);
}

// The harmonics of the GPU are those that the CPU computes from the whole picture, also where both are
// reduced because of a small bright source.
TEST_F(AmbientLight, TheGpuComputesTheHarmonicsOfTheCpu) {
    for (const Surroundings& light : {Surroundings(smooth_sky), Surroundings(spot_sky)}) {
        scene::Scene scene;
        scene.environment = picture_of(light);
        const std::vector<glm::vec4> found = run(scene)["sh"];
        ASSERT_EQ(found.size(), 9u);
        const std::array<glm::vec3, 9>& expected = scene.environment.irradiance_over_pi;
        for (size_t i = 0; i < 9; ++i)
            EXPECT_NEAR(found[i].g, expected[i].g, expected[0].g * 0.01) << "coefficient " << i;
    }
}

// Away from a small bright source, the sum of nine terms would be negative. It must keep some of the little
// light that comes from there.
TEST_F(AmbientLight, TheSideAwayFromASpotKeepsItsLight) {
    const std::vector<glm::vec4> found =
        run([](const glm::dvec3& d) { return spot_sky(d) > 1 ? 1000 : 0.02; })["diffuse"];
    ASSERT_EQ(found.size(), kDirections);
    float least = 1;
    for (const glm::vec4& texel : found) least = std::min(least, texel.g);
    std::printf("least light %.4f\n", double(least));
    EXPECT_GT(least, 0.004);
}

// The smallest mip has one texel per face, which is the mean over the solid angle of the face.
TEST_F(AmbientLight, MipsAreMeansOverSolidAngles) {
    const std::vector<glm::vec4> found =
        run([](const glm::dvec3& d) { return 2 + d.x; }, {"environmentRaw.mip(8)"})["environmentRaw.mip(8)"];
    ASSERT_EQ(found.size(), 6u);
    const CubeSum cube = cube_sum([](const glm::dvec3& d) { return d.x; });
    double sum = 0, angle = 0;
    for (size_t i = 0; i < CubeSum::kSide * CubeSum::kSide; ++i) {  // the face +x
        sum += cube.radiance[i] * cube.angles[i];
        angle += cube.angles[i];
    }
    EXPECT_NEAR(found[0].g / 4096 - 2, sum / angle, 0.003);
    EXPECT_NEAR(found[1].g / 4096 - 2, -sum / angle, 0.003);
    EXPECT_NEAR(found[2].g / 4096 - 2, 0, 0.003);
}

TEST_F(AmbientLight, TheGradientSkyLightsWithoutAPicture) {
    scene::Scene scene;
    scene.sky_zenith = glm::vec3(4000);
    scene.sky_horizon = glm::vec3(9000);
    const auto found = run(scene);
    const CubeSum cube = cube_sum([](const glm::dvec3& d) {
        if (d.y >= 0) return glm::mix(9000.0, 4000.0, std::sqrt(d.y));
        const double t = std::min(-d.y / 0.15, 1.0);
        return glm::mix(9000.0, 2250.0, t * t * (3 - 2 * t));
    });
    for (const int roughness10 : {2, 4, 6, 8, 10}) {
        const Errors e = errors_of(found.at("mirrored"), roughness10, [&](const glm::dvec3& n) {
            return filtered(cube, n, roughness10 / 10.0);
        });
        EXPECT_LT(e.rms, 0.02) << roughness10;
    }
}

}  // namespace
}  // namespace weft::test
