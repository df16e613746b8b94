#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "scene/gltf/gltf_rules.h"

namespace weft::scene::gltf {
namespace {

void check_one_of(const Fields& fields, const char* key, std::initializer_list<uint64_t> values) {
    const std::optional<uint64_t> value = fields.integer(key, Need::optional, 0, UINT16_MAX);
    if (!value || std::find(values.begin(), values.end(), *value) != values.end()) return;
    std::string wanted = "one of";
    for (const uint64_t allowed : values) wanted.append(" ").append(std::to_string(allowed));
    fields.wrong(key, wanted);
}

void check_images(Checker& c) {
    c.root.each("images", c.limits.materials, [&](const Fields& image) {
        ImageSource source;
        source.name = image.text("name", Need::optional).value_or("");
        source.uri = image.text("uri", Need::optional).value_or("");
        source.view = image.index("bufferView", Need::optional, c.view_lengths.size(), "bufferViews");
        if (image.has("uri") == image.has("bufferView")) {
            image.wrong(
                "uri",
                image.has("uri") ? "given together with \"bufferView\"" : "missing, and so is \"bufferView\"",
                "exactly one of the two keys");
        }
        c.out.images.push_back(std::move(source));
    });
}

void check_texture(Checker& c, const Fields& texture) {
    texture.index("source", Need::optional, c.sizes["images"], "images");
    texture.index("sampler", Need::optional, c.sizes["samplers"], "samplers");
    if (texture.has("source")) return;
    if (texture.extension("KHR_texture_basisu")) {
        c.report.error(
            "S117", texture.pointer_to("extensions/KHR_texture_basisu"),
            "the texture has only an image in the Basis format (KHR_texture_basisu)",
            "convert the texture to PNG or JPEG, or give it a \"source\" with a PNG or JPEG image");
        return;
    }
    c.report.warn("S153", texture.pointer(), "the texture has no PNG or JPEG image and is ignored",
                  "export textures as PNG or JPEG");
}

void check_texture_info(Checker& c, const Fields& parent, const char* key) {
    const std::optional<Fields> info = parent.object(key, Need::optional);
    if (!info) return;
    info->index("index", Need::required, c.sizes["textures"], "textures");
    uint64_t set = info->integer("texCoord", Need::optional, 0, 64).value_or(0);
    info->number("scale", Need::optional);
    info->number("strength", Need::optional);
    if (const std::optional<Fields> transform = info->extension("KHR_texture_transform")) {
        transform->numbers("offset", 2);
        transform->numbers("scale", 2);
        transform->number("rotation", Need::optional);
        set = transform->integer("texCoord", Need::optional, 0, 64).value_or(set);
    }
    if (set <= 1) return;
    c.report.warn(
        "S153", info->pointer_to("texCoord"),
        "texture coordinate set " + std::to_string(set) + " is not supported; set 0 is used instead",
        "export this texture with TEXCOORD_0 or TEXCOORD_1");
}

void warn_of_textures(Checker& c, const Fields& extension, std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
        if (!extension.has(key)) continue;
        c.report.warn("S153", extension.pointer_to(key),
                      std::string(key) + " is ignored; only the factor is used",
                      "set the factor to the average of the texture");
    }
}

void check_transmission(Checker& c, const Fields& material) {
    if (const auto transmission = material.extension("KHR_materials_transmission")) {
        transmission->number_in("transmissionFactor", 0, 1);
        warn_of_textures(c, *transmission, {"transmissionTexture"});
    }
    if (const auto scattered = material.extension("KHR_materials_diffuse_transmission")) {
        scattered->number_in("diffuseTransmissionFactor", 0, 1);
        scattered->numbers("diffuseTransmissionColorFactor", 3);
        warn_of_textures(c, *scattered, {"diffuseTransmissionTexture", "diffuseTransmissionColorTexture"});
    }
    if (const auto volume = material.extension("KHR_materials_volume")) {
        volume->number_in("thicknessFactor", 0, kUnbounded);
        volume->number_in("attenuationDistance", 0, kUnbounded);
        volume->numbers("attenuationColor", 3);
        warn_of_textures(c, *volume, {"thicknessTexture"});
    }
}

void check_material_extensions(Checker& c, const Fields& material) {
    if (const std::optional<Fields> specular = material.extension("KHR_materials_specular")) {
        specular->number_in("specularFactor", 0, 1);
        specular->numbers("specularColorFactor", 3);
        warn_of_textures(c, *specular, {"specularTexture", "specularColorTexture"});
    }
    if (const auto coat = material.extension("KHR_materials_clearcoat")) {
        coat->number_in("clearcoatFactor", 0, 1);
        coat->number_in("clearcoatRoughnessFactor", 0, 1);
        warn_of_textures(c, *coat,
                         {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"});
    }
    check_transmission(c, material);
    if (const auto ior = material.extension("KHR_materials_ior")) ior->number_in("ior", 0, kUnbounded);
    if (const auto strength = material.extension("KHR_materials_emissive_strength")) {
        strength->number_in("emissiveStrength", 0, kUnbounded);
    }
    if (const auto anisotropy = material.extension("KHR_materials_anisotropy")) {
        anisotropy->number_in("anisotropyStrength", 0, 1);
        anisotropy->number("anisotropyRotation", Need::optional);
        check_texture_info(c, *anisotropy, "anisotropyTexture");
    }
}

void check_material(Checker& c, const Fields& material) {
    material.text("name", Need::optional);
    material.numbers("emissiveFactor", 3);
    material.boolean("doubleSided");
    material.number_in("alphaCutoff", 0, kUnbounded);
    const std::string mode = material.text("alphaMode", Need::optional).value_or("OPAQUE");
    if (mode != "OPAQUE" && mode != "MASK" && mode != "BLEND")
        material.wrong("alphaMode", "OPAQUE, MASK or BLEND");
    if (const std::optional<Fields> pbr = material.object("pbrMetallicRoughness", Need::optional)) {
        pbr->numbers("baseColorFactor", 4);
        pbr->number_in("metallicFactor", 0, 1);
        pbr->number_in("roughnessFactor", 0, 1);
        check_texture_info(c, *pbr, "baseColorTexture");
        check_texture_info(c, *pbr, "metallicRoughnessTexture");
    }
    for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"}) {
        check_texture_info(c, material, key);
    }
    check_material_extensions(c, material);
}

}  // namespace

void check_materials(Checker& c) {
    check_images(c);
    c.root.each("textures", c.limits.materials, [&](const Fields& texture) { check_texture(c, texture); });
    c.root.each("samplers", c.limits.array_items, [](const Fields& sampler) {
        check_one_of(sampler, "magFilter", {9728, 9729});
        check_one_of(sampler, "minFilter", {9728, 9729, 9984, 9985, 9986, 9987});
        check_one_of(sampler, "wrapS", {10497, 33071, 33648});
        check_one_of(sampler, "wrapT", {10497, 33071, 33648});
    });
    c.root.each("materials", c.limits.materials,
                [&](const Fields& material) { check_material(c, material); });
}

// The keys of the object `extras.weft` of a material: `ripples`, four numbers, and `diffuseRoughness`, an
// angle in radians.
void check_material_extras(Checker& c, const nlohmann::json& extras) {
    uint32_t self = 0;
    c.root.each("materials", c.limits.materials, [&](const Fields& material) {
        const uint32_t index = self++;
        const std::optional<Fields> fields =
            extras_object(c, extras[index], material.pointer_to("extras/weft"),
                          "write for example { \"ripples\": [0.02, 0.01, -0.01, 0.02] }, or remove the key");
        if (!fields) return;
        warn_of_other_keys(c, *fields, {"ripples", "diffuseRoughness"});
        fields->number_in("diffuseRoughness", 0, kHalfPi);
        if (const std::optional<double> roughness = fields->number("diffuseRoughness", Need::optional))
            c.out.diffuse_roughness_rad[index] = static_cast<float>(std::clamp(*roughness, 0.0, kHalfPi));
        const std::vector<double> ripples = fields->numbers("ripples", 4);
        if (!ripples.empty())
            c.out.ripples[index] = glm::vec4(ripples[0], ripples[1], ripples[2], ripples[3]);
    });
}

}  // namespace weft::scene::gltf
