#include <cmath>

#include "tests/scene/gltf/gltf_fixture.h"

namespace weft::scene::test {
namespace {

class GltfMaterial : public GltfTest {
 protected:
    // Returns a glTF file with one material and one image of 2 × 2 texels. Both textures use the image;
    // texture 0 has no sampler, texture 1 has one.
    static GltfText with_material(const std::string& material, const Bytes& rgba = Bytes(16, 255)) {
        GltfText text;
        text.members["images"] = R"([{"name":"image","uri":")" + data_uri(png(2, 2, rgba)) + R"("}])";
        text.members["textures"] = R"([{"source":0},{"source":0,"sampler":0}])";
        text.members["samplers"] = R"([{"magFilter":9728,"minFilter":9984,"wrapS":33071,"wrapT":33648}])";
        text.members["materials"] = "[" + material + "]";
        return text;
    }
};

TEST_F(GltfMaterial, ReadsFactors) {
    const Scene scene =
        load(with_material(R"({"name":"gold","doubleSided":true,"alphaMode":"MASK","alphaCutoff":0.25,
        "emissiveFactor":[1,0.5,0],
        "pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,0.4],"metallicFactor":0.5,"roughnessFactor":0.25},
        "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":5000000000},
        "KHR_materials_specular":{"specularFactor":0,"specularColorFactor":[1,2,3]},"KHR_materials_ior":{"ior":2}}})"));
    const Material& material = scene.materials.at(0);
    EXPECT_EQ(material.name, "gold");
    EXPECT_TRUE(material.double_sided);
    EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
    EXPECT_FLOAT_EQ(material.alpha_cutoff, 0.25f);
    EXPECT_FLOAT_EQ(material.base_color.w, 0.4f);
    EXPECT_FLOAT_EQ(material.metallic, 0.5f);
    EXPECT_FLOAT_EQ(material.roughness, 0.25f);
    EXPECT_FLOAT_EQ(material.emissive.y, 2.5e9f);
    EXPECT_FLOAT_EQ(material.specular, 0);
    EXPECT_EQ(material.specular_color, glm::vec3(1, 2, 3));
    EXPECT_FLOAT_EQ(material.ior, 2);
}

TEST_F(GltfMaterial, UnlitShowsItsBaseColour) {
    const Material material = load(with_material(R"({"alphaMode":"BLEND","emissiveFactor":[1,1,1],
        "pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,0.4],"baseColorTexture":{"index":0}},
        "extensions":{"KHR_materials_unlit":{}}})"))
                                  .materials.at(0);
    EXPECT_EQ(material.emissive, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(material.emissive_texture.texture, material.base_color_texture.texture);
    EXPECT_NE(material.emissive_texture.texture, kNone);
    EXPECT_EQ(material.base_color, glm::vec4(0, 0, 0, 0.4f));
    EXPECT_EQ(material.metallic, 0);
    EXPECT_EQ(material.specular, 0);
    for (const Diagnostic& warning : warnings_)
        EXPECT_EQ(warning.message.find("unlit"), std::string::npos) << warning.message;
}

TEST_F(GltfMaterial, ReadsScatteredLight) {
    const Material material = load(with_material(R"({"extensions":{
        "KHR_materials_diffuse_transmission":{"diffuseTransmissionFactor":0.75,"diffuseTransmissionColorFactor":[1,0.5,0.25]},
        "KHR_materials_volume":{"thicknessFactor":0.5,"attenuationDistance":2,"attenuationColor":[1,0.5,0.25]}},
        "extras":{"weft":{"diffuseRoughness":0.4}}})"))
                                  .materials.at(0);
    EXPECT_FLOAT_EQ(material.diffuse_transmission, 0.75f);
    EXPECT_EQ(material.diffuse_transmission_color, glm::vec3(1, 0.5f, 0.25f));
    EXPECT_FLOAT_EQ(material.thickness_m, 0.5f);
    EXPECT_FLOAT_EQ(material.absorption_per_m.y, std::log(2.0f) / 2);
    EXPECT_FLOAT_EQ(material.diffuse_roughness_rad, 0.4f);
    EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
}

TEST_F(GltfMaterial, ClampsScatteredLight) {
    const Material material = load(with_material(R"({"extensions":{
        "KHR_materials_diffuse_transmission":{"diffuseTransmissionFactor":7,"diffuseTransmissionColorFactor":[-1,2,0.25]}},
        "extras":{"weft":{"diffuseRoughness":9}}})"))
                                  .materials.at(0);
    EXPECT_FLOAT_EQ(material.diffuse_transmission, 1);
    EXPECT_EQ(material.diffuse_transmission_color, glm::vec3(0, 1, 0.25f));
    EXPECT_NEAR(material.diffuse_roughness_rad, 1.5707963f, 1e-6f);
    EXPECT_FALSE(warnings_.empty());
}

TEST_F(GltfMaterial, ReadsClearcoat) {
    const Material material = load(with_material(R"({"extensions":{"KHR_materials_clearcoat":{
        "clearcoatFactor":0.5,"clearcoatRoughnessFactor":0.25,"clearcoatTexture":{"index":0}}}})"))
                                  .materials.at(0);
    EXPECT_FLOAT_EQ(material.clearcoat, 0.5f);
    EXPECT_FLOAT_EQ(material.clearcoat_roughness, 0.25f);
    ASSERT_EQ(warnings_.size(), 1u);
    EXPECT_EQ(where(warnings_[0]), "S153 /materials/0/extensions/KHR_materials_clearcoat/clearcoatTexture");
    EXPECT_EQ(
        load(with_material(R"({"extensions":{"KHR_materials_clearcoat":{}}})")).materials.at(0).clearcoat, 0);
}

TEST_F(GltfMaterial, ReadsTransmission) {
    const Scene scene = load(with_material(R"({"extensions":{
        "KHR_materials_transmission":{"transmissionFactor":0.75,"transmissionTexture":{"index":0}},
        "KHR_materials_volume":{"thicknessFactor":0.5,"attenuationDistance":2,"attenuationColor":[1,0.5,0],
            "thicknessTexture":{"index":0}}},
        "extras":{"weft":{"ripples":[0.1,-0.2,0.3,0.4],"depth":1}}})"));
    const Material& material = scene.materials.at(0);
    EXPECT_FLOAT_EQ(material.transmission, 0.75f);
    EXPECT_FLOAT_EQ(material.thickness_m, 0.5f);
    EXPECT_FLOAT_EQ(material.absorption_per_m.x, 0);
    EXPECT_NEAR(material.absorption_per_m.y, 0.34657, 1e-5) << "ln 2 / 2";
    EXPECT_NEAR(material.absorption_per_m.z, 4.60517, 1e-4) << "of a colour of 0.0001";
    EXPECT_EQ(material.ripples, glm::vec4(0.1f, -0.2f, 0.3f, 0.4f));
    EXPECT_EQ(material.alpha_mode, AlphaMode::blend) << "although the alpha is 1";
    ASSERT_EQ(warnings_.size(), 3u);
    EXPECT_EQ(where(warnings_[0]),
              "S153 /materials/0/extensions/KHR_materials_transmission/transmissionTexture");
    EXPECT_EQ(where(warnings_[1]), "S153 /materials/0/extensions/KHR_materials_volume/thicknessTexture");
    EXPECT_EQ(where(warnings_[2]), "S153 /materials/0/extras/weft/depth");
}

TEST_F(GltfMaterial, IsNotTransmissiveWithAMaskOrAFactorOfZero) {
    const char* const kGlass = R"("extensions":{"KHR_materials_transmission":{"transmissionFactor":1}})";
    EXPECT_EQ(load(with_material(std::string(R"({"alphaMode":"MASK",)") + kGlass + "}"))
                  .materials.at(0)
                  .transmission,
              0);
    const Material none =
        load(with_material(R"({"extensions":{"KHR_materials_transmission":{}}})")).materials.at(0);
    EXPECT_EQ(none.transmission, 0);
    EXPECT_EQ(none.alpha_mode, AlphaMode::opaque);
    const Material thin = load(with_material(std::string("{") + kGlass + "}")).materials.at(0);
    EXPECT_EQ(thin.thickness_m, 0);
    EXPECT_EQ(thin.absorption_per_m, glm::vec3(0));
    const Diagnostic error = fail(with_material(R"({"extras":{"weft":{"ripples":[1,2]}}})"));
    EXPECT_EQ(where(error), "S108 /materials/0/extras/weft/ripples");
    EXPECT_EQ(where(fail(with_material(R"({"extras":{"weft":7}})"))), "S108 /materials/0/extras/weft");
}

TEST_F(GltfMaterial, ReadsAnisotropy) {
    const Material material = load(with_material(R"({"extensions":{"KHR_materials_anisotropy":{
        "anisotropyStrength":0.75,"anisotropyRotation":7.283185307179586,"anisotropyTexture":{"index":1,"texCoord":1,
        "extensions":{"KHR_texture_transform":{"offset":[0.5,0.25]}}}}}})"))
                                  .materials.at(0);
    EXPECT_FLOAT_EQ(material.anisotropy, 0.75f);
    EXPECT_NEAR(material.anisotropy_rotation_rad, 1, 1e-6) << "less a full turn";
    const TextureSlot& slot = material.anisotropy_texture;
    EXPECT_NE(slot.texture, kNone);
    EXPECT_EQ(slot.uv_set, 1u);
    EXPECT_EQ(slot.mag, Filter::nearest);
    EXPECT_EQ(slot.transform[2], glm::vec2(0.5f, 0.25f));
    const Material plain =
        load(with_material(R"({"extensions":{"KHR_materials_anisotropy":{}}})")).materials.at(0);
    EXPECT_EQ(plain.anisotropy, 0);
    EXPECT_EQ(plain.anisotropy_texture.texture, kNone);
}

TEST_F(GltfMaterial, AnisotropyIsCheckedAndClamped) {
    const Scene clamped =
        load(with_material(R"({"extensions":{"KHR_materials_anisotropy":{"anisotropyStrength":3}}})"));
    EXPECT_EQ(clamped.materials.at(0).anisotropy, 1);
    EXPECT_EQ(where(warnings_.at(0)),
              "S154 /materials/0/extensions/KHR_materials_anisotropy/anisotropyStrength");
    const Diagnostic error = fail(
        with_material(R"({"extensions":{"KHR_materials_anisotropy":{"anisotropyTexture":{"index":9}}}})"));
    EXPECT_EQ(where(error), "S110 /materials/0/extensions/KHR_materials_anisotropy/anisotropyTexture/index");
}

TEST_F(GltfMaterial, DefaultsAreThoseOfGltf) {
    const Material material = load(GltfText()).materials.at(0);
    EXPECT_EQ(material.base_color, glm::vec4(1));
    EXPECT_FLOAT_EQ(material.metallic, 1);
    EXPECT_FLOAT_EQ(material.roughness, 1);
    EXPECT_EQ(material.emissive, glm::vec3(0));
    EXPECT_FLOAT_EQ(material.specular, 1);
    EXPECT_FLOAT_EQ(material.ior, 1.5f);
    EXPECT_EQ(material.base_color_texture.texture, kNone);
}

TEST_F(GltfMaterial, FactorsOutsideTheirRangeAreClampedWithAWarning) {
    const Scene scene =
        load(with_material(R"({"pbrMetallicRoughness":{"metallicFactor":1.5,"roughnessFactor":-1}})"));
    EXPECT_FLOAT_EQ(scene.materials.at(0).metallic, 1);
    EXPECT_FLOAT_EQ(scene.materials.at(0).roughness, 0);
    EXPECT_EQ(where(warnings_.at(0)), "S154 /materials/0/pbrMetallicRoughness/metallicFactor");
}

TEST_F(GltfMaterial, OneImageUsedAsColourAndDataBecomesTwoTextures) {
    const Scene scene =
        load(with_material(R"({"emissiveTexture":{"index":1},"occlusionTexture":{"index":0,"strength":0.5},
        "pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":0}}})"));
    const Material& material = scene.materials.at(0);
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(material.base_color_texture.texture, material.emissive_texture.texture);
    EXPECT_EQ(material.occlusion_texture.texture, material.metallic_roughness_texture.texture);
    EXPECT_EQ(scene.textures[material.base_color_texture.texture].color_space, ColorSpace::srgb);
    EXPECT_EQ(scene.textures[material.occlusion_texture.texture].color_space, ColorSpace::linear);
    EXPECT_FLOAT_EQ(material.occlusion_strength, 0.5f);
    EXPECT_EQ(scene.textures[0].mips.size(), 2u);
}

TEST_F(GltfMaterial, SamplersBelongToTheSlot) {
    const Scene scene =
        load(with_material(R"({"emissiveTexture":{"index":1},"normalTexture":{"index":0,"scale":2}})"));
    const TextureSlot& own = scene.materials.at(0).emissive_texture;
    EXPECT_EQ(own.mag, Filter::nearest);
    EXPECT_EQ(own.min, Filter::nearest);
    EXPECT_TRUE(own.mipmapped);
    EXPECT_EQ(own.wrap_u, Wrap::clamp_to_edge);
    EXPECT_EQ(own.wrap_v, Wrap::mirrored_repeat);
    const TextureSlot& plain = scene.materials.at(0).normal_texture;
    EXPECT_EQ(plain.mag, Filter::linear);
    EXPECT_TRUE(plain.mipmapped);
    EXPECT_EQ(plain.wrap_u, Wrap::repeat);
    EXPECT_FLOAT_EQ(scene.materials[0].normal_scale, 2);
}

TEST_F(GltfMaterial, TextureTransformIsAMatrix) {
    // This is the example in the specification of the extension: the lower left quarter of the image, rotated
    // by 90°.
    const Scene scene =
        load(with_material(R"({"emissiveTexture":{"index":0,"extensions":{"KHR_texture_transform":
        {"offset":[0,1],"rotation":1.57079632679,"scale":[0.5,0.5]}}}})"));
    const glm::mat3x2& matrix = scene.materials.at(0).emissive_texture.transform;
    for (const glm::vec2 uv : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(1, 1)}) {
        const glm::vec2 moved = matrix * glm::vec3(uv, 1);
        EXPECT_NEAR(moved.x, uv.y * 0.5f, 1e-6f);
        EXPECT_NEAR(moved.y, 1 - uv.x * 0.5f, 1e-6f);
    }
}

TEST_F(GltfMaterial, OtherUvSetsAreNamed) {
    load(with_material(R"({"emissiveTexture":{"index":0,"texCoord":2}})"));
    EXPECT_EQ(where(warnings_.at(0)), "S153 /materials/0/emissiveTexture/texCoord");
}

TEST_F(GltfMaterial, BlendWithoutTransparencyIsOpaque) {
    const std::string blend =
        R"({"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
    EXPECT_EQ(load(with_material(blend)).materials.at(0).alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(load(with_material(blend, Bytes(16, 254))).materials.at(0).alpha_mode, AlphaMode::blend);
}

TEST_F(GltfMaterial, ImagesMayLieInABufferView) {
    GltfText text;
    const Bytes image = png(2, 2, Bytes(16, 77));
    const size_t at = text.buffer.size();
    text.buffer.insert(text.buffer.end(), image.begin(), image.end());
    text.members["bufferViews"].insert(text.members["bufferViews"].size() - 1,
                                       R"(,{"buffer":0,"byteOffset":)" + std::to_string(at) +
                                           R"(,"byteLength":)" + std::to_string(image.size()) + "}");
    text.members["images"] = R"([{"bufferView":4,"mimeType":"image/png"}])";
    text.members["textures"] = R"([{"source":0}])";
    text.members["materials"] = R"([{"emissiveTexture":{"index":0}}])";
    const Scene scene = load(text);
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.textures[0].mips[0], Bytes(16, 77));
}

TEST_F(GltfMaterial, UnusedImagesAreNotDecoded) {
    GltfText text;
    text.members["images"] = R"([{"uri":")" + data_uri(Bytes{1, 2, 3}) + R"("}])";
    EXPECT_TRUE(load(text).textures.empty());
}

}  // namespace
}  // namespace weft::scene::test
