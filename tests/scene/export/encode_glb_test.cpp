// Purpose: writes scenes as glTF files, loads the files, and expects the same scenes.
#include "weft/scene/encode_glb.h"

#include "scene/model/sky_gradient.h"
#include "scene/pictures/radiance_picture.h"
#include "tests/scene/export/round_trip.h"
#include "tests/scene/gltf/gltf_fixture.h"
#include "weft/scene/builtin_scenes.h"

namespace weft::scene::test {
namespace {

class EncodeGlb : public GltfTest {
 protected:
    // Writes the scene and loads it again. Every warning makes the test fail.
    Scene written_and_loaded(const Scene& scene) {
        const Result<std::string> file = encode_glb(scene);
        EXPECT_TRUE(file.ok());
        if (!file) return {};
        write("scene.glb", *file);
        warnings_.clear();
        Scene loaded = load_file("scene.glb");
        for (const Diagnostic& warning : warnings_) ADD_FAILURE() << warning.code << " " << warning.message;
        return loaded;
    }
    void expect_round_trip(const Scene& scene) { expect_same_scene(scene, written_and_loaded(scene)); }
};

class EncodeBuiltin : public EncodeGlb, public testing::WithParamInterface<std::string> {};

TEST_P(EncodeBuiltin, LoadsTheSameScene) {
    const Result<Scene> scene = make_builtin(GetParam());
    ASSERT_TRUE(scene.ok());
    expect_round_trip(*scene);
}

INSTANTIATE_TEST_SUITE_P(All, EncodeBuiltin, testing::ValuesIn(builtin_scene_names()),
                         [](const auto& tested) { return tested.param; });

TEST_F(EncodeGlb, LoadsTheSameSceneAsFromAFile) {
    for (const char* name : {"fuzz/corpus/gltf/textured.gltf", "reference/scenes/diorama.gltf"}) {
        const Result<Scene> scene = load_gltf(std::string(WEFT_SOURCE_DIR "/tests/") + name, warnings_);
        ASSERT_TRUE(scene.ok()) << name;
        expect_round_trip(*scene);
    }
}

// A glTF file must not have an empty buffer.
TEST_F(EncodeGlb, WritesASceneWithoutMeshes) {
    Scene scene;
    scene.name = "lamp";
    scene.lights.emplace_back();
    scene.lights.back().name = "lamp";
    const Result<std::string> file = encode_glb(scene);
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(file->find("\"buffers\""), std::string::npos);
}

// A scene of one triangle with one material. All streams of the mesh have values.
Scene triangle_scene(Material material) {
    Scene scene;
    scene.name = "triangle";
    Mesh mesh;
    mesh.name = "triangle";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.tangents.assign(3, {1, 0, 0, -1});
    mesh.uvs = {{0, 1}, {1, 1}, {0, 0}};
    mesh.second_uvs = {{0.5f, 1}, {1, 0.5f}, {0, 0.25f}};
    mesh.colors = {{1, 0.5f, 0.25f, 0.5f}, {1, 1, 1, 1}, {0, 0, 1, 0.25f}};
    mesh.indices = {0, 1, 2};
    mesh.bounds = {{0, 0, 0}, {1, 1, 0}};
    scene.meshes.push_back(mesh);
    scene.textures.push_back({"picture", 1, 1, ColorSpace::linear, {{10, 20, 30, 40}}});
    material.name = "material";
    scene.materials.push_back(std::move(material));
    glm::mat4 turned(1);
    turned[0] = {0, 0, -2, 0};
    turned[2] = {3, 0, 0, 0};
    turned[3] = {4, 5, 6, 1};
    scene.instances.push_back({"turned", 0, 0, turned});
    scene.bounds = world_bounds(scene);
    return scene;
}

TEST_F(EncodeGlb, KeepsEveryFieldOfAGlossyMaterial) {
    Material material;
    material.base_color = {0.1f, 0.2f, 0.3f, 0.4f};
    material.metallic = 0.25f;
    material.roughness = 0.75f;
    material.emissive = {4000, 20, 0.5f};
    material.normal_scale = 0.5f;
    material.specular = 0.5f;
    material.specular_color = {1, 0.5f, 2};
    material.ior = 1.8f;
    material.alpha_mode = AlphaMode::mask;
    material.alpha_cutoff = 0.3f;
    material.double_sided = true;
    material.anisotropy = 0.6f;
    material.anisotropy_rotation_rad = -0.5f;
    material.clearcoat = 0.7f;
    material.clearcoat_roughness = 0.2f;
    material.diffuse_transmission = 0.6f;
    material.diffuse_transmission_color = {0.9f, 0.5f, 0.3f};
    material.diffuse_roughness_rad = 0.3f;
    TextureSlot slot{0, Filter::nearest, Filter::nearest, false, Wrap::clamp_to_edge, Wrap::mirrored_repeat};
    slot.uv_set = 1;
    material.normal_texture = slot;
    slot.transform = {0, -2, 3, 0, 0.25f, 0.5f};
    material.anisotropy_texture = slot;
    expect_round_trip(triangle_scene(material));
}

TEST_F(EncodeGlb, KeepsWater) {
    Material material;
    material.alpha_mode = AlphaMode::blend;
    material.transmission = 0.9f;
    material.thickness_m = 2;
    material.absorption_per_m = {1.2f, 0.3f, 0};
    material.ripples = {0.011f, 0.006f, -0.008f, 0.012f};
    material.ior = 1.33f;
    expect_round_trip(triangle_scene(material));
    material.base_color.a = 0.5f;
    expect_round_trip(triangle_scene(material));
}

TEST_F(EncodeGlb, KeepsAnUnlitMaterial) {
    Material material;
    material.base_color = {0, 0, 0, 0.5f};
    material.metallic = material.specular = 0;
    material.emissive = {0.1f, 0.2f, 0.3f};
    material.tinted_emission = true;
    material.alpha_mode = AlphaMode::blend;
    expect_round_trip(triangle_scene(material));
}

TEST_F(EncodeGlb, WritesAMeshWithTwoMaterialsOnce) {
    Scene scene = triangle_scene({});
    const size_t bytes = encode_glb(scene)->size();
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].name = "other";
    scene.materials[1].roughness = 0.5f;
    scene.instances.push_back({"other", 0, 1});
    scene.bounds = world_bounds(scene);
    expect_round_trip(scene);
    EXPECT_LT(encode_glb(scene)->size(), bytes + 600);
}

// Returns the texels of a Radiance picture of this size.
std::vector<glm::vec3> decoded(const std::string& file, uint32_t width_px, uint32_t height_px) {
    const std::span bytes(reinterpret_cast<const uint8_t*>(file.data()), file.size());
    const RadianceHeader header = read_radiance_header(bytes);
    EXPECT_EQ(header.error, "");
    EXPECT_EQ(header.width_px, width_px);
    EXPECT_EQ(header.height_px, height_px);
    return decode_radiance(header, bytes).texels;
}

TEST(EncodeSky, TheGradientIsThatOfTheShader) {
    Scene scene;
    EXPECT_FALSE(has_sky(scene));
    scene.sky_zenith = {100, 200, 2700};
    scene.sky_horizon = {2100, 2600, 3100};
    EXPECT_TRUE(has_sky(scene));
    const std::vector<glm::vec3> texels = decoded(encode_sky(scene), 1024, 512);
    ASSERT_EQ(texels.size(), 1024u * 512);
    const auto texel = [&](uint32_t row) { return texels[size_t{row} * 1024 + 7]; };
    const auto expect_texel = [&](uint32_t row, const glm::vec3& wanted) {
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(texel(row)[c], wanted[c], 3100.0f / 256) << row;
    };
    expect_texel(0, scene.sky_zenith);
    expect_texel(511, scene.sky_horizon * 0.25f);
    // Row 170 is 30° above the horizon: the sine is 0.5.
    expect_texel(170, glm::mix(scene.sky_horizon, scene.sky_zenith, std::sqrt(0.5f)));
}

TEST(EncodeSky, AnEnvironmentPictureKeepsItsTexels) {
    Scene scene;
    std::vector<glm::vec3> radiance(8 * 4, glm::vec3(2, 4, 8));
    radiance[3] = {500, 250, 125};
    scene.environment = build_environment(8, 4, radiance);
    const std::vector<glm::vec3> texels = decoded(encode_sky(scene), 8, 4);
    ASSERT_EQ(texels.size(), radiance.size());
    for (size_t i = 0; i < texels.size(); ++i)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(texels[i][c], radiance[i][c], radiance[i].x / 64) << i;
}

}  // namespace
}  // namespace weft::scene::test
