// Tests the irradiance on a plane as the shaders compute it. Point, spot and directional lights are compared
// with closed forms. Capsules and rectangles are compared with numeric integrals: above and across the
// horizon, near and far. Light functions are tested too.
#include <array>

#include "tests/render/shading/area_reference.h"
#include "tests/render/shading/irradiance_fixture.h"
#include "tests/render/shading/reference_light.h"

namespace weft::test {
namespace {

TEST_F(Irradiance, OfLightsWithoutExtentIsTheirClosedForm) {
    std::vector<scene::Light> lights;
    lights.push_back(light_of(scene::LightType::directional, {}, {0.3f, -1, 0.2f}, 20));
    for (const float range_m : {0.0f, 3.0f}) {
        lights.push_back(light_of(scene::LightType::point, {0.3f, 0.7f, -0.4f}, {0, -1, 0}, 10));
        lights.back().range_m = range_m;
        lights.push_back(light_of(scene::LightType::spot, {-0.5f, 2, 1}, {0.4f, -1, 0.1f}, 10));
        lights.back().inner_cone_rad = 0.2f;
        lights.back().outer_cone_rad = 0.8f;
        lights.back().range_m = range_m;
    }
    const Measured m = measure(lights);
    ASSERT_EQ(m.lights.size(), lights.size());
    double worst = 0;
    for (size_t light = 0; light < m.lights.size(); ++light) {
        for (size_t i = 0; i < kPoints; ++i) {
            glm::dvec3 l;
            const glm::dvec3 sent = incident(m.lights[light], point_of(i), l);
            const double expected = sent.x * std::max(0.0, glm::dot(kUp, l));
            const double error = std::abs(m.at(light, i).x - expected) / std::max(expected, 1e-4);
            EXPECT_LE(error, 1e-3) << "light " << light << ", point " << i;
            worst = std::max(worst, error);
        }
    }
    std::printf("worst relative error %.1e\n", worst);
}

// Compares the irradiance of each light with `reference`. Points for which `reference` is negative are
// skipped. The error is divided by the expected value, or by 3e-5 if the expected value is smaller. For
// comparison: a whole sky of radiance 1 gives the irradiance π. Lights beyond the number of placements are
// ignored.
template <class Reference>
void expect_close(const Measured& m, std::span<const Placement> placements, double tolerance,
                  const Reference& reference) {
    ASSERT_GE(m.lights.size(), placements.size());
    for (size_t light = 0; light < placements.size(); ++light) {
        double worst = 0, brightest = 0;
        for (size_t i = 0; i < kPoints; ++i) {
            const double expected = reference(m.lights[light], point_of(i));
            if (expected < 0) continue;
            const double found = m.at(light, i).x;
            const double error = std::abs(found - expected) / std::max(expected, 3e-5);
            EXPECT_LE(error, tolerance) << placements[light].name << ", point " << i << ": " << found
                                        << " when it should be " << expected;
            worst = std::max(worst, error);
            brightest = std::max(brightest, expected);
        }
        EXPECT_GT(brightest, 0) << placements[light].name;
        std::printf("%-28s worst relative error %.1e, brightest %.2e\n", placements[light].name, worst,
                    brightest);
    }
}

TEST_F(Irradiance, OfRectanglesIsThatOfTheirPatches) {
    const std::array placements{
        Placement{"overhead", {0, 2, 0}, {0, -1, 0}, {1, 0, 0}, {0.5f, 0.3f}},
        Placement{"overhead, of range 2.5 m", {0, 2, 0}, {0, -1, 0}, {1, 0, 0}, {0.5f, 0.3f}, 2.5f},
        Placement{"tilted", {-2, 1.5f, 1}, {1, -1, -0.3f}, {0.2f, 0.5f, -1}, {0.8f, 0.4f}},
        Placement{"wall, half below", {-4.2f, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0.7f}},
        Placement{"wall, a tenth above", {-4.2f, -0.56f, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0.7f}},
        Placement{
            "turned, a corner above", {0.1f, -0.5f, -4.1f}, {0.1f, 0.1f, 1}, {1, 0.8f, 0}, {0.6f, 0.5f}},
        Placement{
            "turned, a corner below", {0.1f, 0.5f, -4.1f}, {0.1f, -0.2f, 1}, {1, 0.8f, 0}, {0.6f, 0.5f}},
        Placement{"wide and close", {0, 0.2f, 0}, {0, -1, 0}, {1, 0, 0}, {3, 3}},
        Placement{"of 2 cm", {0.2f, 3, 0}, {0, -1, 0}, {1, 0, 0}, {0.01f, 0.01f}},
        Placement{"a strip", {0, 0.3f, 0.2f}, {0.2f, -1, 0}, {0, 0, 1}, {2, 0.005f}},
        Placement{"100 m away, half below", {100, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {5, 8}},
        Placement{"shines upwards", {0, 0.5f, 0}, {0.5f, 1, 0}, {0, 0, 1}, {1, 1}},
    };
    const Measured m = measure(placed(scene::LightType::rectangle, placements));
    expect_close(m, placements, 0.02, [](const shared::Light& light, const glm::dvec3& at) {
        return area_irradiance(light, at, kUp);
    });
}

TEST_F(Irradiance, OfCapsulesIsThatOfTheirPatches) {
    const std::array placements{
        Placement{"overhead", {0, 1.5f, 0}, {1, 0, 0}, {}, {0.6f, 0.1f}},
        Placement{"overhead, of range 2 m", {0, 1.5f, 0}, {1, 0, 0}, {}, {0.6f, 0.1f}, 2},
        Placement{"tilted", {1, 1, -1}, {1, 0.5f, 0.3f}, {}, {0.8f, 0.15f}},
        Placement{"lying, half sunk", {0, 0, 0}, {1, 0, 0.4f}, {}, {1, 0.2f}},
        Placement{"lying, a fifth above", {0, -0.12f, 0}, {1, 0, 0.4f}, {}, {1, 0.2f}},
        Placement{"standing, half sunk", {0, 0, 0}, {0, 1, 0}, {}, {1, 0.2f}},
        Placement{"standing, its end above", {0, -1, 0}, {0, 1, 0}, {}, {1, 0.3f}},
        Placement{"slanting through the floor", {0, 0.1f, 0}, {1, 0.4f, 0.2f}, {}, {1.2f, 0.1f}},
        Placement{"a sphere", {0, 1, 0}, {1, 0, 0}, {}, {0, 0.4f}},
        Placement{"a sphere, half sunk", {0, 0, 0}, {1, 0, 0}, {}, {0, 0.4f}},
        Placement{"a sphere, a quarter above", {0, -0.2f, 0}, {1, 0, 0}, {}, {0, 0.4f}},
        Placement{"thin and close", {0, 0.3f, 0.2f}, {0, 0, 1}, {}, {2, 0.005f}},
        Placement{"end on", {-6, 0.05f, -0.5f}, {1, 0, 0}, {}, {1, 0.3f}},
        Placement{"nearly end on", {-6, 0.4f, -0.5f}, {1, 0, 0}, {}, {1, 0.3f}},
        Placement{"200 m away, half below", {200, 0, 0}, {0, 0.3f, 1}, {}, {10, 3}},
    };
    const Measured m = measure(placed(scene::LightType::capsule, placements));
    expect_close(m, placements, 0.02, [](const shared::Light& light, const glm::dvec3& at) {
        if (distance_to_light(light, at) < 1.05 * double(light.half_size_m.y))
            // The point is inside the capsule or too close to its surface, so it is skipped.
            return -1.0;
        return area_irradiance(light, at, kUp);
    });
}

scene::Light shaped(scene::LightType type, glm::vec3 position, glm::vec3 direction, glm::vec3 side) {
    scene::Light light = light_of(type, position, direction, 10);
    light.side = side;
    light.outer_cone_rad = 1.4f;
    light.inner_cone_rad = 1.39f;
    light.half_size_m = {0.2f, 0.2f};
    light.function = 0;
    return light;
}

// Measures the factor by which a light function changes the light, at each point. It compares two equal
// lights, of which only one has the function. The factor is -1 where the other light gives no light.
class Functions : public Irradiance {
 protected:
    std::vector<double> factors(scene::Light light, const scene::LightFunction& function,
                                const std::vector<scene::Texture>& textures = {}) {
        scene::Scene scene;
        scene.light_functions = {function};
        scene.textures = textures;
        scene.lights = {light, light};
        scene.lights[1].function = scene::kNone;
        const Measured m = measure(std::move(scene));
        std::vector<double> shares;
        if (m.irradiance.empty()) return shares;
        // The session sorts its list of lights, so the two lights may change places. In this list, function 0
        // means that the light has no function.
        const size_t shaped = m.lights[0].function != 0 ? 0 : 1, plain = 1 - shaped;
        for (size_t i = 0; i < kPoints; ++i)
            shares.push_back(m.at(plain, i).x > 1e-6 ? m.at(shaped, i).x / m.at(plain, i).x : -1);
        return shares;
    }
};

TEST_F(Functions, DoorsCutTheLightOffWhereTheyAre) {
    scene::LightFunction function;
    // Angles in radians from the direction of the light to the left, right, bottom and top door.
    function.doors = {0.3f, 0.6f, scene::LightFunction::kNoDoor, 0.4f};
    function.softness = 0.02f;
    // The light faces down. Its width is along +x, and its height is along -z.
    for (const scene::LightType type :
         {scene::LightType::spot, scene::LightType::point, scene::LightType::rectangle}) {
        const std::vector<double> shares = factors(shaped(type, {0, 3, 0}, {0, -1, 0}, {1, 0, 0}), function);
        ASSERT_EQ(shares.size(), kPoints);
        size_t lit = 0;
        for (size_t i = 0; i < kPoints; ++i) {
            const double x = point_of(i).x / 3, up = -point_of(i).z / 3;
            const bool between = x > -std::tan(0.3) && x < std::tan(0.6) && up < std::tan(0.4);
            EXPECT_NEAR(shares[i], between ? 1 : 0, 1e-5) << "point " << i;
            lit += between ? 1 : 0;
        }
        EXPECT_GT(lit, 4u);
        EXPECT_LT(lit, kPoints / 2);
    }
}

TEST_F(Functions, CurvesFollowTheirBezier) {
    scene::LightFunction function;
    // These four Bézier values give the factor t², where t is the distance divided by reach_m. Up to reach_m,
    // this factor cancels the light's decrease with the square of the distance.
    function.curve = {0, 0, 1.0f / 3, 1};
    function.reach_m = 4;
    const scene::Light light = shaped(scene::LightType::point, {0, 1, 0}, {0, -1, 0}, {1, 0, 0});
    const std::vector<double> shares = factors(light, function);
    ASSERT_EQ(shares.size(), kPoints);
    for (size_t i = 0; i < kPoints; ++i) {
        const double t = std::min(1.0, glm::distance(point_of(i), glm::dvec3(light.position)) / 4);
        EXPECT_NEAR(shares[i], t * t, 1e-4);
    }
}

// Returns a picture whose upper left quarter is red and whose upper right quarter is green. Its lower half is
// dark.
scene::Texture quarters() {
    scene::Texture texture{"quarters", 4, 4, scene::ColorSpace::srgb, {{}}};
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            for (const int channel : {y < 2 && x < 2 ? 255 : 0, y < 2 && x >= 2 ? 255 : 0, 0, 255})
                texture.mips[0].push_back(static_cast<uint8_t>(channel));
    return texture;
}

TEST_F(Functions, PicturesLieTheRightWayRound) {
    scene::LightFunction function;
    function.picture = 0;
    function.picture_half_size = {std::atan(3.6f / 3), std::atan(3.6f / 3)};
    function.softness = 0.001f;
    scene::Scene scene;
    scene.light_functions = {function};
    scene.textures = {quarters()};
    scene.lights = {shaped(scene::LightType::spot, {0, 3, 0}, {0, -1, 0}, {1, 0, 0})};
    const Measured m = measure(std::move(scene));
    ASSERT_FALSE(m.irradiance.empty());
    for (size_t i = 0; i < kPoints; ++i) {
        const glm::dvec3 at = point_of(i);
        if (std::abs(at.x) < 1 || std::abs(at.z) < 1 || std::abs(at.x) > 3 || std::abs(at.z) > 3) continue;
        // The upper half of the picture falls on z < 0, because up = side × direction = -z.
        const bool upper = at.z < 0;
        EXPECT_EQ(m.at(0, i).r > 1e-3, upper && at.x < 0) << i;
        EXPECT_EQ(m.at(0, i).g > 1e-3, upper && at.x > 0) << i;
        EXPECT_EQ(m.at(0, i).b, 0) << i;
    }
}

}  // namespace
}  // namespace weft::test
