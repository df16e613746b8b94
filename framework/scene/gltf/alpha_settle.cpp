#include "scene/gltf/alpha_settle.h"

#include <algorithm>
#include <optional>

namespace weft::scene::gltf {
namespace {

bool is_opaque(const Texture& texture) {
    const std::vector<uint8_t>& rgba = texture.mips.front();
    for (size_t i = 3; i < rgba.size(); i += 4) {
        if (rgba[i] != 255) return false;
    }
    return true;
}

bool is_opaque(const Mesh& mesh) {
    return std::ranges::all_of(mesh.colors, [](const glm::vec4& color) { return color.a >= 1; });
}

// Returns one value per material: true if a mesh that has vertex colours with an alpha below 1 uses the
// material.
std::vector<bool> with_translucent_meshes(const BuiltMeshes& built, size_t materials) {
    std::vector<bool> translucent(materials, false);
    for (const std::vector<BuiltPrimitive>& primitives : built.of_gltf_mesh) {
        for (const BuiltPrimitive& primitive : primitives) {
            if (primitive.material != kNone && !is_opaque(built.meshes[primitive.mesh]))
                translucent[primitive.material] = true;
        }
    }
    return translucent;
}

}  // namespace

void settle_alpha(const BuiltMeshes& built, const std::vector<Texture>& textures,
                  std::vector<Material>& materials) {
    const std::vector<bool> translucent = with_translucent_meshes(built, materials.size());
    // Stores for each texture whether the texture is opaque. So each texture is inspected only once, even
    // when many materials use it.
    std::vector<std::optional<bool>> opaque(textures.size());
    const auto is_opaque_texture = [&](uint32_t texture) {
        if (!opaque[texture]) opaque[texture] = is_opaque(textures[texture]);
        return *opaque[texture];
    };
    for (size_t i = 0; i < materials.size(); ++i) {
        Material& material = materials[i];
        if (material.alpha_mode != AlphaMode::blend || material.transmission > 0) continue;
        if (material.base_color.a < 1 || translucent[i]) continue;
        const uint32_t texture = material.base_color_texture.texture;
        if (texture == kNone || is_opaque_texture(texture)) material.alpha_mode = AlphaMode::opaque;
    }
}

}  // namespace weft::scene::gltf
