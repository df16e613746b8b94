// Purpose: tests that equivalent glTF files give the same scene, and that values follow the formulas of glTF
// 2.0 and its extensions.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/scene/gltf/gltf_fixture.h"

namespace weft::scene::test {
namespace {

class GltfConformance : public GltfTest {
 protected:
    // Appends `bytes` to the buffer as a new buffer view. `more` contains further JSON members of the view
    // and begins with a comma.
    static void add_view(GltfText& text, const Bytes& bytes, const std::string& more = "") {
        while (text.buffer.size() % 4 != 0) text.buffer.push_back(0);
        const std::string offset = std::to_string(text.buffer.size());
        text.buffer.insert(text.buffer.end(), bytes.begin(), bytes.end());
        text.members["bufferViews"].insert(text.members["bufferViews"].size() - 1,
                                           R"(,{"buffer":0,"byteOffset":)" + offset + R"(,"byteLength":)" +
                                               std::to_string(bytes.size()) + more + "}");
    }
    static void replace(std::string& text, const std::string& from, const std::string& to) {
        const size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
    }
    // Returns a glTF file whose texture coordinates use the accessor with the JSON text `form`. `form` may
    // use the buffer views 4 and 5, which the test adds afterwards.
    static GltfText with_uvs(const std::string& form) {
        GltfText text;
        replace(text.members["accessors"], R"({"bufferView":2,"componentType":5126,"count":3,"type":"VEC2"})",
                form);
        return text;
    }
};

constexpr glm::vec2 kUvs[3] = {{0, 1}, {0.5f, 0.25f}, {0, 0}};

Bytes dense_uvs() {
    Bytes bytes;
    for (const glm::vec2& uv : kUvs) append<float>(bytes, {uv.x, uv.y});
    return bytes;
}

TEST_F(GltfConformance, SparseAccessorsAreTheDenseOnes) {
    GltfText dense = with_uvs(R"({"bufferView":4,"componentType":5126,"count":3,"type":"VEC2"})");
    add_view(dense, dense_uvs());
    const std::vector<glm::vec2> expected = load(dense).meshes.at(0).uvs;
    EXPECT_EQ(expected, std::vector<glm::vec2>(std::begin(kUvs), std::end(kUvs)));

    for (const auto& [type, indices] :
         std::map<int, Bytes>{{5121, {0, 1}}, {5123, {0, 0, 1, 0}}, {5125, {0, 0, 0, 0, 1, 0, 0, 0}}}) {
        // The sparse accessor replaces elements 0 and 1. Element 2 comes from the base: buffer view 2 in the
        // first case. In the second case there is no base, so element 2 is zero.
        for (const char* base : {R"("bufferView":2,)", ""}) {
            GltfText sparse =
                with_uvs("{" + std::string(base) + R"("componentType":5126,"count":3,"type":"VEC2",
                "sparse":{"count":2,"indices":{"bufferView":4,"componentType":)" +
                         std::to_string(type) + R"(},"values":{"bufferView":5}}})");
            add_view(sparse, indices);
            Bytes values;
            append<float>(values, {kUvs[0].x, kUvs[0].y, kUvs[1].x, kUvs[1].y});
            add_view(sparse, values);
            EXPECT_EQ(load(sparse).meshes.at(0).uvs, expected) << type << base;
        }
    }
}

TEST_F(GltfConformance, AnAccessorOfNothingIsZeros) {
    GltfText text = with_uvs(R"({"componentType":5126,"count":3,"type":"VEC2"})");
    EXPECT_EQ(load(text).meshes.at(0).uvs, std::vector<glm::vec2>(3, glm::vec2(0)));
}

TEST_F(GltfConformance, QuantisedUvsAreTheirFloats) {
    struct Form {
        int type;  // glTF component type. 5120: int8, 5121: uint8, 5122: int16, 5123: uint16.
        bool normalized;
        // The value is the stored integer divided by `scale`: by the largest integer of the type if it is
        // normalised, by 1 if it is not.
        double scale;
    };
    for (const Form& form : {Form{5121, true, 255}, Form{5123, true, 65535}, Form{5120, true, 127},
                             Form{5122, true, 32767}, Form{5121, false, 1}, Form{5122, false, 1}}) {
        const std::string type = R"("componentType":)" + std::to_string(form.type);
        GltfText text = with_uvs(R"({"bufferView":4,)" + type + R"(,"normalized":)" +
                                 (form.normalized ? "true" : "false") + R"(,"count":3,"type":"VEC2"})");
        text.members["extensionsRequired"] = R"(["KHR_mesh_quantization"])";
        Bytes bytes;
        glm::vec2 expected[3];
        for (size_t i = 0; i < 3; ++i) {
            for (int k = 0; k < 2; ++k) {
                const auto stored = std::lround(kUvs[i][k] * (form.normalized ? form.scale : 60));
                expected[i][k] = static_cast<float>(static_cast<double>(stored) / form.scale);
                if (form.type <= 5121) append<uint8_t>(bytes, {static_cast<uint8_t>(stored)});
                if (form.type >= 5122) append<uint16_t>(bytes, {static_cast<uint16_t>(stored)});
            }
            while (bytes.size() % 4 != 0) bytes.push_back(0);
        }
        add_view(text, bytes, R"(,"byteStride":4)");
        const Mesh mesh = load(text).meshes.at(0);
        for (size_t i = 0; i < 3; ++i)
            EXPECT_LT(glm::length(mesh.uvs.at(i) - expected[i]), 1e-6f) << type << form.normalized;
    }
}

TEST_F(GltfConformance, QuantisedNormalsAndTangentsAreTheirFloats) {
    const glm::vec3 normal = glm::normalize(glm::vec3(-0.3f, 0.2f, 0.9f));
    const glm::vec3 tangent = glm::normalize(glm::cross(normal, glm::vec3(0.1f, -1, 0.3f)));
    for (const bool wide : {false, true}) {
        const int type = wide ? 5122 : 5120;
        const float scale = wide ? 32767 : 127;
        Bytes normals, tangents;
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 4; ++k) {
                const long n = k < 3 ? std::lround(normal[k] * scale) : 0;
                const long t = k < 3 ? std::lround(tangent[k] * scale) : -std::lround(scale);
                if (wide) {
                    append<int16_t>(normals, {static_cast<int16_t>(n)});
                    append<int16_t>(tangents, {static_cast<int16_t>(t)});
                } else {
                    append<int8_t>(normals, {static_cast<int8_t>(n)});
                    append<int8_t>(tangents, {static_cast<int8_t>(t)});
                }
            }
        }
        GltfText text;
        text.members["extensionsRequired"] = R"(["KHR_mesh_quantization"])";
        add_view(text, normals, R"(,"byteStride":)" + std::to_string(wide ? 8 : 4));
        add_view(text, tangents);
        const std::string form =
            R"(,"componentType":)" + std::to_string(type) + R"(,"normalized":true,"count":3,)";
        text.members["accessors"].insert(
            text.members["accessors"].size() - 1,
            R"(,{"bufferView":4)" + form + R"("type":"VEC3"},{"bufferView":5)" + form + R"("type":"VEC4"})");
        replace(text.members["meshes"], R"("NORMAL":1)", R"("NORMAL":4,"TANGENT":5)");
        const Mesh mesh = load(text).meshes.at(0);
        EXPECT_TRUE(warnings_.empty());
        for (size_t i = 0; i < 3; ++i) {
            EXPECT_LT(glm::length(mesh.normals.at(i) - normal), 1.5f / scale) << type;
            EXPECT_LT(glm::length(glm::vec3(mesh.tangents.at(i)) - tangent), 3 / scale) << type;
            EXPECT_EQ(mesh.tangents[i].w, -1) << type;
        }
    }
}

TEST_F(GltfConformance, TextureTransformsScaleThenTurnThenMove) {
    GltfText text;
    text.members["images"] = R"([{"uri":")" + data_uri(png(1, 1, Bytes(4, 255))) + R"("}])";
    text.members["textures"] = R"([{"source":0}])";
    text.members["materials"] = R"([{"emissiveTexture":{"index":0,"extensions":{"KHR_texture_transform":
        {"offset":[0.25,-0.5],"rotation":0.6,"scale":[2,0.5]}}}}])";
    const glm::mat3x2 matrix = load(text).materials.at(0).emissive_texture.transform;
    const double c = std::cos(0.6), s = std::sin(0.6);
    for (const glm::dvec2 uv :
         {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(-0.3, 0.8)}) {
        const glm::dvec2 scaled = uv * glm::dvec2(2, 0.5);
        // KHR_texture_transform rotates counter-clockwise in a coordinate system whose v axis points down.
        const glm::dvec2 turned(c * scaled.x + s * scaled.y, -s * scaled.x + c * scaled.y);
        const glm::dvec2 expected = turned + glm::dvec2(0.25, -0.5);
        const glm::vec2 found = matrix * glm::vec3(uv, 1);
        EXPECT_LT(glm::length(glm::dvec2(found) - expected), 1e-6) << uv.x << " " << uv.y;
    }
}

TEST_F(GltfConformance, TheEmissiveStrengthMultipliesItsFactor) {
    GltfText text;
    text.members["materials"] = R"([{"emissiveFactor":[1,0.5,0.25],"extensions":{
        "KHR_materials_emissive_strength":{"emissiveStrength":40}}},{"emissiveFactor":[1,0.5,0.25]}])";
    const Scene scene = load(text);
    EXPECT_EQ(scene.materials.at(0).emissive, glm::vec3(40, 20, 10));
    EXPECT_EQ(scene.materials.at(1).emissive, glm::vec3(1, 0.5f, 0.25f));
}

TEST_F(GltfConformance, LightsAndCamerasStandAnywhereInTheTree) {
    GltfText text;
    text.members["extensionsUsed"] = R"(["KHR_lights_punctual"])";
    text.members["extensions"] =
        R"({"KHR_lights_punctual":{"lights":[{"type":"spot","intensity":5,"spot":{}}]}})";
    text.members["cameras"] = R"([{"type":"perspective","perspective":{"yfov":0.7,"znear":0.1}}])";
    // The third node has the light and the camera, and is a grandchild of the first node, which has the mesh.
    // The scale of the third node is not uniform, and its negative x mirrors.
    text.members["nodes"] = R"([{"mesh":0,"translation":[1,2,3],"children":[1]},
        {"rotation":[0,0.3894183423,0,0.9210609940],"children":[2]},
        {"translation":[0,0,-2],"rotation":[0.1986693308,0,0,0.9800665778],"scale":[-3,0.5,7],"camera":0,
         "extensions":{"KHR_lights_punctual":{"light":0}}}])";
    const Scene scene = load(text);
    const glm::mat4 expected = glm::translate(glm::mat4(1), glm::vec3(1, 2, 3)) *
                               glm::rotate(glm::mat4(1), 0.8f, glm::vec3(0, 1, 0)) *
                               glm::translate(glm::mat4(1), glm::vec3(0, 0, -2)) *
                               glm::rotate(glm::mat4(1), 0.4f, glm::vec3(1, 0, 0));
    ASSERT_EQ(scene.lights.size(), 1u);
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_LT(glm::length(scene.lights[0].position - glm::vec3(expected[3])), 1e-5f);
    EXPECT_LT(glm::length(scene.lights[0].direction + glm::vec3(expected[2])), 1e-5f);
    EXPECT_FLOAT_EQ(scene.lights[0].intensity, 5) << "scale changes no candela";
    const glm::mat4& camera = scene.cameras[0].transform;
    for (int column = 1; column < 4; ++column)
        EXPECT_LT(glm::length(camera[column] - expected[column]), 1e-5f) << column;
    EXPECT_NEAR(glm::determinant(glm::mat3(camera)), 1, 1e-5f) << "the mirror is lost";
}

}  // namespace
}  // namespace weft::scene::test
