// Purpose: tests geometry that is stored as quantised integers, and files that contain several scenes.
#include <cmath>

#include "tests/scene/gltf/gltf_fixture.h"

namespace weft::scene::test {
namespace {

class GltfEncodings : public GltfTest {
 protected:
    // Returns a glTF file with one triangle whose positions are stored in `bytes`. `form` has further JSON
    // members of the accessor.
    static GltfText triangle(const Bytes& bytes, const std::string& form, uint32_t stride_bytes) {
        GltfText text;
        text.buffer = bytes;
        text.members["extensionsRequired"] = R"(["KHR_mesh_quantization"])";
        text.members["bufferViews"] = R"([{"buffer":0,"byteLength":)" + std::to_string(bytes.size()) +
                                      R"(,"byteStride":)" + std::to_string(stride_bytes) + "}]";
        text.members["accessors"] = R"([{"bufferView":0,"count":3,"type":"VEC3",)" + form + "}]";
        text.members["meshes"] = R"([{"primitives":[{"attributes":{"POSITION":0}}]}])";
        return text;
    }
};

constexpr glm::vec3 kCorners[3] = {{-1, 0.3f, 0.7f}, {0.9f, -0.45f, 0.1f}, {0.2f, 1, -0.6f}};

TEST_F(GltfEncodings, NormalisedPositionsLieWithinAStepOfTheFloats) {
    Bytes bytes8;
    Bytes bytes16;
    for (const glm::vec3& corner : kCorners) {
        for (int k = 0; k < 4; ++k) {
            const float value = k < 3 ? corner[k] : 0;
            append<int8_t>(bytes8, {static_cast<int8_t>(std::lround(value * 127))});
            append<int16_t>(bytes16, {static_cast<int16_t>(std::lround(value * 32767))});
        }
    }
    const Mesh mesh8 = load(triangle(bytes8, R"("componentType":5120,"normalized":true)", 4)).meshes.at(0);
    const Mesh mesh16 = load(triangle(bytes16, R"("componentType":5122,"normalized":true)", 8)).meshes.at(0);
    for (size_t i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(mesh8.positions.at(i)[k], kCorners[i][k], 0.5f / 127 + 1e-6f);
            EXPECT_NEAR(mesh16.positions.at(i)[k], kCorners[i][k], 0.5f / 32767 + 1e-6f);
        }
    }
}

TEST_F(GltfEncodings, OtherIntegersKeepTheirValue) {
    Bytes bytes;
    append<int16_t>(bytes, {-300, 2, 3, 0, 400, 5, 6, 0, 7, 32767, -32768, 0});
    const Mesh mesh = load(triangle(bytes, R"("componentType":5122)", 8)).meshes.at(0);
    EXPECT_EQ(mesh.positions.at(0), glm::vec3(-300, 2, 3));
    EXPECT_EQ(mesh.positions.at(1), glm::vec3(400, 5, 6));
    EXPECT_EQ(mesh.positions.at(2), glm::vec3(7, 32767, -32768));
}

TEST_F(GltfEncodings, TheScenesThatAreNotShownAreNamed) {
    GltfText text;
    text.members["scenes"] = R"([{"nodes":[0]},{"name":"night","nodes":[0]},{}])";
    load(text);
    ASSERT_EQ(warnings_.size(), 1u);
    EXPECT_EQ(where(warnings_[0]), "S153 /scenes");
    EXPECT_EQ(warnings_[0].message, "only scene 0 is shown; ignored: 1 \"night\", 2");
    text.members["scene"] = "1";
    load(text);
    EXPECT_EQ(warnings_.at(0).message, "only scene 1 is shown; ignored: 0, 2");
}

}  // namespace
}  // namespace weft::scene::test
