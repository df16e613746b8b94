// Purpose: tests every built-in scene: valid meshes, complete textures, and the same result on every run.
#include "weft/scene/builtin_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "weft/scene/scene.h"

namespace weft::scene {
namespace {

Scene make(const std::string& name) {
    Result<Scene> scene = make_builtin(name);
    EXPECT_TRUE(scene.ok()) << name;
    return std::move(scene).value();
}

// Computes the FNV-1a hash of bytes. digest_of() adds the meshes, textures, transforms and light positions.
class Digest {
 public:
    void add(const void* data, size_t size_bytes) {
        const auto* bytes = static_cast<const uint8_t*>(data);
        for (size_t i = 0; i < size_bytes; ++i) hash_ = (hash_ ^ bytes[i]) * 1099511628211ULL;
    }
    template <class T>
    void add(const std::vector<T>& items) {
        add(items.data(), items.size() * sizeof(T));
    }
    [[nodiscard]] uint64_t value() const { return hash_; }

 private:
    uint64_t hash_ = 14695981039346656037ULL;
};

uint64_t digest_of(const Scene& scene) {
    Digest digest;
    for (const Mesh& mesh : scene.meshes) {
        digest.add(mesh.positions);
        digest.add(mesh.normals);
        digest.add(mesh.tangents);
        digest.add(mesh.uvs);
        digest.add(mesh.indices);
    }
    for (const Texture& texture : scene.textures) {
        for (const std::vector<uint8_t>& mip : texture.mips) digest.add(mip);
    }
    for (const Instance& instance : scene.instances)
        digest.add(&instance.transform, sizeof(instance.transform));
    for (const Light& light : scene.lights) digest.add(&light.position, sizeof(light.position));
    for (const Camera& camera : scene.cameras) digest.add(&camera.transform, sizeof(camera.transform));
    return digest.value();
}

struct TriangleCounts {
    size_t total = 0;
    size_t degenerate = 0;
    size_t facing_away = 0;  // Number of triangles that face away from their vertex normals.
};

void count_triangles(const Mesh& mesh, TriangleCounts& counts) {
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::array<uint32_t, 3> corner{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
        const glm::vec3 area = glm::cross(mesh.positions[corner[1]] - mesh.positions[corner[0]],
                                          mesh.positions[corner[2]] - mesh.positions[corner[0]]);
        ++counts.total;
        if (glm::length(area) < 1e-8f) {
            ++counts.degenerate;
            continue;
        }
        const glm::vec3 normal = mesh.normals[corner[0]] + mesh.normals[corner[1]] + mesh.normals[corner[2]];
        if (glm::dot(area, normal) <= 0) ++counts.facing_away;
    }
}

void expect_valid_streams(const Mesh& mesh) {
    SCOPED_TRACE(mesh.name);
    const size_t count = mesh.positions.size();
    ASSERT_EQ(mesh.normals.size(), count);
    ASSERT_EQ(mesh.tangents.size(), count);
    ASSERT_EQ(mesh.uvs.size(), count);
    ASSERT_EQ(mesh.indices.size() % 3, 0u);
    ASSERT_TRUE(std::all_of(mesh.indices.begin(), mesh.indices.end(), [&](uint32_t i) { return i < count; }));
    for (size_t i = 0; i < count; ++i) {
        ASSERT_TRUE(glm::all(glm::lessThan(glm::abs(mesh.positions[i]), glm::vec3(100)))) << i;
        ASSERT_NEAR(glm::length(mesh.normals[i]), 1, 1e-3f) << i;
        ASSERT_NEAR(glm::length(glm::vec3(mesh.tangents[i])), 1, 1e-3f) << i;
        ASSERT_EQ(std::abs(mesh.tangents[i].w), 1) << i;
        ASSERT_NEAR(glm::dot(mesh.normals[i], glm::vec3(mesh.tangents[i])), 0, 2e-3f) << i;
        ASSERT_TRUE(glm::all(glm::lessThan(glm::abs(mesh.uvs[i]), glm::vec2(1000)))) << i;
    }
}

void expect_triangles_that_face_their_normals(const Scene& scene) {
    TriangleCounts counts;
    for (const Mesh& mesh : scene.meshes) count_triangles(mesh, counts);
    EXPECT_LE(counts.degenerate * 1000, counts.total);
    EXPECT_LE(counts.facing_away * 1000, counts.total);
}

void expect_references_in_range(const Scene& scene) {
    for (const Instance& instance : scene.instances) {
        ASSERT_LT(instance.mesh, scene.meshes.size()) << instance.name;
        ASSERT_LT(instance.material, scene.materials.size()) << instance.name;
        EXPECT_GT(glm::determinant(glm::mat3(instance.transform)), 0) << instance.name;
    }
    for (const Material& material : scene.materials) {
        for (const TextureSlot* slot :
             {&material.base_color_texture, &material.metallic_roughness_texture, &material.normal_texture,
              &material.occlusion_texture, &material.emissive_texture}) {
            EXPECT_TRUE(slot->texture == kNone || slot->texture < scene.textures.size()) << material.name;
        }
    }
}

void expect_full_mip_chain(const Texture& texture) {
    uint32_t width = texture.width_px;
    uint32_t height = texture.height_px;
    size_t level = 0;
    for (;; ++level) {
        ASSERT_LT(level, texture.mips.size()) << texture.name;
        ASSERT_EQ(texture.mips[level].size(), size_t{4} * width * height) << texture.name << " mip " << level;
        if (width == 1 && height == 1) break;
        width = std::max(1u, width / 2);
        height = std::max(1u, height / 2);
    }
    EXPECT_EQ(texture.mips.size(), level + 1) << texture.name;
}

void expect_bounds_of_everything(const Scene& scene) {
    const Bounds bounds = world_bounds(scene);
    EXPECT_EQ(scene.bounds.min, bounds.min);
    EXPECT_EQ(scene.bounds.max, bounds.max);
    for (const Camera& camera : scene.cameras) {
        EXPECT_LT(glm::length(glm::vec3(camera.transform[3])), 2 * glm::length(bounds.max - bounds.min))
            << camera.name;
    }
}

class BuiltinScene : public testing::TestWithParam<std::string> {};

// One test makes all checks, because generating a scene takes longer than the checks.
TEST_P(BuiltinScene, IsValidAndTheSameTwice) {
    const Scene scene = make(GetParam());
    for (const Mesh& mesh : scene.meshes) expect_valid_streams(mesh);
    for (const Texture& texture : scene.textures) expect_full_mip_chain(texture);
    expect_triangles_that_face_their_normals(scene);
    expect_references_in_range(scene);
    expect_bounds_of_everything(scene);
    EXPECT_EQ(digest_of(scene), digest_of(make(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinScene, testing::ValuesIn(builtin_scene_names()),
                         [](const auto& scene) { return scene.param; });

TEST(BuiltinScenes, UnknownNameSuggestsTheNearest) {
    const Result<Scene> scene = make_builtin("atrum");
    ASSERT_FALSE(scene.ok());
    ASSERT_EQ(scene.errors().size(), 1u);
    EXPECT_EQ(scene.errors()[0].code, "S120");
    EXPECT_NE(to_text(scene.errors()[0]).find("atrium"), std::string::npos);
}

TEST(BuiltinSpheres, IsAGridUnderOneLight) {
    const Scene scene = make("spheres");
    EXPECT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.instances.size(), 50u);
    EXPECT_TRUE(scene.textures.empty());
    const auto by_roughness = [](const Material& a, const Material& b) { return a.roughness < b.roughness; };
    const auto [smooth, rough] =
        std::minmax_element(scene.materials.begin(), scene.materials.end(), by_roughness);
    EXPECT_LE(smooth->roughness, 0.1f);
    EXPECT_EQ(rough->roughness, 1);
}

}  // namespace
}  // namespace weft::scene
