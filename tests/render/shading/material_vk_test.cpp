// Tests materials in deferred.json and forward.json against closed forms: how the numbers and texture
// channels of glTF 2.0 and its extensions change the light that a square sends to the camera.
#include <array>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/quad_scene.h"
#include "tests/render/shading/reference_brdf.h"

namespace weft::test {
namespace {

class Materials : public SessionTest, public ::testing::WithParamInterface<const char*> {
 protected:
    [[nodiscard]] static bool deferred() { return std::string_view(GetParam()) == "deferred"; }

    // Renders the scene and returns the radiance of every pixel in cd/m², row by row.
    std::vector<glm::vec4> radiance(const scene::Scene& scene) {
        const std::string graph = std::string(WEFT_SOURCE_DIR "/graphs/") + GetParam() + ".json";
        const std::unique_ptr<render::Session> session =
            start(scene, scene.cameras.at(0), graph, kQuadSize, {"hdr"});
        if (session) frame_of(*session).parameters = kSingleReflections;
        if (!session || !draw_frame(*session) || !session->finish()) {
            ADD_FAILURE() << "no picture";
            return std::vector<glm::vec4>(size_t{kQuadSize.width} * kQuadSize.height);
        }
        const std::vector<vk::ReadbackData> readbacks = session->take_readbacks();
        return render::decode_texels(readbacks.at(0).format, readbacks[0].bytes);
    }
    glm::vec3 center(const scene::Scene& scene) { return radiance(scene)[8 * kQuadSize.width + 8]; }
    // Expects that `found` is root² * scale, within the precision of the pictures. Half floats have 11
    // significant bits. With deferred.json, the G-buffer stores `root` in steps of 1/255, so the error of
    // `root` is up to half a step. `slack` is an additional relative error that the test allows.
    static void expect_near(double found, double root, double scale, const std::string& what,
                            double slack = 0) {
        const double step = deferred() ? 0.5 / 255 : 0;
        const double least = std::pow(std::max(0.0, root - step), 2) * scale;
        const double most = std::pow(root + step, 2) * scale;
        EXPECT_GE(found, least * (1 - slack - 1e-3) - 1e-6) << what;
        EXPECT_LE(found, most * (1 + slack + 1e-3) + 1e-6) << what;
    }
    static uint32_t add_texture(scene::Scene& scene, uint32_t width_px, std::vector<uint8_t> rgba,
                                scene::ColorSpace space = scene::ColorSpace::linear) {
        const auto height_px = static_cast<uint32_t>(rgba.size() / 4 / width_px);
        scene.textures.push_back({"texture", width_px, height_px, space, {std::move(rgba)}});
        return static_cast<uint32_t>(scene.textures.size() - 1);
    }
    // Divides the square into `count` vertical strips of equal width. Each strip has its own copy of the
    // first material.
    static void make_strips(scene::Scene& scene, uint32_t count) {
        scene.materials.resize(count, scene.materials[0]);
        scene.instances.clear();
        const auto n = static_cast<float>(count);
        for (uint32_t i = 0; i < count; ++i) {
            const float x = (2 * static_cast<float>(i) + 1) / n - 1;
            const glm::mat4 moved = glm::translate(glm::mat4(1), glm::vec3(x, 0, 0));
            scene.instances.push_back({"strip", 0, i, glm::scale(moved, glm::vec3(1 / n, 1, 1))});
        }
    }
    static glm::vec3 strip(const std::vector<glm::vec4>& found, size_t i, size_t count) {
        return found[8 * kQuadSize.width + (2 * i + 1) * kQuadSize.width / (2 * count)];
    }
    static scene::TextureSlot nearest(uint32_t texture) {
        scene::TextureSlot slot;
        slot.texture = texture;
        slot.mag = slot.min = scene::Filter::nearest;
        slot.mipmapped = false;
        return slot;
    }
};

INSTANTIATE_TEST_SUITE_P(Graphs, Materials, ::testing::Values("deferred", "forward"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST_P(Materials, VertexColoursAreInterpolatedAndMultiplyTheBaseColour) {
    scene::Scene scene = quad_scene();
    scene.lights = {frontal_light(10)};
    scene.materials[0].base_color = {0.5f, 1, 0.25f, 1};
    // The vertex colours make red increase to the right and green upwards; blue is constant.
    scene.meshes[0].colors = {{0, 0, 0.5f, 1}, {1, 0, 0.5f, 1}, {1, 1, 0.5f, 1}, {0, 1, 0.5f, 1}};
    const std::vector<glm::vec4> found = radiance(scene);
    for (size_t i = 0; i < found.size(); ++i) {
        const glm::vec2 uv = uv_of_pixel(i);
        const glm::vec3 albedo = glm::vec3(scene.materials[0].base_color) * glm::vec3(uv.x, 1 - uv.y, 0.5f);
        for (int c = 0; c < 3; ++c)
            expect_near(found[i][c], std::sqrt(albedo[c]), 10 / kPi,
                        std::to_string(i) + "." + std::to_string(c));
    }
}

TEST_P(Materials, EachMeshHasItsOwnColoursAndUvs) {
    // Three squares side by side. The first mesh has no vertex colours and no second uvs, the second mesh has
    // both, and the third has only second uvs.
    scene::Scene scene = quad_scene();
    const uint32_t texture = add_texture(scene, 2, {255, 255, 255, 255, 0, 0, 0, 255});
    scene.materials[0].emissive = glm::vec3(4);
    scene.materials[0].tinted_emission = true;
    scene.materials[0].emissive_texture = nearest(texture);
    scene.materials[0].emissive_texture.uv_set = 1;
    scene.meshes[0].uvs.assign(4, glm::vec2(0.25f));
    scene.meshes.resize(3, scene.meshes[0]);
    scene.meshes[1].colors.assign(4, {0.5f, 0.25f, 1, 1});
    scene.meshes[1].second_uvs.assign(4, glm::vec2(0.25f));
    scene.meshes[2].second_uvs.assign(4, glm::vec2(0.75f));
    make_strips(scene, 3);
    for (uint32_t i = 0; i < 3; ++i) scene.instances[i].mesh = i;
    const std::vector<glm::vec4> found = radiance(scene);
    EXPECT_EQ(strip(found, 0, 3), glm::vec3(4)) << "first uvs, white";
    EXPECT_LT(glm::length(strip(found, 1, 3) - glm::vec3(2, 1, 4)), 2e-3f) << "its own colours";
    EXPECT_EQ(strip(found, 2, 3), glm::vec3(0)) << "its own second uvs";
}

TEST_P(Materials, ColoursTintOnlyTheEmissionThatAsksForIt) {
    scene::Scene scene = quad_scene();
    scene.materials[0].emissive = {4, 2, 1};
    scene.meshes[0].colors.assign(4, {0.5f, 0, 1, 1});
    make_strips(scene, 2);
    scene.materials[1].tinted_emission = true;
    const std::vector<glm::vec4> found = radiance(scene);
    EXPECT_EQ(strip(found, 0, 2), glm::vec3(4, 2, 1));
    EXPECT_LT(glm::length(strip(found, 1, 2) - glm::vec3(2, 0, 1)), 2e-3f);
}

TEST_P(Materials, EverySlotReadsItsOwnUvSet) {
    // The left texel is white and the right one is black. The first uv set addresses the left texel, the
    // second uv set the right texel.
    scene::Scene scene = quad_scene();
    scene.lights = {frontal_light(10)};
    const uint32_t texture = add_texture(scene, 2, {255, 255, 255, 255, 0, 0, 0, 255});
    scene.meshes[0].uvs.assign(4, {0.25f, 0.5f});
    scene.meshes[0].second_uvs.assign(4, {0.75f, 0.5f});
    make_strips(scene, 4);
    for (uint32_t i = 0; i < 4; ++i) {
        scene::Material& material = scene.materials[i];
        material.emissive = glm::vec3(8);
        material.base_color_texture = material.emissive_texture = nearest(texture);
        material.base_color_texture.uv_set = i % 2;
        material.emissive_texture.uv_set = i / 2;
    }
    const std::vector<glm::vec4> found = radiance(scene);
    for (size_t i = 0; i < 4; ++i) {
        const double expected = (i % 2 == 0 ? 10 / kPi : 0) + (i / 2 == 0 ? 8 : 0);
        EXPECT_NEAR(strip(found, i, 4).r, expected, expected * 1e-3) << i;
    }
}

TEST_P(Materials, ReflectanceFollowsTheIndexOfRefractionAndTheSpecularFactors) {
    struct Case {
        float ior, specular;
        glm::vec3 color;
    };
    const std::vector<Case> cases{{1.5f, 1, glm::vec3(1)},      {1.0f, 1, glm::vec3(1)},
                                  {1.33f, 1, glm::vec3(1)},     {2.42f, 1, glm::vec3(1)},
                                  {1.5f, 0.5f, glm::vec3(1)},   {1.5f, 1, {0.5f, 2, 0}},
                                  {2.0f, 0.5f, {1, 0.25f, 100}}};
    scene::Scene scene = quad_scene();
    scene.lights = {frontal_light(100)};
    scene.materials[0].base_color = {0, 0, 0, 1};
    make_strips(scene, static_cast<uint32_t>(cases.size()));
    for (size_t i = 0; i < cases.size(); ++i) {
        scene.materials[i].ior = cases[i].ior;
        scene.materials[i].specular = cases[i].specular;
        scene.materials[i].specular_color = cases[i].color;
    }
    const std::vector<glm::vec4> found = radiance(scene);
    for (size_t i = 0; i < cases.size(); ++i) {
        const Case& c = cases[i];
        for (int k = 0; k < 3; ++k) {
            const double f0 = std::min(std::pow((c.ior - 1) / (c.ior + 1), 2) * c.color[k], 1.0);
            // At normal incidence, GGX gives D = 1 / (π α²), with α = 1 here, and V = 1/4. The G-buffer
            // stores the specular factor in steps of 1/255.
            expect_near(strip(found, i, cases.size())[k], std::sqrt(f0), c.specular * 100 / (4 * kPi),
                        "ior " + std::to_string(c.ior), deferred() ? 0.5 / 255 / c.specular : 0);
        }
    }
}

TEST_P(Materials, GreenIsRoughnessAndBlueIsMetalness) {
    scene::Scene scene = quad_scene();
    scene.lights = {frontal_light(10)};
    scene.materials[0].base_color = {0.25f, 1, 0, 1};
    scene.materials[0].roughness = 0.8f;
    scene.materials[0].metallic = 1;
    make_strips(scene, 2);
    scene.materials[0].metallic_roughness_texture = nearest(add_texture(scene, 1, {11, 204, 255, 22}));
    scene.materials[1].metallic_roughness_texture = nearest(add_texture(scene, 1, {255, 255, 0, 255}));
    const std::vector<glm::vec4> found = radiance(scene);
    const double alpha = std::pow(0.8 * 204 / 255, 2);
    // A relative error in roughness becomes four times as large in α² = roughness⁴. The G-buffer's error in
    // roughness is half a step of 1/255.
    const double slack = deferred() ? 4 * 0.5 / 255 / std::sqrt(alpha) : 0;
    for (int k = 0; k < 3; ++k)
        expect_near(strip(found, 0, 2)[k], std::sqrt(scene.materials[0].base_color[k]),
                    10 / (4 * kPi * alpha * alpha), std::to_string(k), slack);
    EXPECT_NEAR(strip(found, 1, 2).g, 10 / kPi, 1e-2) << "no metal: Lambert";
}

TEST_P(Materials, OcclusionDarkensOnlyTheAmbientLight) {
    scene::Scene scene = quad_scene();
    scene.sky_zenith = scene.sky_horizon = glm::vec3(2);
    // The texture has 51/255 in its red channel, so the occlusion factor is a fifth.
    scene.materials[0].occlusion_texture = nearest(add_texture(scene, 1, {51, 255, 255, 255}));
    make_strips(scene, 3);
    scene.materials[1].occlusion_strength = 0.5f;
    scene.materials[2].occlusion_strength = 0;
    const std::vector<glm::vec4> ambient = radiance(scene);
    const float open = strip(ambient, 2, 3).r;
    EXPECT_GT(open, 0.5f);
    EXPECT_NEAR(strip(ambient, 0, 3).r, open * 0.2, open * 3e-3);
    EXPECT_NEAR(strip(ambient, 1, 3).r, open * 0.6, open * 3e-3);
    scene.sky_zenith = scene.sky_horizon = glm::vec3(0);
    scene.lights = {frontal_light(10)};
    scene.materials[0].emissive = glm::vec3(1);
    EXPECT_NEAR(strip(radiance(scene), 0, 3).r, 1 + 10 / kPi, 5e-3) << "neither lights nor emission";
}

TEST_P(Materials, NormalMapsTiltTowardsUAndUp) {
    scene::Scene scene = quad_scene();
    scene.materials[0].normal_texture =
        // The texel encodes a normal that points to the right, down, and out of the surface.
        nearest(add_texture(scene, 1, {191, 85, 230, 255}));
    constexpr std::array kScales{1.0f, 0.4f, -1.0f};
    make_strips(scene, 3);
    for (size_t i = 0; i < 3; ++i) scene.materials[i].normal_scale = kScales[i];
    const glm::dvec3 texel(191 / 255.0 * 2 - 1, 85 / 255.0 * 2 - 1, 230 / 255.0 * 2 - 1);
    for (const glm::dvec3 from : {glm::dvec3(0.6, 0, 0.8), glm::dvec3(0, 0.6, 0.8)}) {
        scene.lights = {frontal_light(10)};
        scene.lights[0].direction = -from;
        const std::vector<glm::vec4> found = radiance(scene);
        for (size_t i = 0; i < 3; ++i) {
            const double scale = kScales[i];
            const glm::dvec3 n = glm::normalize(glm::dvec3(texel.x * scale, texel.y * scale, texel.z));
            EXPECT_NEAR(strip(found, i, 3).r, 10 / kPi * std::max(0.0, glm::dot(n, from)), 5e-3)
                << scale << " from " << from.x << " " << from.y;
        }
    }
}

TEST_P(Materials, AlphaAtTheCutoffIsDrawn) {
    scene::Scene scene = quad_scene();
    scene.materials[0].emissive = glm::vec3(1);
    scene.materials[0].alpha_mode = scene::AlphaMode::mask;
    scene.materials[0].base_color.a = 0.5f;
    make_strips(scene, 5);
    scene.materials[0].alpha_cutoff = 0.5f;
    scene.materials[1].alpha_cutoff = std::nextafter(0.5f, 1.0f);
    scene.materials[2].alpha_cutoff = 0;
    // The alpha of vertex colours multiplies the alpha of the material. An opaque material ignores alpha.
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes[1].colors.assign(4, {1, 1, 1, 0.75f});
    scene.instances[3].mesh = scene.instances[4].mesh = 1;
    scene.materials[3].alpha_cutoff = 0.5f;
    scene.materials[4].alpha_mode = scene::AlphaMode::opaque;
    const std::vector<glm::vec4> found = radiance(scene);
    constexpr std::array kDrawn{1, 0, 1, 0, 1};
    for (size_t i = 0; i < 5; ++i) EXPECT_EQ(strip(found, i, 5).r, kDrawn[i]) << i;
}

TEST_P(Materials, MirroredObjectsKeepTheirOutside) {
    struct Case {
        glm::vec3 scale;
        bool double_sided, lit;
    };
    // The back of a single-sided surface is not drawn. The back of a double-sided surface is lit by light
    // from its own side.
    const std::vector<Case> cases{{{-1, 1, 1}, false, true},  {{-1, -1, 1}, false, true},
                                  {{1, 1, -1}, false, false}, {{-1, 1, -1}, false, false},
                                  {{1, 1, -1}, true, true},   {{-1, 1, -1}, true, true}};
    scene::Scene scene = quad_scene();
    scene.lights = {frontal_light(10)};
    make_strips(scene, static_cast<uint32_t>(cases.size()));
    for (size_t i = 0; i < cases.size(); ++i) {
        scene.materials[i].double_sided = cases[i].double_sided;
        scene.instances[i].transform *= glm::scale(glm::mat4(1), cases[i].scale);
    }
    const std::vector<glm::vec4> found = radiance(scene);
    for (size_t i = 0; i < cases.size(); ++i)
        EXPECT_NEAR(strip(found, i, cases.size()).r, cases[i].lit ? 10 / kPi : 0, 5e-3) << i;
}

TEST_P(Materials, PointLightsEndAtTheirRange) {
    // Formula of KHR_lights_punctual for the distance d: max(min(1 − (d/range)⁴, 1), 0) / d².
    scene::Scene scene = quad_scene();
    scene.meshes[0].positions = {{-100, -100, 0}, {100, -100, 0}, {100, 100, 0}, {-100, 100, 0}};
    for (const float range_m : {0.0f, 2.5f, 2.0f}) {
        scene::Light light;
        light.intensity = 40;
        // The light is 2 m in front of the middle of the measured pixel.
        light.position = {1.0f / 16, -1.0f / 16, 2};
        light.range_m = range_m;
        scene.lights = {light};
        const double window = range_m > 0 ? std::clamp(1 - std::pow(2 / range_m, 4), 0.0, 1.0) : 1;
        EXPECT_NEAR(center(scene).r, 40 / kPi / 4 * window, 2e-2) << range_m;
    }
}

TEST_P(Materials, SpotLightsFadeBetweenTheirCones) {
    // Formula of KHR_lights_punctual for the angle a to the axis: (saturate(cos a · s − cos outer · s))²,
    // with s = 1 / max(0.001, cos inner − cos outer).
    scene::Scene scene = quad_scene();
    for (const double angle : {0.25, 0.4, 0.65}) {
        scene::Light light;
        light.type = scene::LightType::spot;
        light.intensity = 40;
        light.position = {1.0f / 16, -1.0f / 16, 2};
        light.direction = {std::sin(angle), 0, -std::cos(angle)};
        light.inner_cone_rad = 0.3f;
        light.outer_cone_rad = 0.6f;
        scene.lights = {light};
        const double fade = std::clamp(
            (std::cos(angle) - std::cos(0.6)) / std::max(0.001, std::cos(0.3) - std::cos(0.6)), 0.0, 1.0);
        EXPECT_NEAR(center(scene).r, 40 / kPi / 4 * fade * fade, 2e-2) << angle;
    }
}

TEST_P(Materials, UnlitIsTheBaseColourWhateverShines) {
    // A material with KHR_materials_unlit is loaded as a black surface that emits its base colour.
    scene::Scene scene = quad_scene();
    scene.lights = {frontal_light(1000)};
    scene.sky_zenith = scene.sky_horizon = glm::vec3(5);
    scene::Material& material = scene.materials[0];
    material.base_color = {0, 0, 0, 1};
    material.emissive = {0.5f, 0.25f, 0.125f};
    material.tinted_emission = true;
    material.emissive_texture = nearest(add_texture(scene, 1, {255, 0, 255, 255}, scene::ColorSpace::srgb));
    EXPECT_EQ(center(scene), glm::vec3(0.5f, 0, 0.125f));
}

}  // namespace
}  // namespace weft::test
