// Tests lookups in the shadow maps of lamps against closed forms: the profile of a penumbra, and planes that
// must not shadow themselves.
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "tests/render/shading/quad_scene.h"
#include "tests/render/sun/sun_fixture.h"

namespace weft::test {
namespace {

const std::string kLampGraphs = WEFT_SOURCE_DIR "/tests/render/lamp_shadows/";
constexpr float kEdgeMapSize = 1024;  // As in grid.json.

// A ground of 16 m × 16 m. If `plate_m` is above 0, a plate of 8 m × 4 m is at this height over the half of
// the ground with x < 0, so that its edge is above x = 0.
scene::Scene ground_under(const scene::Light& light, float plate_m) {
    scene::Scene scene;
    scene.meshes.push_back(ground_mesh());
    scene.materials.emplace_back();
    scene.instances = {{"ground", 0, 0, glm::scale(glm::mat4(1), glm::vec3(2, 1, 2))}};
    const glm::mat4 plate = glm::translate(glm::mat4(1), glm::vec3(-2, plate_m, 0));
    if (plate_m > 0) scene.instances.push_back({"plate", 0, 0, glm::scale(plate, glm::vec3(0.5f, 1, 1))});
    scene.lights = {light};
    return scene;
}

scene::Light lamp_above(scene::LightType type, const glm::vec3& at) {
    scene::Light light;
    light.type = type;
    light.position = at;
    light.direction = {0, -1, 0};
    light.side = {1, 0, 0};
    return light;
}

// The share of a disc on one side of a line: t is −1 if the line leaves nothing, and 1 if it leaves all.
double share_of_disc(double t) {
    t = std::clamp(t, -1.0, 1.0);
    return 0.5 + (t * std::sqrt(1 - t * t) + std::asin(t)) / std::numbers::pi;
}

class LampEdges : public SessionTest {
 protected:
    // Returns the visible share at the points of a grid. The result is empty on an error.
    std::vector<float> look(const scene::Scene& scene, const Grid& grid) {
        const FileReader reader = [&](const std::string& path) {
            std::optional<std::string> text = read_text(path);
            if (!text || !path.ends_with("grid.json")) return text;
            put(*text, "CORNER", grid.corner);
            put(*text, "RIGHT", grid.right);
            put(*text, "DOWN", grid.down);
            return text;
        };
        const std::unique_ptr<render::Session> session =
            start(scene, scene::framing_camera(scene, 1), kLampGraphs + "grid.json", {64, 64, 1}, {"seen"}, 0,
                  reader);
        if (!session) return {};
        std::vector<float> shares;
        Status done = draw_frame(*session);
        if (done) done = session->finish();
        EXPECT_TRUE(done) << to_text(done.errors());
        for (const vk::ReadbackData& data : session->take_readbacks())
            for (const glm::vec4& texel : render::decode_texels(data.format, data.bytes))
                shares.push_back(texel.r);
        return shares;
    }

    // Compares the shares along x with the share of the light that an edge leaves. `width_m`: width of the
    // penumbra.
    void expect_profile(const scene::Light& light, double width_m, double (*share)(double)) {
        constexpr float kStep = 0.001f;
        const Grid grid{{-kStep * kGrid / 2, 0, -1}, {kStep, 0, 0}, {0, 0, 2.0f / kGrid}};
        const std::vector<float> seen = look(ground_under(light, 1), grid);
        ASSERT_FALSE(seen.empty());
        double largest = 0, sum = 0, bias = 0;
        for (uint32_t i = 0; i < seen.size(); ++i) {
            const double t = 2 * double{grid.at(i).x} / width_m, error = double{seen[i]} - share(t);
            largest = std::max(largest, std::abs(error));
            sum += std::abs(error);
            bias += error;
        }
        const auto count = static_cast<double>(seen.size());
        std::printf("penumbra of %.3f m: mean error %.4f, largest %.4f, mean %.4f\n", width_m, sum / count,
                    largest, bias / count);
        EXPECT_LT(sum / count, 0.03);
        EXPECT_LT(largest, 0.15);
        EXPECT_LT(std::abs(bias / count), 0.01);
    }
};

TEST_F(LampEdges, ThePenumbraOfASphereHasItsProfile) {
    scene::Light light = lamp_above(scene::LightType::capsule, {0, 4, 0});
    light.half_size_m = {0, 0.5f};
    expect_profile(light, 2 * std::tan(std::asin(0.5 / 3)), share_of_disc);
}

TEST_F(LampEdges, ThePenumbraOfARectangleIsLinear) {
    scene::Light light = lamp_above(scene::LightType::rectangle, {0, 4, 0});
    light.half_size_m = {0.5f, 0.5f};
    expect_profile(light, 1.0 / 3, [](double t) { return std::clamp(0.5 + 0.5 * t, 0.0, 1.0); });
}

// The edge is drawn to the nearest texel, and the filter is two texels wide to each side, so that
// slanted edges have no steps.
TEST_F(LampEdges, APointLightHasASharpEdge) {
    const double texel_m = 2 * 1.1 * 4 / double{kEdgeMapSize};
    constexpr float kStep = 0.0005f;
    const Grid grid{{-kStep * kGrid / 2, 0, -1}, {kStep, 0, 0}, {0, 0, 2.0f / kGrid}};
    const std::vector<float> seen =
        look(ground_under(lamp_above(scene::LightType::point, {0, 4, 0}), 1), grid);
    ASSERT_FALSE(seen.empty());
    for (uint32_t i = 0; i < seen.size(); ++i) {
        const float x = grid.at(i).x;
        if (std::abs(double{x}) > 2.5 * texel_m) {
            ASSERT_EQ(seen[i], x > 0 ? 1 : 0) << "x = " << x;
        }
    }
}

// A plane at angles of up to 80 degrees. In the corner of the grid, a face of the cube ends.
TEST_F(LampEdges, APlaneDoesNotShadowItself) {
    for (const scene::LightType type : {scene::LightType::point, scene::LightType::spot}) {
        scene::Light light = lamp_above(type, {0, 1, 0});
        light.outer_cone_rad = 1.4f;
        const Grid grid{{0, 0, 0}, {4.0f / kGrid, 0, 0}, {0, 0, 4.0f / kGrid}};
        const std::vector<float> seen = look(ground_under(light, 0), grid);
        ASSERT_FALSE(seen.empty());
        for (uint32_t i = 0; i < seen.size(); ++i)
            ASSERT_EQ(seen[i], 1) << grid.at(i).x << ", " << grid.at(i).z;
    }
}

// The offsets are at most as long as the error of a lookup with a filter of one texel, and 0.75 texels. So a
// plate that is farther above the ground casts its whole shadow.
TEST_F(LampEdges, ThinGapsAreDark) {
    const double bound_m = 2 * 1.1 * 4 / double{kEdgeMapSize} * (std::numbers::sqrt2 + 0.75);
    const Grid grid{{-3.5f, 0, -3}, {3.4f / kGrid, 0, 0}, {0, 0, 6.0f / kGrid}};
    const auto gap_m = static_cast<float>(1.1 * bound_m);
    const std::vector<float> seen =
        look(ground_under(lamp_above(scene::LightType::point, {0, 4, 0}), gap_m), grid);
    ASSERT_FALSE(seen.empty());
    for (uint32_t i = 0; i < seen.size(); ++i) ASSERT_EQ(seen[i], 0) << grid.at(i).x << ", " << grid.at(i).z;
}

}  // namespace
}  // namespace weft::test
