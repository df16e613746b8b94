// Purpose: the lights of the scene as the import "sceneLights" (shared::Light), in the order of the frame
// constants light_count, directional_count and plain_count. Unlike the buffer that the pass type light_upload
// writes, its version changes only if a light changes, so passes with "rest" can read it.
// Errors: those of vk::Buffer::create().
#pragma once

#include <span>
#include <vector>

#include "shared/light.glsl"
#include "weft/imports.h"
#include "weft/scene/scene.h"
#include "weft/vulkan/executor.h"

namespace weft::render {

inline constexpr const char* kSceneLights = "sceneLights";

// Returns the number of lights that the import has room for. Further lights are left out.
[[nodiscard]] uint32_t scene_light_capacity(const scene::Scene* scene);
[[nodiscard]] ImportDecl scene_lights_import(const scene::Scene* scene);

class SceneLights {
 public:
    SceneLights() = default;
    [[nodiscard]] static Result<SceneLights> create(vk::Device& device, uint32_t capacity);
    // Writes the lights of a frame. The frame slot must not be in flight.
    void write(uint32_t slot, std::span<const shared::Light> lights);
    [[nodiscard]] uint64_t version() const { return version_; }
    // Adds the buffer to the imports of an executor.
    void bind(vk::ImportBindings& to) const;

 private:
    std::vector<vk::Buffer> buffers_;  // Index: frame slot.
    std::vector<std::byte> content_;   // The bytes of the last write().
    std::vector<uint64_t> slot_versions_;
    uint64_t version_ = 1;
};

}  // namespace weft::render
