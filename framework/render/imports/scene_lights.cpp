#include "render/imports/scene_lights.h"

#include <algorithm>

#include "render/imports/light_changes.h"
#include "render/imports/scene_buffers.h"

namespace weft::render {
namespace {

// Least number of lights that the buffer has room for: in a frame, a program may give more lights than the
// scene has.
constexpr size_t kLeastRoom = 1024;

}  // namespace

uint32_t scene_light_capacity(const scene::Scene* scene) {
    return static_cast<uint32_t>(std::max(kLeastRoom, scene != nullptr ? scene->lights.size() : 0));
}

ImportDecl scene_lights_import(const scene::Scene* scene) {
    return scene_buffer(kSceneLights, scene_light_capacity(scene), sizeof(shared::Light));
}

ImportDecl light_changes_import() {
    return scene_buffer(kLightChanges, shared::kMostLightChanges, sizeof(shared::LightChange));
}

Result<FrameBuffer> FrameBuffer::create(vk::Device& device, const char* name, uint64_t bytes) {
    FrameBuffer made;
    for (uint32_t slot = 0; slot < vk::kFramesInFlight; ++slot) {
        Result<vk::Buffer> buffer = vk::Buffer::create(
            device, bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
            vk::Buffer::Memory::upload, name);
        if (!buffer) return buffer.take_errors();
        made.buffers_.push_back(std::move(*buffer));
    }
    made.slot_versions_.assign(vk::kFramesInFlight, 0);
    return made;
}

void FrameBuffer::write(uint32_t slot, std::span<const std::byte> bytes) {
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

void FrameBuffer::bind(const char* import, vk::ImportBindings& to) const {
    bind_scene_buffer(import, buffers_, to);
}

Result<SceneLights> SceneLights::create(vk::Device& device, uint32_t capacity) {
    SceneLights made;
    Result<FrameBuffer> lights =
        FrameBuffer::create(device, "scene lights", uint64_t{capacity} * sizeof(shared::Light));
    if (!lights) return lights.take_errors();
    made.lights_ = std::move(*lights);
    Result<FrameBuffer> changes = FrameBuffer::create(
        device, "light changes", uint64_t{shared::kMostLightChanges} * sizeof(shared::LightChange));
    if (!changes) return changes.take_errors();
    made.changes_ = std::move(*changes);
    return made;
}

void SceneLights::write(uint32_t slot, std::span<const shared::Light> lights) {
    lights_.write(slot, std::as_bytes(lights));
    // The first frame has no previous frame to compare with.
    std::vector<shared::LightChange> changes =
        last_ ? light_changes(*last_, lights) : std::vector<shared::LightChange>();
    // The elements behind the last change are 0, which ends the list.
    changes.resize(shared::kMostLightChanges);
    changes_.write(slot, std::as_bytes(std::span(changes)));
    last_.emplace(lights.begin(), lights.end());
}

void SceneLights::add_versions(std::map<std::string, uint64_t, std::less<>>& to) const {
    to.emplace(kSceneLights, lights_.version());
    to.emplace(kLightChanges, changes_.version());
}

void SceneLights::bind(vk::ImportBindings& to) const {
    lights_.bind(kSceneLights, to);
    changes_.bind(kLightChanges, to);
}

}  // namespace weft::render
