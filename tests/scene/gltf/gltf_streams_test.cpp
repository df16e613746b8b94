// Purpose: tests vertex colours and second texture coordinates: the loader stores them only if a material
// uses them.
#include <algorithm>
#include <cmath>

#include "tests/scene/gltf/gltf_fixture.h"

namespace weft::scene::test {
namespace {

class GltfStreams : public GltfTest {
 protected:
    // Gives the triangle a further vertex attribute whose three elements are stored in `bytes`. `form` has
    // further JSON members of the accessor.
    static void add_attribute(GltfText& text, const std::string& name, const Bytes& bytes,
                              const std::string& form) {
        while (text.buffer.size() % 4 != 0) text.buffer.push_back(0);
        const std::string offset = std::to_string(text.buffer.size());
        text.buffer.insert(text.buffer.end(), bytes.begin(), bytes.end());
        std::string& views = text.members["bufferViews"];
        const auto view = static_cast<size_t>(std::count(views.begin(), views.end(), '{'));
        views.insert(views.size() - 1, R"(,{"buffer":0,"byteOffset":)" + offset + R"(,"byteLength":)" +
                                           std::to_string(bytes.size()) + "}");
        std::string& accessors = text.members["accessors"];
        const auto accessor = static_cast<size_t>(std::count(accessors.begin(), accessors.end(), '{'));
        accessors.insert(accessors.size() - 1,
                         R"(,{"bufferView":)" + std::to_string(view) + R"(,"count":3,)" + form + "}");
        std::string& meshes = text.members["meshes"];
        meshes.insert(meshes.find(R"("POSITION")"), "\"" + name + "\":" + std::to_string(accessor) + ",");
    }
    static GltfText with_second_uvs(const std::string& material) {
        GltfText text;
        Bytes uvs;
        append<float>(uvs, {0.25f, 0.5f, 0.75f, 0.5f, 0.25f, 1});
        add_attribute(text, "TEXCOORD_1", uvs, R"("componentType":5126,"type":"VEC2")");
        text.members["images"] = R"([{"uri":")" + data_uri(png(2, 2, Bytes(16, 255))) + R"("}])";
        text.members["textures"] = R"([{"source":0}])";
        text.members["materials"] = "[" + material + "]";
        return text;
    }
};

constexpr glm::vec4 kColors[3] = {{0, 0.2f, 1, 0.6f}, {0.4f, 0.6f, 0.8f, 1}, {1, 0, 0.2f, 0}};

TEST_F(GltfStreams, ColoursOfEveryEncodingAreTheSame) {
    Bytes floats, bytes, shorts;
    for (const glm::vec4& color : kColors) {
        for (int k = 0; k < 4; ++k) {
            append<float>(floats, {color[k]});
            append<uint8_t>(bytes, {static_cast<uint8_t>(std::lround(color[k] * 255))});
            append<uint16_t>(shorts, {static_cast<uint16_t>(std::lround(color[k] * 65535))});
        }
    }
    const std::pair<Bytes, std::string> forms[] = {
        {floats, R"("componentType":5126,"type":"VEC4")"},
        {bytes, R"("componentType":5121,"normalized":true,"type":"VEC4")"},
        {shorts, R"("componentType":5123,"normalized":true,"type":"VEC4")"}};
    for (const auto& [encoded, form] : forms) {
        GltfText text;
        add_attribute(text, "COLOR_0", encoded, form);
        const Mesh mesh = load(text).meshes.at(0);
        EXPECT_TRUE(warnings_.empty()) << form;
        ASSERT_EQ(mesh.colors.size(), 3u) << form;
        // The test colours are multiples of 1/5. Both integer formats store such values exactly, because 255
        // and 65535 are divisible by 5.
        for (size_t i = 0; i < 3; ++i) EXPECT_LT(glm::length(mesh.colors[i] - kColors[i]), 1e-6f) << form;
    }
}

TEST_F(GltfStreams, ColoursWithoutAlphaAreOpaque) {
    GltfText text;
    Bytes floats;
    append<float>(floats, {0.5f, 0, 1, 0, 0.5f, 1, 1, 1, 0});
    add_attribute(text, "COLOR_0", floats, R"("componentType":5126,"type":"VEC3")");
    const Mesh mesh = load(text).meshes.at(0);
    ASSERT_EQ(mesh.colors.size(), 3u);
    EXPECT_EQ(mesh.colors[1], glm::vec4(0, 0.5f, 1, 1));
}

TEST_F(GltfStreams, WhiteColoursTakeNoMemory) {
    GltfText text;
    add_attribute(text, "COLOR_0", Bytes(12, 255), R"("componentType":5121,"normalized":true,"type":"VEC4")");
    EXPECT_TRUE(load(text).meshes.at(0).colors.empty());
    EXPECT_TRUE(load(GltfText()).meshes.at(0).colors.empty());
}

TEST_F(GltfStreams, ColoursOutsideTheirRangeAreMended) {
    GltfText text;
    Bytes floats;
    append<float>(floats, {2, 0.5f, -1, NAN, 0, 0, 0.5f, 0.5f, 0.5f});
    add_attribute(text, "COLOR_0", floats, R"("componentType":5126,"type":"VEC3")");
    const Mesh mesh = load(text).meshes.at(0);
    EXPECT_EQ(mesh.colors.at(0), glm::vec4(1, 0.5f, 0, 1));
    EXPECT_EQ(mesh.colors.at(1), glm::vec4(1));
    EXPECT_TRUE(warned("S152"));
    EXPECT_TRUE(warned("S154"));
}

TEST_F(GltfStreams, ColoursOfAnotherShapeAreRefused) {
    GltfText text;
    add_attribute(text, "COLOR_0", Bytes(24, 0), R"("componentType":5126,"type":"VEC2")");
    EXPECT_EQ(where(fail(text)), "S108 /meshes/0/primitives/0/attributes/COLOR_0");
}

TEST_F(GltfStreams, FlatMeshesKeepTheirColours) {
    GltfText text;
    Bytes floats;
    append<float>(floats, {1, 0, 0, 0, 1, 0, 0, 0, 1});
    add_attribute(text, "COLOR_0", floats, R"("componentType":5126,"type":"VEC3")");
    std::string& meshes = text.members["meshes"];
    meshes.erase(meshes.find(R"("NORMAL":1,)"), 11);
    const Mesh mesh = load(text).meshes.at(0);
    ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
    for (size_t i = 0; i < 3; ++i) EXPECT_EQ(mesh.colors[i][static_cast<int>(i)], 1);
}

TEST_F(GltfStreams, TranslucentColoursKeepAMaterialTransparent) {
    for (const uint8_t alpha : {uint8_t{255}, uint8_t{254}}) {
        GltfText text;
        Bytes bytes(12, 9);
        for (const size_t at : {3u, 7u, 11u}) bytes[at] = alpha;
        add_attribute(text, "COLOR_0", bytes, R"("componentType":5121,"normalized":true,"type":"VEC4")");
        text.members["materials"] = R"([{"alphaMode":"BLEND"}])";
        EXPECT_EQ(load(text).materials.at(0).alpha_mode, alpha == 255 ? AlphaMode::opaque : AlphaMode::blend);
    }
}

TEST_F(GltfStreams, UnlitSurfacesGlowInTheirColours) {
    GltfText text;
    EXPECT_FALSE(load(text).materials.at(0).tinted_emission);
    text.members["materials"] = R"([{"extensions":{"KHR_materials_unlit":{}}}])";
    EXPECT_TRUE(load(text).materials.at(0).tinted_emission);
}

TEST_F(GltfStreams, SecondUvsAreReadForThoseWhoUseThem) {
    const Scene used = load(with_second_uvs(R"({"emissiveTexture":{"index":0,"texCoord":1}})"));
    EXPECT_TRUE(warnings_.empty());
    EXPECT_EQ(used.materials.at(0).emissive_texture.uv_set, 1u);
    EXPECT_EQ(used.materials.at(0).base_color_texture.uv_set, 0u);
    ASSERT_EQ(used.meshes.at(0).second_uvs.size(), 3u);
    EXPECT_EQ(used.meshes[0].second_uvs[1], glm::vec2(0.75f, 0.5f));
    EXPECT_EQ(used.meshes[0].uvs[1], glm::vec2(1, 1));
    EXPECT_TRUE(load(with_second_uvs(R"({"emissiveTexture":{"index":0}})")).meshes.at(0).second_uvs.empty());
}

TEST_F(GltfStreams, TheTransformOfATextureHasTheLastWordOnItsSet) {
    const Scene to_second = load(with_second_uvs(
        R"({"emissiveTexture":{"index":0,"extensions":{"KHR_texture_transform":{"texCoord":1}}}})"));
    EXPECT_EQ(to_second.materials.at(0).emissive_texture.uv_set, 1u);
    const Scene to_first = load(with_second_uvs(
        R"({"emissiveTexture":{"index":0,"texCoord":1,"extensions":{"KHR_texture_transform":{"texCoord":0}}}})"));
    EXPECT_EQ(to_first.materials.at(0).emissive_texture.uv_set, 0u);
}

TEST_F(GltfStreams, AMeshWithoutSecondUvsIsNamed) {
    GltfText text = with_second_uvs(R"({"name":"lit","emissiveTexture":{"index":0,"texCoord":1}})");
    std::string& meshes = text.members["meshes"];
    meshes.replace(meshes.find("TEXCOORD_1"), 10, "TEXCOORD_7");
    EXPECT_TRUE(load(text).meshes.at(0).second_uvs.empty());
    ASSERT_TRUE(warned("S160"));
    EXPECT_EQ(warnings_.at(0).message,
              "a texture of material \"lit\" uses TEXCOORD_1, which mesh \"tri\" does not have; TEXCOORD_0 "
              "is used instead");
}

TEST_F(GltfStreams, TangentsBelongToTheNormalMapsUvs) {
    // In the first uv set, u increases along +x; in the second uv set, along +y. The tangents must follow the
    // second set.
    GltfText text = with_second_uvs(R"({"normalTexture":{"index":0,"texCoord":1}})");
    const float turned[6] = {0, 0, 0, 1, 1, 0};
    std::memcpy(&text.buffer[text.buffer.size() - sizeof turned], turned, sizeof turned);
    const Mesh mesh = load(text).meshes.at(0);
    for (const glm::vec4& tangent : mesh.tangents) EXPECT_NEAR(tangent.y, 1, 1e-5f);
}

}  // namespace
}  // namespace weft::scene::test
