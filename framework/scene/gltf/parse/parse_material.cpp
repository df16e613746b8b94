#include "scene/gltf/parse/parse_material.h"

#include <tiny_gltf.h>
#include <algorithm>
#include <cmath>

#include "scene/gltf/parse/values.h"

namespace weft::scene::gltf {
namespace {

Wrap wrap_of(int mode) {
    if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp_to_edge;
    return mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirrored_repeat : Wrap::repeat;
}

void apply_sampler(const tinygltf::Sampler& sampler, TextureSlot& slot) {
    slot.wrap_u = wrap_of(sampler.wrapS);
    slot.wrap_v = wrap_of(sampler.wrapT);
    slot.mag = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ? Filter::nearest : Filter::linear;
    const int min = sampler.minFilter;
    slot.mipmapped = min != TINYGLTF_TEXTURE_FILTER_NEAREST && min != TINYGLTF_TEXTURE_FILTER_LINEAR;
    const bool nearest = min == TINYGLTF_TEXTURE_FILTER_NEAREST ||
                         min == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
                         min == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR;
    slot.min = nearest ? Filter::nearest : Filter::linear;
}

// Returns the matrix for KHR_texture_transform. The extension rotates uvs counter-clockwise, as seen on an
// image whose v axis points down.
glm::mat3x2 uv_transform(const tinygltf::Value& extension) {
    const glm::vec2 offset = vector_or(number_array(extension, "offset"), glm::vec2(0));
    const glm::vec2 scale = vector_or(number_array(extension, "scale"), glm::vec2(1));
    const auto angle = static_cast<float>(number_or(extension, "rotation", 0));
    const float cosine = std::cos(angle);
    const float sine = std::sin(angle);
    return {cosine * scale.x, -sine * scale.x, sine * scale.y, cosine * scale.y, offset.x, offset.y};
}

template <class TextureInfo>
TextureSlot convert_slot(const TextureInfo& info, const tinygltf::Model& model) {
    TextureSlot slot;
    if (info.index < 0) return slot;
    slot.texture = static_cast<uint32_t>(info.index);
    double uv_set = info.texCoord;
    const int sampler = model.textures[slot.texture].sampler;
    if (sampler >= 0) apply_sampler(model.samplers[static_cast<size_t>(sampler)], slot);
    if (const tinygltf::Value* extension = find_extension(info.extensions, "KHR_texture_transform")) {
        slot.transform = uv_transform(*extension);
        uv_set = number_or(*extension, "texCoord", uv_set);
    }
    slot.uv_set = uv_set == 1 ? 1 : 0;
    return slot;
}

float unit(double value) {
    return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

void apply_material_extensions(const tinygltf::ExtensionMap& extensions, Material& out) {
    if (const tinygltf::Value* specular = find_extension(extensions, "KHR_materials_specular")) {
        out.specular = unit(number_or(*specular, "specularFactor", 1));
        const glm::vec3 color = vector_or(number_array(*specular, "specularColorFactor"), glm::vec3(1));
        out.specular_color = glm::max(color, glm::vec3(0));
    }
    if (const tinygltf::Value* ior = find_extension(extensions, "KHR_materials_ior")) {
        out.ior = std::max(0.0f, static_cast<float>(number_or(*ior, "ior", 1.5)));
    }
    if (const tinygltf::Value* strength = find_extension(extensions, "KHR_materials_emissive_strength")) {
        out.emissive *= std::max(0.0f, static_cast<float>(number_or(*strength, "emissiveStrength", 1)));
    }
}

// Reads a texture reference in the JSON of an extension. tinygltf parses only the texture references of the
// core specification. References in extensions have the same form.
TextureSlot extension_slot(const tinygltf::Value& extension, const char* key, const tinygltf::Model& model) {
    if (!extension.Has(key)) return {};
    const tinygltf::Value& info = extension.Get(key);
    tinygltf::TextureInfo core;
    core.index = static_cast<int>(number_or(info, "index", -1));
    core.texCoord = static_cast<int>(number_or(info, "texCoord", 0));
    if (info.Has("extensions")) {
        const tinygltf::Value& extensions = info.Get("extensions");
        for (const std::string& name : extensions.Keys()) core.extensions.emplace(name, extensions.Get(name));
    }
    return convert_slot(core, model);
}

void apply_anisotropy(const tinygltf::ExtensionMap& extensions, const tinygltf::Model& model, Material& out) {
    const tinygltf::Value* anisotropy = find_extension(extensions, "KHR_materials_anisotropy");
    if (anisotropy == nullptr) return;
    out.anisotropy = unit(number_or(*anisotropy, "anisotropyStrength", 0));
    constexpr double kFullTurn = 6.283185307179586;
    const double rotation = std::remainder(number_or(*anisotropy, "anisotropyRotation", 0), kFullTurn);
    out.anisotropy_rotation_rad = static_cast<float>(rotation);
    out.anisotropy_texture = extension_slot(*anisotropy, "anisotropyTexture", model);
}

void apply_clearcoat(const tinygltf::ExtensionMap& extensions, Material& out) {
    const tinygltf::Value* coat = find_extension(extensions, "KHR_materials_clearcoat");
    if (coat == nullptr) return;
    out.clearcoat = unit(number_or(*coat, "clearcoatFactor", 0));
    out.clearcoat_roughness = unit(number_or(*coat, "clearcoatRoughnessFactor", 0));
}

// Implements KHR_materials_volume: the body behind the surface.
void apply_volume(const tinygltf::ExtensionMap& extensions, Material& out) {
    const tinygltf::Value* volume = find_extension(extensions, "KHR_materials_volume");
    if (volume == nullptr) return;
    out.thickness_m = std::max(0.0f, static_cast<float>(number_or(*volume, "thicknessFactor", 0)));
    const auto distance_m = static_cast<float>(number_or(*volume, "attenuationDistance", 0));
    if (distance_m <= 0) return;
    constexpr float kDarkest = 1e-4f;
    const glm::vec3 color = vector_or(number_array(*volume, "attenuationColor"), glm::vec3(1));
    constexpr float kMostAbsorption_per_m = 1e6f;
    const glm::vec3 passed = glm::clamp(color, glm::vec3(kDarkest), glm::vec3(1));
    out.absorption_per_m = glm::min(-glm::log(passed) / distance_m, glm::vec3(kMostAbsorption_per_m));
}

// Implements KHR_materials_transmission. The surface is drawn after the opaque ones,
// even if its alpha mode is OPAQUE. A mask cannot be transmissive.
void apply_transmission(const tinygltf::ExtensionMap& extensions, Material& out) {
    const tinygltf::Value* transmission = find_extension(extensions, "KHR_materials_transmission");
    if (transmission == nullptr || out.alpha_mode == AlphaMode::mask) return;
    out.transmission = unit(number_or(*transmission, "transmissionFactor", 0));
    if (out.transmission == 0) return;
    if (out.alpha_mode == AlphaMode::opaque) out.base_color.a = 1;
    out.alpha_mode = AlphaMode::blend;
}

void apply_diffuse_transmission(const tinygltf::ExtensionMap& extensions, Material& out) {
    const tinygltf::Value* scattered = find_extension(extensions, "KHR_materials_diffuse_transmission");
    if (scattered == nullptr) return;
    out.diffuse_transmission = unit(number_or(*scattered, "diffuseTransmissionFactor", 0));
    const glm::vec3 color =
        vector_or(number_array(*scattered, "diffuseTransmissionColorFactor"), glm::vec3(1));
    out.diffuse_transmission_color = glm::clamp(color, glm::vec3(0), glm::vec3(1));
}

// Implements KHR_materials_unlit: the surface shows its base colour and ignores lights. The material becomes
// a black surface that emits the base colour.
void make_unlit(Material& out) {
    out.emissive = glm::vec3(out.base_color);
    out.emissive_texture = out.base_color_texture;
    out.tinted_emission = true;
    out.base_color = glm::vec4(0, 0, 0, out.base_color.a);
    out.metallic = 0;
    out.specular = 0;
    out.roughness = 1;
    out.normal_texture = {};
    out.anisotropy = 0;
    out.clearcoat = 0;
}

}  // namespace

Material convert_material(const tinygltf::Material& source, const tinygltf::Model& model) {
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    Material out;
    out.name = source.name;
    out.base_color = glm::clamp(vector_or(pbr.baseColorFactor, glm::vec4(1)), glm::vec4(0), glm::vec4(1));
    out.metallic = unit(pbr.metallicFactor);
    out.roughness = unit(pbr.roughnessFactor);
    out.emissive = glm::max(vector_or(source.emissiveFactor, glm::vec3(0)), glm::vec3(0));
    out.normal_scale = static_cast<float>(source.normalTexture.scale);
    out.occlusion_strength = unit(source.occlusionTexture.strength);
    out.alpha_mode = source.alphaMode == "MASK"    ? AlphaMode::mask
                     : source.alphaMode == "BLEND" ? AlphaMode::blend
                                                   : AlphaMode::opaque;
    out.alpha_cutoff = std::max(0.0f, static_cast<float>(source.alphaCutoff));
    out.double_sided = source.doubleSided;
    out.base_color_texture = convert_slot(pbr.baseColorTexture, model);
    out.metallic_roughness_texture = convert_slot(pbr.metallicRoughnessTexture, model);
    out.normal_texture = convert_slot(source.normalTexture, model);
    out.occlusion_texture = convert_slot(source.occlusionTexture, model);
    out.emissive_texture = convert_slot(source.emissiveTexture, model);
    apply_material_extensions(source.extensions, out);
    apply_anisotropy(source.extensions, model, out);
    apply_clearcoat(source.extensions, out);
    if (find_extension(source.extensions, "KHR_materials_unlit") != nullptr) {
        make_unlit(out);
        return out;
    }
    apply_transmission(source.extensions, out);
    apply_diffuse_transmission(source.extensions, out);
    if (out.transmission > 0 || out.diffuse_transmission > 0) apply_volume(source.extensions, out);
    return out;
}

}  // namespace weft::scene::gltf
