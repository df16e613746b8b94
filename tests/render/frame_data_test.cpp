// Tests how views, lights and instances are converted to the form that shaders read.
#include "render/frame_data.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>

#include "weft/render/import_catalog.h"
#include "weft/render/texels.h"
#include "weft/scene/environment.h"

namespace weft::render {
namespace {

TEST(FrameData, DepthIsOneAtTheNearPlaneAndZeroAtInfinity) {
    const glm::mat4 p = reversed_infinite_projection(1.0f, 1.5f, 0.1f);
    const glm::vec4 close = p * glm::vec4(0, 0, -0.1f, 1), away = p * glm::vec4(0, 0, -1e6f, 1);
    EXPECT_FLOAT_EQ(close.z / close.w, 1);
    EXPECT_NEAR(away.z / away.w, 0, 1e-6f);
    EXPECT_LT((p * glm::vec4(0, 1, -1, 1)).y, 0) << "up is towards row 0";
}

TEST(FrameData, TheInverseTakesPixelsBackToTheWorld) {
    scene::Camera camera;
    camera.transform = glm::inverse(glm::lookAt(glm::vec3(3, 2, 5), glm::vec3(0, 1, 0), glm::vec3(0, 1, 0)));
    const shared::ViewConstants view = view_constants(camera, glm::mat4(1), 640, 360);
    const glm::vec4 world(0.5f, 0.25f, -1, 1);
    const glm::vec4 clip = view.view_projection * world;
    const glm::vec4 back = view.inverse_view_projection * (clip / clip.w);
    EXPECT_NEAR(glm::distance(glm::vec3(back) / back.w, glm::vec3(world)), 0, 1e-4f);
    EXPECT_NEAR(glm::distance(view.eye, glm::vec3(3, 2, 5)), 0, 1e-5f);
}

TEST(FrameData, DirectionalLightsComeFirstAndDarkOnesNot) {
    std::vector<scene::Light> in_scene(4);
    in_scene[1].intensity = 0;
    in_scene[3].type = scene::LightType::directional;
    const std::vector<shared::Light> lights = gpu_lights(in_scene, 0);
    ASSERT_EQ(lights.size(), 3u);
    EXPECT_EQ(lights[0].type, shared::kLightDirectional);
    EXPECT_EQ(lights[1].type, shared::kLightPoint);
}

TEST(FrameData, LightsAreWhereTheirPathsHaveLedThem) {
    scene::Light light;
    light.position = {1, 2, 3};
    light.path.across = {4, 0, 0};
    light.path.along = {0, 0, 5};
    light.path.turns_per_s = 0.25f;
    const std::vector<scene::Light> in_scene{light};
    EXPECT_NEAR(glm::distance(gpu_lights(in_scene, 0)[0].position, glm::vec3(5, 2, 3)), 0, 1e-5f);
    EXPECT_NEAR(glm::distance(gpu_lights(in_scene, 1)[0].position, glm::vec3(1, 2, 8)), 0, 1e-5f);
    EXPECT_NEAR(glm::distance(gpu_lights(in_scene, 4000002)[0].position, glm::vec3(-3, 2, 3)), 0, 1e-5f);
}

TEST(FrameData, SpotConesAreFullInsideAndDarkOutside) {
    scene::Light light;
    light.type = scene::LightType::spot;
    light.inner_cone_rad = 0.2f;
    light.outer_cone_rad = 0.5f;
    const shared::Light gpu = gpu_light(light);
    EXPECT_NEAR(std::cos(0.2f) * gpu.cone_scale + gpu.cone_offset, 1, 1e-5f);
    EXPECT_NEAR(std::cos(0.5f) * gpu.cone_scale + gpu.cone_offset, 0, 1e-5f);
}

TEST(FrameData, NormalsStayPerpendicularAndOutside) {
    const glm::mat4 mirrored = glm::scale(glm::mat4(1), glm::vec3(-2, 1, 0.5f));
    const shared::Instance instance = gpu_instance(mirrored);
    const glm::vec3 n = glm::normalize(glm::mat3(instance.normal_to_world) * glm::vec3(1, 1, 0));
    const glm::vec3 along = glm::mat3(mirrored) * glm::vec3(1, -1, 0);
    EXPECT_NEAR(glm::dot(n, along), 0, 1e-6f);
    EXPECT_LT(n.x, 0) << "the mirrored face looks the other way";
    EXPECT_GT(n.y, 0);
}

TEST(FrameData, DielectricReflectanceFollowsTheIndexOfRefraction) {
    scene::Material material;
    EXPECT_NEAR(gpu_material(material).dielectric_f0.x, 0.04f, 1e-6f);
    material.ior = 1.33f;
    EXPECT_NEAR(gpu_material(material).dielectric_f0.x, 0.02006f, 1e-5f);
}

template <class T>
std::vector<std::byte> bytes_of(std::initializer_list<T> values) {
    std::vector<std::byte> bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.begin(), bytes.size());
    return bytes;
}

TEST(Texels, EveryKindOfChannel) {
    EXPECT_EQ(decode_texels(Format::rgba8, bytes_of<uint8_t>({255, 0, 51, 255}))[0],
              glm::vec4(1, 0, 0.2f, 1));
    EXPECT_NEAR(decode_texels(Format::rgba8_srgb, bytes_of<uint8_t>({188, 0, 0, 255}))[0].r, 0.5029f, 1e-4f);
    EXPECT_EQ(decode_texels(Format::bgra8, bytes_of<uint8_t>({255, 0, 0, 255}))[0], glm::vec4(0, 0, 1, 1));
    EXPECT_EQ(decode_texels(Format::rg16_snorm, bytes_of<int16_t>({-32767, 32767}))[0],
              glm::vec4(-1, 1, 0, 1));
    EXPECT_EQ(decode_texels(Format::rg16f, bytes_of<uint16_t>({0x3C00, 0xC000}))[0], glm::vec4(1, -2, 0, 1));
    EXPECT_EQ(decode_texels(Format::r32u, bytes_of<uint32_t>({7}))[0], glm::vec4(7, 0, 0, 1));
    EXPECT_EQ(decode_texels(Format::r32i, bytes_of<int32_t>({-7}))[0], glm::vec4(-7, 0, 0, 1));
    EXPECT_EQ(decode_texels(Format::d32f, bytes_of<float>({0.25f}))[0], glm::vec4(0.25f, 0, 0, 1));
    EXPECT_EQ(decode_texels(Format::d16, bytes_of<uint16_t>({65535}))[0], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(decode_texels(Format::rgb10a2, bytes_of<uint32_t>({0x3FFu | 3u << 30}))[0],
              glm::vec4(1, 0, 0, 1));
    // The values 1, 0.5 and 2 as small floats of 11, 11 and 10 bits.
    const uint32_t one_half_two = 0x3C0u | (0x380u << 11) | (0x200u << 22);
    EXPECT_EQ(decode_texels(Format::b10g11r11f, bytes_of<uint32_t>({one_half_two}))[0],
              glm::vec4(1, .5f, 2, 1));
}

TEST(ImportCatalog, OffersWhatTheShippedGraphsUse) {
    const ImportCatalog catalog = scene_imports({640, 360, 1});
    EXPECT_EQ(catalog.imports.at("opaque").kind, ImportKind::draw_list);
    EXPECT_EQ(catalog.imports.at("backbuffer").resource.extent, (Extent3D{640, 360, 1}));
    EXPECT_EQ(catalog.strides.at("Light"), 80u);
}

TEST(ImportCatalog, ListsAndTheirCommandsAreAsLongAsTheSceneMakesThem) {
    scene::Scene scene;
    scene.materials.resize(2);
    scene.materials[1].alpha_mode = scene::AlphaMode::mask;
    for (const uint32_t material : {0u, 1u, 0u, 0u})
        scene.instances.push_back({"", 0, material, glm::mat4(1)});
    const ImportCatalog catalog = scene_imports({640, 360, 1}, &scene);
    EXPECT_EQ(catalog.imports.at("opaque").draws, 3u);
    EXPECT_EQ(catalog.imports.at("masked").draws, 1u);
    EXPECT_EQ(catalog.imports.at("transparent").draws, 0u);
    EXPECT_EQ(catalog.strides.at("DrawCommand"), 20u);
    EXPECT_EQ(catalog.imports.at("opaqueCommands").kind, ImportKind::buffer);
    EXPECT_EQ(catalog.imports.at("opaqueCommands").resource.size_bytes, 60u);
    EXPECT_EQ(catalog.imports.at("transparentCommands").resource.size_bytes, 20u) << "no buffer is empty";
}

TEST(ImportCatalog, CountsTheEnvironmentPicturesThatShowAnything) {
    scene::Scene scene;
    EXPECT_EQ(scene_imports({64, 36, 1}, &scene).numbers.at("environmentPictures"), 0);
    scene.environment = scene::build_environment(2, 1, std::array{glm::vec3(1), glm::vec3(2)});
    EXPECT_EQ(scene_imports({64, 36, 1}, &scene).numbers.at("environmentPictures"), 1);
    scene.environment.scale = 0;
    EXPECT_EQ(scene_imports({64, 36, 1}, &scene).numbers.at("environmentPictures"), 0);
}

}  // namespace
}  // namespace weft::render
