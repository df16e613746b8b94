#include "scene/export/glb_materials.h"

#include <tiny_gltf.h>

#include <algorithm>

namespace weft::scene::glb {
namespace {

using Object = tinygltf::Value::Object;

const char* alpha_mode_of(const Material& material) {
    // The loader draws a material with transmission as transparent also if its alpha mode is OPAQUE.
    const bool clear = material.transmission > 0 && material.base_color.a >= 1;
    if (material.alpha_mode == AlphaMode::opaque || clear) return "OPAQUE";
    return material.alpha_mode == AlphaMode::mask ? "MASK" : "BLEND";
}

void add_core(const Material& from, TextureTable& textures, tinygltf::Material& to) {
    to.pbrMetallicRoughness.baseColorFactor = numbers_of(from.base_color);
    to.pbrMetallicRoughness.metallicFactor = double{from.metallic};
    to.pbrMetallicRoughness.roughnessFactor = double{from.roughness};
    textures.describe(from.base_color_texture, to.pbrMetallicRoughness.baseColorTexture);
    textures.describe(from.metallic_roughness_texture, to.pbrMetallicRoughness.metallicRoughnessTexture);
    textures.describe(from.normal_texture, to.normalTexture);
    textures.describe(from.occlusion_texture, to.occlusionTexture);
    textures.describe(from.emissive_texture, to.emissiveTexture);
    to.normalTexture.scale = double{from.normal_scale};
    to.occlusionTexture.strength = double{from.occlusion_strength};
    to.alphaMode = alpha_mode_of(from);
    to.alphaCutoff = double{from.alpha_cutoff};
    to.doubleSided = from.double_sided;
}

// The factor of glTF is at most 1. Stronger light has KHR_materials_emissive_strength.
void add_emission(const Material& from, tinygltf::Material& to, tinygltf::Model& out) {
    const float strength = std::max({1.0f, from.emissive.r, from.emissive.g, from.emissive.b});
    to.emissiveFactor = numbers_of(from.emissive / strength);
    if (strength > 1)
        add_extension(out, to.extensions, "KHR_materials_emissive_strength",
                      {{"emissiveStrength", json_number(strength)}});
}

// A material whose light has the colours of the vertices is an unlit one: its base colour is the light.
void make_unlit(const Material& from, TextureTable& textures, tinygltf::Material& to, tinygltf::Model& out) {
    to.pbrMetallicRoughness = {};
    to.pbrMetallicRoughness.baseColorFactor =
        numbers_of(glm::vec4(glm::min(from.emissive, glm::vec3(1)), from.base_color.a));
    textures.describe(from.emissive_texture, to.pbrMetallicRoughness.baseColorTexture);
    to.emissiveTexture = {};
    add_extension(out, to.extensions, "KHR_materials_unlit", {});
}

void add_reflection(const Material& from, TextureTable& textures, tinygltf::Material& to,
                    tinygltf::Model& out) {
    if (from.specular != 1 || from.specular_color != glm::vec3(1))
        add_extension(out, to.extensions, "KHR_materials_specular",
                      {{"specularFactor", json_number(from.specular)},
                       {"specularColorFactor", json_array(from.specular_color)}});
    if (from.ior != 1.5f)
        add_extension(out, to.extensions, "KHR_materials_ior", {{"ior", json_number(from.ior)}});
    if (from.clearcoat > 0)
        add_extension(out, to.extensions, "KHR_materials_clearcoat",
                      {{"clearcoatFactor", json_number(from.clearcoat)},
                       {"clearcoatRoughnessFactor", json_number(from.clearcoat_roughness)}});
    if (from.anisotropy == 0) return;
    Object anisotropy{{"anisotropyStrength", json_number(from.anisotropy)},
                      {"anisotropyRotation", json_number(from.anisotropy_rotation_rad)}};
    if (from.anisotropy_texture.texture != kNone)
        anisotropy["anisotropyTexture"] = textures.value_of(from.anisotropy_texture);
    add_extension(out, to.extensions, "KHR_materials_anisotropy", std::move(anisotropy));
}

void add_volume(const Material& from, tinygltf::Material& to, tinygltf::Model& out) {
    Object volume{{"thicknessFactor", json_number(from.thickness_m)}};
    const glm::vec3& absorption = from.absorption_per_m;
    const float largest = std::max({absorption.r, absorption.g, absorption.b});
    if (largest > 0) {
        // At the distance 1 / largest, each colour channel still has a share of at least 1 / e.
        volume["attenuationDistance"] = json_number(1 / largest);
        volume["attenuationColor"] = json_array(glm::exp(-absorption / largest));
    }
    if (from.thickness_m > 0 || largest > 0)
        add_extension(out, to.extensions, "KHR_materials_volume", std::move(volume));
}

void add_transmission(const Material& from, tinygltf::Material& to, tinygltf::Model& out) {
    if (from.transmission > 0)
        add_extension(out, to.extensions, "KHR_materials_transmission",
                      {{"transmissionFactor", json_number(from.transmission)}});
    if (from.diffuse_transmission > 0)
        add_extension(out, to.extensions, "KHR_materials_diffuse_transmission",
                      {{"diffuseTransmissionFactor", json_number(from.diffuse_transmission)},
                       {"diffuseTransmissionColorFactor", json_array(from.diffuse_transmission_color)}});
    if (from.transmission > 0 || from.diffuse_transmission > 0) add_volume(from, to, out);
}

void add_extras(const Material& from, tinygltf::Material& to) {
    Object extras;
    if (from.ripples != glm::vec4(0)) extras["ripples"] = json_array(from.ripples);
    if (from.diffuse_roughness_rad > 0) extras["diffuseRoughness"] = json_number(from.diffuse_roughness_rad);
    if (!extras.empty()) to.extras = tinygltf::Value(Object{{"weft", tinygltf::Value(extras)}});
}

tinygltf::Material material_of(const Material& from, TextureTable& textures, tinygltf::Model& out) {
    tinygltf::Material to;
    to.name = from.name;
    add_core(from, textures, to);
    if (from.tinted_emission) {
        make_unlit(from, textures, to, out);
        return to;
    }
    add_emission(from, to, out);
    add_reflection(from, textures, to, out);
    add_transmission(from, to, out);
    add_extras(from, to);
    return to;
}

}  // namespace

void add_materials(const std::vector<Material>& materials, TextureTable& textures, tinygltf::Model& out) {
    for (const Material& material : materials) out.materials.push_back(material_of(material, textures, out));
}

}  // namespace weft::scene::glb
