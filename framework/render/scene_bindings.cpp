#include "render/scene_bindings.h"

#include <array>

#include "render/frame_data.h"
#include "render/views/further_suns.h"
#include "render/views/sun_cascades.h"
#include "shared/material.glsl"
#include "vulkan/device/to_vk.h"

namespace weft::render {
namespace {

constexpr ShaderStageMask kVertex = stage_bit(ShaderStage::vertex);
constexpr ShaderStageMask kDraws = kVertex | stage_bit(ShaderStage::fragment);
constexpr ShaderStageMask kAll = kDraws | stage_bit(ShaderStage::compute);

constexpr OfferedBinding block(uint32_t set, uint32_t binding, ShaderStageMask stages, size_t bytes) {
    return {set, binding, BindingKind::uniform_buffer, stages, static_cast<uint32_t>(bytes), false};
}
constexpr OfferedBinding buffer(uint32_t set, uint32_t binding, ShaderStageMask stages) {
    return {set, binding, BindingKind::storage_buffer, stages, 0, false};
}
constexpr OfferedBinding image(uint32_t set, uint32_t binding, ShaderStageMask stages, bool arrayed = false) {
    return {set, binding, BindingKind::sampled_image, stages, 0, arrayed};
}

constexpr std::array kBindings{
    block(0, 0, kAll, sizeof(shared::FrameConstants)),
    block(0, 1, kAll, sizeof(shared::ViewConstants)),
    image(0, 2, kAll),  // texture of the environment map
    block(0, 3, kAll, sizeof(shared::SunConstants)),
    buffer(0, 4, kAll),       // array of all light functions
    image(0, 5, kAll, true),  // array texture of the pictures that lights project
    image(0, 6, kAll),        // small texture of the environment map, for lighting
    block(0, 7, kAll, sizeof(shared::FurtherSuns)),
    block(2, 0, kDraws, sizeof(shared::Material)),
    image(2, 1, kDraws),  // texture of the base colour; bindings 2 to 6 are the material's other textures
    image(2, 2, kDraws),
    image(2, 3, kDraws),
    image(2, 4, kDraws),
    image(2, 5, kDraws),
    image(2, 6, kDraws),
    buffer(3, 0, kVertex),  // transforms and offsets of all instances
    buffer(3, 1, kVertex),  // vertex colours of all meshes
    buffer(3, 2, kVertex),  // second uvs of all meshes
};

}  // namespace

std::vector<OfferedBinding> scene_bindings() {
    return {kBindings.begin(), kBindings.end()};
}

std::vector<VkDescriptorSetLayoutBinding> layout_bindings(uint32_t set) {
    std::vector<VkDescriptorSetLayoutBinding> layout;
    for (const OfferedBinding& b : kBindings)
        if (b.set == set)
            layout.push_back({b.binding, vk::to_vk(b.kind), 1, vk::shader_stages_to_vk(b.stages), nullptr});
    return layout;
}

}  // namespace weft::render
