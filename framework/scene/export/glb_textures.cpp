#include "scene/export/glb_textures.h"

#include <tiny_gltf.h>

#include <cmath>

#include "scene/pictures/png_encode.h"

namespace weft::scene::glb {
namespace {

int wrap_mode(Wrap wrap) {
    if (wrap == Wrap::clamp_to_edge) return TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    return wrap == Wrap::mirrored_repeat ? TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT
                                         : TINYGLTF_TEXTURE_WRAP_REPEAT;
}

int mag_filter(const TextureSlot& slot) {
    return slot.mag == Filter::nearest ? TINYGLTF_TEXTURE_FILTER_NEAREST : TINYGLTF_TEXTURE_FILTER_LINEAR;
}

int min_filter(const TextureSlot& slot) {
    const bool nearest = slot.min == Filter::nearest;
    if (!slot.mipmapped) return nearest ? TINYGLTF_TEXTURE_FILTER_NEAREST : TINYGLTF_TEXTURE_FILTER_LINEAR;
    return nearest ? TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST
                   : TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
}

}  // namespace

Status add_images(const std::vector<Texture>& textures, tinygltf::Model& out) {
    for (const Texture& texture : textures) {
        const Result<std::string> png =
            encode_png(texture.width_px, texture.height_px, std::as_bytes(std::span(texture.mips.front())));
        if (!png) return png.errors();
        tinygltf::Image image;
        image.name = texture.name;
        image.mimeType = "image/png";
        image.bufferView = add_view(out, std::as_bytes(std::span(*png)), 0);
        out.images.push_back(std::move(image));
    }
    return Unit{};
}

int TextureTable::sampler_of(const TextureSlot& slot) {
    tinygltf::Sampler sampler;
    sampler.magFilter = mag_filter(slot);
    sampler.minFilter = min_filter(slot);
    sampler.wrapS = wrap_mode(slot.wrap_u);
    sampler.wrapT = wrap_mode(slot.wrap_v);
    const auto [found, is_new] =
        samplers_.try_emplace({sampler.magFilter, sampler.minFilter, sampler.wrapS, sampler.wrapT},
                              static_cast<int>(out_.samplers.size()));
    if (is_new) out_.samplers.push_back(sampler);
    return found->second;
}

int TextureTable::texture_with(uint32_t image, int sampler) {
    const auto [found, is_new] =
        textures_.try_emplace({image, sampler}, static_cast<int>(out_.textures.size()));
    if (is_new) {
        tinygltf::Texture texture;
        texture.source = static_cast<int>(image);
        texture.sampler = sampler;
        out_.textures.push_back(std::move(texture));
    }
    return found->second;
}

int TextureTable::texture_of(const TextureSlot& slot) {
    return texture_with(slot.texture, sampler_of(slot));
}

int TextureTable::texture_without_sampler(uint32_t texture) {
    return texture_with(texture, -1);
}

// The matrix of the slot has the columns (cos · x, −sin · x) and (sin · y, cos · y), where (x, y) is the
// scale of the extension. A matrix with shear has no such form; its rotation and scale are approximated.
void TextureTable::add_transform(const TextureSlot& slot,
                                 std::map<std::string, tinygltf::Value>& extensions) {
    const glm::vec2 u = slot.transform[0], v = slot.transform[1];
    const float angle = std::atan2(-u.y, u.x);
    const float scale_v = glm::dot(v, glm::vec2(std::sin(angle), std::cos(angle)));
    tinygltf::Value::Object transform;
    transform["offset"] = json_array(slot.transform[2]);
    transform["rotation"] = json_number(angle);
    transform["scale"] = json_array(glm::vec2(glm::length(u), scale_v));
    add_extension(out_, extensions, "KHR_texture_transform", std::move(transform));
}

tinygltf::Value TextureTable::value_of(const TextureSlot& slot) {
    tinygltf::TextureInfo info;
    describe(slot, info);
    tinygltf::Value::Object value;
    value["index"] = tinygltf::Value(info.index);
    value["texCoord"] = tinygltf::Value(info.texCoord);
    if (!info.extensions.empty())
        value["extensions"] = tinygltf::Value(tinygltf::Value::Object(info.extensions));
    return tinygltf::Value(std::move(value));
}

}  // namespace weft::scene::glb
