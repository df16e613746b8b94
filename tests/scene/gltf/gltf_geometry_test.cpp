#include <cmath>
#include <limits>

#include "scene/gltf/gltf_document.h"
#include "scene/gltf/mesh_topology.h"
#include "tests/scene/gltf/gltf_fixture.h"

namespace weft::scene::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class GltfGeometry : public GltfTest {};

TEST_F(GltfGeometry, ReadsATriangle) {
    const Scene scene = load(GltfText());
    ASSERT_EQ(scene.meshes.size(), 1u);
    ASSERT_EQ(scene.instances.size(), 1u);
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.name, "tri");
    EXPECT_EQ(mesh.indices, (std::vector<uint32_t>{0, 1, 2}));
    ASSERT_EQ(mesh.positions.size(), 3u);
    ASSERT_EQ(mesh.tangents.size(), 3u);
    expect_near(mesh.positions[1], {1, 0, 0});
    EXPECT_EQ(mesh.uvs[2], glm::vec2(0, 0));
    expect_near(scene.bounds.max, {1, 1, 0});
    EXPECT_TRUE(warnings_.empty());
}

TEST_F(GltfGeometry, ReadsEveryIndexType) {
    for (const auto& [type, bytes] : std::map<int, Bytes>{{5121, {2, 0, 1, 0}},
                                                          {5123, {2, 0, 0, 0, 1, 0, 0, 0}},
                                                          {5125, {2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}}}) {
        GltfText text;
        text.buffer.resize(96);
        text.buffer.insert(text.buffer.end(), bytes.begin(), bytes.end());
        text.members["bufferViews"] =
            R"([{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},
            {"buffer":0,"byteOffset":72,"byteLength":24},{"buffer":0,"byteOffset":96,"byteLength":)" +
            std::to_string(bytes.size()) + "}]";
        std::string& accessors = text.members["accessors"];
        accessors.replace(accessors.find("5123"), 4, std::to_string(type));
        EXPECT_EQ(load(text).meshes.at(0).indices, (std::vector<uint32_t>{2, 0, 1})) << type;
    }
    GltfText plain;
    plain.members["meshes"] = R"([{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1}}]}])";
    EXPECT_EQ(load(plain).meshes.at(0).indices, (std::vector<uint32_t>{0, 1, 2}));
}

TEST_F(GltfGeometry, KeepsOnlyTheVerticesThatAreUsed) {
    GltfText text;
    // At byte 104 of the buffer: one vertex that no index uses, then the three used vertices.
    append<float>(text.buffer, {9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0});
    append<uint16_t>(text.buffer, {1, 2, 3, 0});
    text.members["bufferViews"] = R"([{"buffer":0,"byteOffset":104,"byteLength":48},
        {"buffer":0,"byteOffset":152,"byteLength":8}])";
    text.members["accessors"] = R"([{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
        {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}])";
    text.members["meshes"] = R"([{"primitives":[{"attributes":{"POSITION":0,"NORMAL":0},"indices":1}]}])";
    const Mesh mesh = load(text).meshes.at(0);
    EXPECT_EQ(mesh.positions.size(), 3u);
    expect_near(mesh.bounds.max, {1, 1, 0});
}

TEST_F(GltfGeometry, MissingNormalsAreFlat) {
    GltfText text;
    text.members["meshes"] = R"([{"primitives":[{"attributes":{"POSITION":0},"indices":3}]}])";
    const Mesh mesh = load(text).meshes.at(0);
    for (const glm::vec3& normal : mesh.normals) expect_near(normal, {0, 0, 1});
    ASSERT_EQ(mesh.tangents.size(), 3u);
    EXPECT_EQ(mesh.uvs.size(), 3u);
    EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[0]), mesh.normals[0]), 0, 1e-6f);
}

TEST_F(GltfGeometry, TangentsFollowUAndTheGreenChannelPointsUp) {
    // In the texture coordinates of the triangle, u increases along +x and v decreases along +y: the image
    // stands upright.
    const Mesh mesh = load(GltfText()).meshes.at(0);
    for (size_t i = 0; i < 3; ++i) {
        expect_near(glm::vec3(mesh.tangents[i]), {1, 0, 0});
        expect_near(glm::cross(mesh.normals[i], glm::vec3(mesh.tangents[i])) * mesh.tangents[i].w, {0, 1, 0});
    }
}

TEST_F(GltfGeometry, ReadsSparseAccessors) {
    GltfText text;
    append<uint16_t>(text.buffer, {1, 0});  // The index of the sparse element, at byte 104 of the buffer.
    append<float>(text.buffer, {7, 0, 0});  // The value of the sparse element, at byte 108 of the buffer.
    text.members["bufferViews"].insert(text.members["bufferViews"].size() - 1,
                                       R"(,{"buffer":0,"byteOffset":104,"byteLength":2},
                                       {"buffer":0,"byteOffset":108,"byteLength":12})");
    std::string& accessors = text.members["accessors"];
    accessors.insert(
        2,
        R"("sparse":{"count":1,"indices":{"bufferView":4,"componentType":5123},"values":{"bufferView":5}},)");
    expect_near(load(text).meshes.at(0).positions[1], {7, 0, 0});
}

TEST_F(GltfGeometry, DropsTrianglesThatAreNotFinite) {
    GltfText text;
    const float nan = kNan;
    std::memcpy(text.buffer.data(), &nan, sizeof nan);
    const Scene scene = load(text);
    EXPECT_TRUE(scene.instances.empty());
    EXPECT_TRUE(warned("S152"));
}

TEST_F(GltfGeometry, MendsNormalsAndUvsThatAreNotFinite) {
    GltfText text;
    const float nan = kNan;
    std::memcpy(&text.buffer[36], &nan, sizeof nan);
    std::memcpy(&text.buffer[72], &nan, sizeof nan);
    const Mesh mesh = load(text).meshes.at(0);
    expect_near(mesh.normals[0], {0, 0, 1});
    EXPECT_EQ(mesh.uvs[0], glm::vec2(0));
    EXPECT_TRUE(warned("S152"));
}

TEST_F(GltfGeometry, OtherPrimitivesAreNamedAndLeftOut) {
    GltfText text;
    text.members["meshes"] = R"([{"primitives":[{"attributes":{"POSITION":0},"mode":1},
        {"attributes":{"POSITION":0,"NORMAL":1},"indices":3}]}])";
    const Scene scene = load(text);
    EXPECT_EQ(scene.meshes.size(), 1u);
    ASSERT_TRUE(warned("S151"));
    EXPECT_EQ(where(warnings_[0]), "S151 /meshes/0/primitives/0/mode");
}

TEST_F(GltfGeometry, StripsAndFansBecomeTriangles) {
    using List = std::vector<uint32_t>;
    EXPECT_EQ(gltf::triangle_list(gltf::kTriangles, {4, 5, 6, 7}), (List{4, 5, 6}));
    EXPECT_EQ(gltf::triangle_list(gltf::kTriangleStrip, {0, 1, 2, 3, 4}), (List{0, 1, 2, 1, 3, 2, 2, 3, 4}));
    EXPECT_EQ(gltf::triangle_list(gltf::kTriangleFan, {9, 1, 2, 3}), (List{1, 2, 9, 2, 3, 9}));
    EXPECT_EQ(gltf::triangle_list(gltf::kTriangleStrip, {0, 1, 2, 3, 3, 4, 4, 5, 6}),
              (List{0, 1, 2, 1, 3, 2, 4, 5, 6}))
        << "two strips joined by empty triangles";
    for (const uint32_t mode : {gltf::kTriangles, gltf::kTriangleStrip, gltf::kTriangleFan})
        EXPECT_TRUE(gltf::triangle_list(mode, {1, 2}).empty());
}

// A quad that is stored as a triangle strip gives the same mesh as two separate triangles: the same corners
// and the same front sides.
TEST_F(GltfGeometry, AStripIsDrawnLikeItsTriangles) {
    const auto quad = [&](const std::string& mode, const std::vector<uint16_t>& corners) {
        GltfText text;
        const size_t at = text.buffer.size();
        for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 1.f, 1.f, 0.f})
            append<float>(text.buffer, {x});
        for (const uint16_t corner : corners) append<uint16_t>(text.buffer, {corner});
        text.members["bufferViews"] = R"([{"buffer":0,"byteOffset":)" + std::to_string(at) +
                                      R"(,"byteLength":48},{"buffer":0,"byteOffset":)" +
                                      std::to_string(at + 48) + R"(,"byteLength":)" +
                                      std::to_string(corners.size() * 2) + "}]";
        text.members["accessors"] =
            R"([{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
            {"bufferView":1,"componentType":5123,"count":)" +
            std::to_string(corners.size()) + R"(,"type":"SCALAR"}])";
        text.members["meshes"] =
            R"([{"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":)" + mode + "}]}]";
        return load(text).meshes.at(0);
    };
    const Mesh list = quad("4", {0, 1, 2, 1, 3, 2}), strip = quad("5", {0, 1, 2, 3});
    ASSERT_EQ(list.indices.size(), 6u);
    EXPECT_EQ(list.indices, strip.indices);
    EXPECT_TRUE(list.positions == strip.positions);
    for (const glm::vec3& normal : strip.normals) expect_near(normal, {0, 0, 1});
}

TEST_F(GltfGeometry, ReadsAGlb) {
    const GltfText text;
    write("scene.glb", text.glb(text.buffer));
    EXPECT_EQ(load_file("scene.glb").meshes.at(0).positions.size(), 3u);
    EXPECT_EQ(load_file(".").meshes.size(), 1u) << "a folder with one glTF names it";
    write("second.gltf", text.json());
    EXPECT_EQ(fail_file(".").code, "S101");
    EXPECT_NE(errors_[0].message.find("second.gltf"), std::string::npos);
}

TEST_F(GltfGeometry, ReadsAnExternalBuffer) {
    GltfText text;
    write("my buffer.bin", text.buffer);
    text.members["buffers"] = R"([{"byteLength":104,"uri":"my%20buffer.bin"}])";
    EXPECT_EQ(load(text).meshes.size(), 1u);
}

TEST_F(GltfGeometry, ReadsQuantizedPositions) {
    GltfText text;
    append<int16_t>(text.buffer, {0, 0, 0, 0, 32767, 0, 0, 0, 0, -32767, 0, 0});
    text.members["extensionsRequired"] = R"(["KHR_mesh_quantization"])";
    text.members["bufferViews"] = R"([{"buffer":0,"byteOffset":104,"byteLength":24,"byteStride":8}])";
    text.members["accessors"] =
        R"([{"bufferView":0,"componentType":5122,"normalized":true,"count":3,"type":"VEC3"}])";
    text.members["meshes"] = R"([{"primitives":[{"attributes":{"POSITION":0}}]}])";
    const Mesh mesh = load(text).meshes.at(0);
    expect_near(mesh.bounds.min, {0, -1, 0});
    expect_near(mesh.bounds.max, {1, 0, 0});
}

}  // namespace
}  // namespace weft::scene::test
