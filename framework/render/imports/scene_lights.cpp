#include "render/imports/scene_lights.h"

#include <algorithm>

#include "render/imports/scene_buffers.h"

namespace weft::render {
namespace {

// A program may give more lights in a frame than the scene has.
constexpr size_t kLeastRoom = 1024;

}  // namespace

uint32_t scene_light_capacity(const scene::Scene* scene) {
    return static_cast<uint32_t>(std::max(kLeastRoom, scene != nullptr ? scene->lights.size() : 0));
}

ImportDecl scene_lights_import(const scene::Scene* scene) {
    return scene_buffer(kSceneLights, scene_light_capacity(scene), sizeof(shared::Light));
}

Result<SceneLights> SceneLights::create(vk::Device& device, uint32_t capacity) {
    SceneLights lights;
    for (uint32_t slot = 0; slot < vk::kFramesInFlight; ++slot) {
        Result<vk::Buffer> buffer =
            vk::Buffer::create(device, uint64_t{capacity} * sizeof(shared::Light),
                               VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                               vk::Buffer::Memory::upload, "scene lights");
        if (!buffer) return buffer.take_errors();
        lights.buffers_.push_back(std::move(*buffer));
    }
    lights.slot_versions_.assign(vk::kFramesInFlight, 0);
    return lights;
}

void SceneLights::write(uint32_t slot, std::span<const shared::Light> lights) {
    std::span<const std::byte> bytes = std::as_bytes(lights);
    const std::span<std::byte> memory = buffers_[slot].mapped();
    bytes = bytes.first(std::min(bytes.size(), memory.size()));
    if (!std::ranges::equal(bytes, content_)) {
        content_.assign(bytes.begin(), bytes.end());
        ++version_;
    }
    if (slot_versions_[slot] == version_) return;
    std::ranges::copy(content_, memory.begin());
    slot_versions_[slot] = version_;
}

void SceneLights::bind(vk::ImportBindings& to) const {
    bind_scene_buffer(kSceneLights, buffers_, to);
}

}  // namespace weft::render
