// Tests the CPU side of the scene buffers: the boxes of the instances, and the catalogue.
#include "render/imports/scene_buffers.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "weft/render/import_catalog.h"
#include "weft/scene/builtin_scenes.h"

namespace weft::render {
namespace {

// A scene with one mesh, whose box is random, and 50 instances with random affine transforms.
scene::Scene random_scene(uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> number(-3, 3);
    const auto vector = [&] { return glm::vec3(number(random), number(random), number(random)); };
    scene::Scene scene;
    const glm::vec3 a = vector(), b = vector();
    scene.meshes.emplace_back().bounds = {glm::min(a, b), glm::max(a, b)};
    for (int i = 0; i < 50; ++i) {
        glm::mat4 transform = glm::translate(glm::mat4(1), vector());
        for (int column = 0; column < 3; ++column) transform[column] = glm::vec4(vector(), 0);
        scene.instances.push_back({.name = "", .mesh = 0, .material = 0, .transform = transform});
    }
    return scene;
}

TEST(SceneBuffers, TheBoxOfAnInstanceIsTheSmallestBoxAroundItsTransformedCorners) {
    for (const uint32_t seed : {11u, 12u, 13u, 14u, 15u}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const scene::Scene scene = random_scene(seed);
        const std::vector<shared::Bounds> boxes = instance_bounds(scene);
        ASSERT_EQ(boxes.size(), scene.instances.size());
        for (size_t i = 0; i < boxes.size(); ++i) {
            const scene::Bounds& box = scene.meshes[0].bounds;
            glm::vec3 least(1e9f), most(-1e9f);
            for (int corner = 0; corner < 8; ++corner) {
                const glm::vec3 at((corner & 1) != 0 ? box.max.x : box.min.x,
                                   (corner & 2) != 0 ? box.max.y : box.min.y,
                                   (corner & 4) != 0 ? box.max.z : box.min.z);
                const glm::vec3 placed = scene.instances[i].transform * glm::vec4(at, 1);
                least = glm::min(least, placed);
                most = glm::max(most, placed);
            }
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_NEAR(boxes[i].least[axis], least[axis], 1e-3f);
                EXPECT_NEAR(boxes[i].most[axis], most[axis], 1e-3f);
            }
        }
    }
}

TEST(SceneBuffers, TheCatalogueHasTheirSizesAndCounts) {
    const Result<scene::Scene> scene = scene::make_builtin("spheres");
    ASSERT_TRUE(scene);
    const ImportCatalog catalog = scene_imports({64, 64, 1}, &*scene);
    EXPECT_EQ(catalog.imports.at("instances").resource.size_bytes,
              scene->instances.size() * sizeof(shared::Instance));
    EXPECT_EQ(catalog.imports.at("bounds").resource.size_bytes,
              scene->instances.size() * sizeof(shared::Bounds));
    EXPECT_EQ(catalog.imports.at("meshes").resource.size_bytes, scene->meshes.size() * sizeof(shared::Mesh));
    EXPECT_EQ(catalog.imports.at("materials").resource.size_bytes,
              scene->materials.size() * sizeof(shared::Material));
    EXPECT_EQ(catalog.numbers.at("instanceCount"), static_cast<double>(scene->instances.size()));
    EXPECT_EQ(catalog.numbers.at("meshCount"), static_cast<double>(scene->meshes.size()));
    EXPECT_EQ(catalog.numbers.at("materialCount"), static_cast<double>(scene->materials.size()));
    EXPECT_GE(catalog.imports.at("materialTextures").resource.textures, 2u);
    EXPECT_EQ(scene_imports({64, 64, 1}).imports.at("materialTextures").resource.textures, 1u);
    // Without a scene, and for an empty scene, each buffer has one element.
    const scene::Scene empty;
    for (const scene::Scene* none : {static_cast<const scene::Scene*>(nullptr), &empty})
        EXPECT_EQ(scene_imports({64, 64, 1}, none).imports.at("bounds").resource.size_bytes,
                  sizeof(shared::Bounds));
}

}  // namespace
}  // namespace weft::render
