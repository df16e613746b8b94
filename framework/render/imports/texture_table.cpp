#include "render/imports/texture_table.h"

#include <map>
#include <utility>

namespace weft::render {

SamplerKey sampler_key(const scene::TextureSlot& slot) {
    return {slot.mag, slot.min, slot.mipmapped, slot.wrap_u, slot.wrap_v};
}

TextureTable texture_table(const scene::Scene& scene) {
    TextureTable table;
    table.entries.resize(2);
    std::map<std::pair<uint32_t, SamplerKey>, uint32_t> known;
    const auto index = [&](const scene::TextureSlot& slot, uint32_t fallback) {
        if (slot.texture >= scene.textures.size()) return fallback;
        const auto [entry, added] = known.try_emplace(std::pair(slot.texture, sampler_key(slot)),
                                                      static_cast<uint32_t>(table.entries.size()));
        if (added) table.entries.push_back(slot);
        return entry->second;
    };
    table.materials.reserve(scene.materials.size());
    for (const scene::Material& m : scene.materials)
        table.materials.push_back(
            {index(m.base_color_texture, kWhiteEntry), index(m.metallic_roughness_texture, kWhiteEntry),
             index(m.normal_texture, kFlatNormalEntry), index(m.occlusion_texture, kWhiteEntry),
             index(m.emissive_texture, kWhiteEntry), index(m.anisotropy_texture, kWhiteEntry)});
    return table;
}

void set_textures(const std::array<uint32_t, 6>& indices, shared::Material& to) {
    to.base_color_texture = indices[0];
    to.metallic_roughness_texture = indices[1];
    to.normal_texture = indices[2];
    to.occlusion_texture = indices[3];
    to.emissive_texture = indices[4];
    to.anisotropy_texture = indices[5];
}

}  // namespace weft::render
