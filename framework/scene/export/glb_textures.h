// Purpose: adds the textures of a scene to a glTF file, as PNG images in its buffer, and describes how
// materials use them.
#pragma once

#include <map>
#include <tuple>

#include "scene/export/glb_model.h"
#include "weft/result.h"
#include "weft/scene/scene.h"

namespace weft::scene::glb {

// Adds one image for each texture of the scene, in the same order. The loader computes the mips again, so
// only mip 0 is written.
[[nodiscard]] Status add_images(const std::vector<Texture>& textures, tinygltf::Model& out);

// Makes the textures of the file. A texture of glTF is an image with a sampler, so an image that is used with
// two samplers has two textures.
class TextureTable {
 public:
    explicit TextureTable(tinygltf::Model& out) : out_(out) {}

    // Returns the index of the texture of the file for this slot, which has a texture.
    int texture_of(const TextureSlot& slot);
    // Returns the index of a texture of the file without a sampler, for a texture of the scene.
    int texture_without_sampler(uint32_t texture);

    // Sets the members of a TextureInfo of tinygltf. It stays unset if the slot has no texture.
    template <class TextureInfo>
    void describe(const TextureSlot& slot, TextureInfo& info) {
        if (slot.texture == kNone) return;
        info.index = texture_of(slot);
        info.texCoord = static_cast<int>(slot.uv_set);
        if (slot.transform != glm::mat3x2{1, 0, 0, 1, 0, 0}) add_transform(slot, info.extensions);
    }
    // Returns the same description as a JSON value, for the texture of an extension.
    [[nodiscard]] tinygltf::Value value_of(const TextureSlot& slot);

 private:
    void add_transform(const TextureSlot& slot, std::map<std::string, tinygltf::Value>& extensions);
    int sampler_of(const TextureSlot& slot);
    int texture_with(uint32_t image, int sampler);

    tinygltf::Model& out_;
    std::map<std::tuple<int, int, int, int>, int> samplers_;  // By the four numbers of a sampler.
    std::map<std::tuple<uint32_t, int>, int> textures_;       // By image and sampler.
};

}  // namespace weft::scene::glb
