#include "tests/scene/export/round_trip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace weft::scene::test {
namespace {

// The loader normalises normals and tangents, and rotations of textures pass through angles.
constexpr float kTolerance = 1e-5f;

template <class Vector>
void expect_close(const Vector& a, const Vector& b, const std::string& what) {
    for (int i = 0; i < Vector::length(); ++i)
        EXPECT_NEAR(a[i], b[i], kTolerance * std::max(1.0f, std::abs(a[i]))) << what << " " << i;
}

void expect_close(float a, float b, const std::string& what) {
    EXPECT_NEAR(a, b, kTolerance * std::max(1.0f, std::abs(a))) << what;
}

// Expects the same values at the corners of all triangles. The loader drops vertices that no triangle uses,
// so the vertices can have other indices. Returns after the first difference, because a mesh can have many.
template <class Vector>
void expect_corners(const Mesh& a, const Mesh& b, std::vector<Vector> Mesh::*list, const std::string& what) {
    ASSERT_EQ((a.*list).empty(), (b.*list).empty()) << a.name << ": " << what;
    if ((a.*list).empty()) return;
    for (size_t corner = 0; corner < a.indices.size() && !testing::Test::HasFailure(); ++corner)
        expect_close((a.*list)[a.indices[corner]], (b.*list)[b.indices[corner]],
                     a.name + ": " + what + " of corner " + std::to_string(corner));
}

void expect_mesh(const Mesh& a, const Mesh& b, bool reads_second_uvs) {
    EXPECT_EQ(a.name, b.name);
    ASSERT_EQ(a.indices.size(), b.indices.size()) << a.name;
    expect_corners(a, b, &Mesh::positions, "position");
    expect_corners(a, b, &Mesh::normals, "normal");
    expect_corners(a, b, &Mesh::tangents, "tangent");
    expect_corners(a, b, &Mesh::uvs, "uv");
    expect_corners(a, b, &Mesh::colors, "colour");
    if (reads_second_uvs) expect_corners(a, b, &Mesh::second_uvs, "second uv");
}

void expect_texture(const Texture& a, const Texture& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.color_space, b.color_space) << a.name;
    EXPECT_EQ(a.mips.front(), b.mips.front()) << a.name;
    EXPECT_EQ(a.mips.size(), b.mips.size()) << a.name;
}

struct Pair {
    const Scene& written;
    const Scene& loaded;
};

void expect_slot(const TextureSlot& a, const TextureSlot& b, const Pair& scenes, const std::string& what) {
    ASSERT_EQ(a.texture == kNone, b.texture == kNone) << what;
    if (a.texture == kNone) return;
    expect_texture(scenes.written.textures[a.texture], scenes.loaded.textures[b.texture]);
    EXPECT_EQ(a.mag, b.mag) << what;
    EXPECT_EQ(a.min, b.min) << what;
    EXPECT_EQ(a.mipmapped, b.mipmapped) << what;
    EXPECT_EQ(a.wrap_u, b.wrap_u) << what;
    EXPECT_EQ(a.wrap_v, b.wrap_v) << what;
    EXPECT_EQ(a.uv_set, b.uv_set) << what;
    for (int column = 0; column < 3; ++column) expect_close(a.transform[column], b.transform[column], what);
}

void expect_textures(const Material& a, const Material& b, const Pair& scenes) {
    expect_slot(a.base_color_texture, b.base_color_texture, scenes, a.name + ": base colour");
    expect_slot(a.metallic_roughness_texture, b.metallic_roughness_texture, scenes, a.name + ": roughness");
    expect_slot(a.normal_texture, b.normal_texture, scenes, a.name + ": normal map");
    expect_slot(a.occlusion_texture, b.occlusion_texture, scenes, a.name + ": occlusion");
    expect_slot(a.emissive_texture, b.emissive_texture, scenes, a.name + ": emission");
    expect_slot(a.anisotropy_texture, b.anisotropy_texture, scenes, a.name + ": anisotropy");
}

void expect_material(const Material& a, const Material& b, const Pair& scenes) {
    EXPECT_EQ(a.name, b.name);
    expect_close(a.base_color, b.base_color, a.name + ": base colour");
    expect_close(a.metallic, b.metallic, a.name + ": metalness");
    expect_close(a.roughness, b.roughness, a.name + ": roughness");
    expect_close(a.emissive, b.emissive, a.name + ": emission");
    EXPECT_EQ(a.tinted_emission, b.tinted_emission) << a.name;
    if (a.normal_texture.texture != kNone) expect_close(a.normal_scale, b.normal_scale, a.name + ": scale");
    if (a.occlusion_texture.texture != kNone)
        expect_close(a.occlusion_strength, b.occlusion_strength, a.name + ": strength");
    expect_close(a.specular, b.specular, a.name + ": specular");
    expect_close(a.specular_color, b.specular_color, a.name + ": specular colour");
    expect_close(a.ior, b.ior, a.name + ": ior");
    EXPECT_EQ(a.alpha_mode, b.alpha_mode) << a.name;
    expect_close(a.alpha_cutoff, b.alpha_cutoff, a.name + ": cutoff");
    EXPECT_EQ(a.double_sided, b.double_sided) << a.name;
    expect_close(a.anisotropy, b.anisotropy, a.name + ": anisotropy");
    if (a.anisotropy > 0)
        expect_close(a.anisotropy_rotation_rad, b.anisotropy_rotation_rad, a.name + ": rotation");
    expect_close(a.clearcoat, b.clearcoat, a.name + ": clearcoat");
    expect_close(a.clearcoat_roughness, b.clearcoat_roughness, a.name + ": clearcoat roughness");
    expect_close(a.transmission, b.transmission, a.name + ": transmission");
    expect_close(a.thickness_m, b.thickness_m, a.name + ": thickness");
    expect_close(a.absorption_per_m, b.absorption_per_m, a.name + ": absorption");
    expect_close(a.ripples, b.ripples, a.name + ": ripples");
    expect_close(a.diffuse_transmission, b.diffuse_transmission, a.name + ": diffuse transmission");
    expect_close(a.diffuse_transmission_color, b.diffuse_transmission_color, a.name + ": transmitted colour");
    expect_close(a.diffuse_roughness_rad, b.diffuse_roughness_rad, a.name + ": diffuse roughness");
    expect_textures(a, b, scenes);
}

void expect_function(const Light& a, const Light& b, const Pair& scenes) {
    ASSERT_EQ(a.function == kNone, b.function == kNone) << a.name;
    if (a.function == kNone) return;
    const LightFunction& from = scenes.written.light_functions[a.function];
    const LightFunction& to = scenes.loaded.light_functions[b.function];
    EXPECT_EQ(from.parallel, to.parallel) << a.name;
    // A door beyond a right angle blocks nothing. The file has the right angle.
    const float widest = from.parallel ? 1e6f : 1.5707963f;
    expect_close(glm::min(from.doors, glm::vec4(widest)), glm::min(to.doors, glm::vec4(widest)), "doors");
    expect_close(from.softness, to.softness, a.name + ": softness");
    expect_close(from.curve, to.curve, a.name + ": curve");
    ASSERT_EQ(from.picture == kNone, to.picture == kNone) << a.name;
    if (from.picture == kNone) return;
    expect_texture(scenes.written.textures[from.picture], scenes.loaded.textures[to.picture]);
    expect_close(from.picture_half_size, to.picture_half_size, a.name + ": half size");
}

void expect_light(const Light& a, const Light& b, const Pair& scenes) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.type, b.type) << a.name;
    expect_close(a.color * a.intensity, b.color * b.intensity, a.name + ": intensity");
    expect_close(position_at(a, 0), position_at(b, 0), a.name + ": position");
    expect_close(a.direction, b.direction, a.name + ": direction");
    expect_close(a.range_m, b.range_m, a.name + ": range");
    if (a.side != glm::vec3(0)) expect_close(a.side, b.side, a.name + ": side");
    expect_close(a.half_size_m, b.half_size_m, a.name + ": half size");
    if (a.type == LightType::spot) {
        expect_close(a.inner_cone_rad, b.inner_cone_rad, a.name + ": inner cone");
        expect_close(a.outer_cone_rad, b.outer_cone_rad, a.name + ": outer cone");
    }
    expect_function(a, b, scenes);
}

void expect_camera(const Camera& a, const Camera& b) {
    EXPECT_EQ(a.name, b.name);
    for (int column = 0; column < 4; ++column)
        expect_close(a.transform[column], b.transform[column], a.name + ": transform");
    expect_close(a.fov_y_rad, b.fov_y_rad, a.name + ": field of view");
    expect_close(a.near_m, b.near_m, a.name + ": near plane");
}

bool reads_second_uvs(const Material& m) {
    for (const TextureSlot* slot : {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture,
                                    &m.occlusion_texture, &m.emissive_texture, &m.anisotropy_texture})
        if (slot->texture != kNone && slot->uv_set == 1) return true;
    return false;
}

void expect_instance(const Instance& a, const Instance& b, const Pair& scenes) {
    EXPECT_EQ(a.name, b.name);
    for (int column = 0; column < 4; ++column)
        expect_close(a.transform[column], b.transform[column], a.name + ": transform");
    const Material& material = scenes.written.materials[a.material];
    expect_material(material, scenes.loaded.materials[b.material], scenes);
    expect_mesh(scenes.written.meshes[a.mesh], scenes.loaded.meshes[b.mesh], reads_second_uvs(material));
}

}  // namespace

void expect_same_scene(const Scene& written, const Scene& loaded) {
    const Pair scenes{written, loaded};
    EXPECT_EQ(written.name, loaded.name);
    ASSERT_EQ(written.instances.size(), loaded.instances.size());
    for (size_t i = 0; i < written.instances.size() && !testing::Test::HasFailure(); ++i)
        expect_instance(written.instances[i], loaded.instances[i], scenes);
    ASSERT_EQ(written.lights.size(), loaded.lights.size());
    for (size_t i = 0; i < written.lights.size() && !testing::Test::HasFailure(); ++i)
        expect_light(written.lights[i], loaded.lights[i], scenes);
    ASSERT_EQ(written.cameras.size(), loaded.cameras.size());
    for (size_t i = 0; i < written.cameras.size(); ++i) expect_camera(written.cameras[i], loaded.cameras[i]);
    expect_close(written.bounds.min, loaded.bounds.min, "bounds");
    expect_close(written.bounds.max, loaded.bounds.max, "bounds");
}

}  // namespace weft::scene::test
