#include "render/imports/material_textures.h"

#include <map>

#include "render/frame_data.h"

namespace weft::render {

MaterialTextures order_textures(const scene::Scene& scene) {
    MaterialTextures order;
    std::map<uint32_t, uint32_t> known;  // From the index in Scene::textures to the number in the table.
    const auto number = [&](const scene::TextureSlot& slot, uint32_t absent) {
        if (slot.texture >= scene.textures.size()) return absent;
        const auto [entry, added] = known.try_emplace(slot.texture, order.count());
        if (added) order.textures.push_back(slot.texture);
        return entry->second;
    };
    order.materials.reserve(scene.materials.size());
    for (const scene::Material& m : scene.materials) {
        const uint32_t base_color = number(m.base_color_texture, kWhiteEntry);
        const uint32_t metallic_roughness = number(m.metallic_roughness_texture, kWhiteEntry);
        const uint32_t normal = number(m.normal_texture, kFlatNormalEntry);
        const uint32_t occlusion = number(m.occlusion_texture, kWhiteEntry);
        const uint32_t emissive = number(m.emissive_texture, kWhiteEntry);
        const uint32_t anisotropy = number(m.anisotropy_texture, kWhiteEntry);
        order.materials.push_back({base_color, metallic_roughness, normal, occlusion, emissive, anisotropy});
    }
    return order;
}

std::vector<shared::Material> gpu_materials_without_table(const scene::Scene& scene) {
    static_assert(kWhiteEntry == 0, "gpu_material() sets the numbers of textures to 0");
    std::vector<shared::Material> materials;
    materials.reserve(scene.materials.size());
    for (const scene::Material& material : scene.materials) {
        materials.push_back(gpu_material(material));
        materials.back().normal_texture = kFlatNormalEntry;
    }
    return materials;
}

std::vector<shared::Material> gpu_materials(const scene::Scene& scene) {
    const MaterialTextures order = order_textures(scene);
    std::vector<shared::Material> materials;
    materials.reserve(scene.materials.size());
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        shared::Material& to = materials.emplace_back(gpu_material(scene.materials[i]));
        const std::array<uint32_t, 6>& numbers = order.materials[i];
        to.base_color_texture = numbers[0];
        to.metallic_roughness_texture = numbers[1];
        to.normal_texture = numbers[2];
        to.occlusion_texture = numbers[3];
        to.emissive_texture = numbers[4];
        to.anisotropy_texture = numbers[5];
    }
    return materials;
}

}  // namespace weft::render
