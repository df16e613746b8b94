#include "scene/model/mesh_attributes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::scene::test {
namespace {

// Makes two triangles that share the edge x = 0. The uvs of the left triangle mirror those of the right
// triangle.
Mesh mirrored_quad() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.uvs = {{0, 1}, {0, 0}, {1, 1}, {1, 1}};
    mesh.indices = {0, 2, 1, 0, 1, 3};
    return mesh;
}

TEST(MeshAttributes, MirroredUvsSplitTheSeam) {
    Mesh mesh = mirrored_quad();
    generate_tangents(mesh);
    EXPECT_EQ(mesh.positions.size(), 6u);
    ASSERT_EQ(mesh.tangents.size(), 6u);
    for (size_t t = 0; t < 2; ++t) {
        const float towards_u = t == 0 ? 1.0f : -1.0f;
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t v = mesh.indices[3 * t + k];
            EXPECT_NEAR(mesh.tangents[v].x, towards_u, 1e-5f);
            EXPECT_FLOAT_EQ(mesh.tangents[v].w, towards_u);
            // The bitangent (green axis of a normal map) must point up (+y) on both sides of the edge.
            const glm::vec3 up =
                glm::cross(mesh.normals[v], glm::vec3(mesh.tangents[v])) * mesh.tangents[v].w;
            EXPECT_NEAR(up.y, 1, 1e-5f);
        }
    }
}

TEST(MeshAttributes, TangentsAreOrthonormalWhateverTheUvs) {
    Mesh mesh = mirrored_quad();
    for (glm::vec3& normal : mesh.normals) normal = glm::normalize(glm::vec3(0.9f, 0.1f, 0.1f));
    for (const bool degenerate : {false, true}) {
        if (degenerate) mesh.uvs.assign(mesh.positions.size(), glm::vec2(0.5f));
        generate_tangents(mesh);
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[i])), 1, 1e-5f);
            EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[i]), mesh.normals[i]), 0, 1e-5f);
        }
    }
}

TEST(MeshAttributes, SmoothNormalsWeighByArea) {
    Mesh mesh;
    // A large triangle that faces +z and a small triangle that faces +x share the vertex at the origin. Their
    // areas have the ratio 9 : 1, so the z and x components of the vertex normal must have this ratio too.
    mesh.positions = {{0, 0, 0}, {-3, 0, 0}, {0, -3, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.indices = {0, 1, 2, 0, 3, 4};
    generate_normals(mesh);
    EXPECT_NEAR(mesh.normals[0].z / mesh.normals[0].x, 9, 1e-4f);
    EXPECT_NEAR(mesh.normals[1].z, 1, 1e-6f);
}

TEST(MeshAttributes, NormalsOfTinyAndDegenerateTrianglesAreUnit) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1e-12f, 0, 0}, {0, 1e-12f, 0}, {5, 5, 5}};
    mesh.indices = {0, 1, 2, 3, 3, 3};
    generate_normals(mesh);
    for (const glm::vec3& normal : mesh.normals) EXPECT_NEAR(glm::length(normal), 1, 1e-5f);
    EXPECT_NEAR(mesh.normals[0].z, 1, 1e-5f);
}

TEST(MeshAttributes, FlatMeshesShareNothing) {
    Mesh mesh = mirrored_quad();
    make_flat(mesh);
    EXPECT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.uvs.size(), 6u);
    EXPECT_EQ(mesh.indices.back(), 5u);
    EXPECT_NEAR(mesh.normals[5].z, 1, 1e-6f);
}

}  // namespace
}  // namespace weft::scene::test
