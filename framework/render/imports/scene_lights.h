// Purpose: the lights of the scene as the import "sceneLights" (shared::Light), in the order of the frame
// constants light_count, directional_count and plain_count. Also the lights that differ from those of the
// previous frame, as the import "lightChanges" (shared::LightChange). The versions of these imports change
// only if their content changes. So passes with "rest", which run only if an input has changed, can read
// them. They cannot read the buffer that the pass type light_upload writes, because such a pass runs in every
// frame. Errors: those of vk::Buffer::create().
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shared/light.glsl"
#include "weft/imports.h"
#include "weft/scene/scene.h"
#include "weft/vulkan/executor.h"

namespace weft::render {

inline constexpr const char* kSceneLights = "sceneLights";
inline constexpr const char* kLightChanges = "lightChanges";

// Returns the number of lights that the import has room for. Further lights are left out.
[[nodiscard]] uint32_t scene_light_capacity(const scene::Scene* scene);
[[nodiscard]] ImportDecl scene_lights_import(const scene::Scene* scene);
[[nodiscard]] ImportDecl light_changes_import();

// A buffer that the CPU writes in each frame. Each frame slot has its own copy.
class FrameBuffer {
 public:
    FrameBuffer() = default;
    [[nodiscard]] static Result<FrameBuffer> create(vk::Device& device, const char* name, uint64_t bytes);
    // Writes the first bytes of the buffer; further bytes do not change. The frame slot must not be in
    // flight.
    void write(uint32_t slot, std::span<const std::byte> bytes);
    [[nodiscard]] uint64_t version() const { return version_; }
    // Adds the buffer to the imports of an executor.
    void bind(const char* import, vk::ImportBindings& to) const;

 private:
    std::vector<vk::Buffer> buffers_;  // Index: frame slot.
    std::vector<std::byte> content_;   // The bytes of the last write().
    std::vector<uint64_t> slot_versions_;
    uint64_t version_ = 1;
};

class SceneLights {
 public:
    SceneLights() = default;
    // Creates the buffers. `capacity` is the number of lights that the import has room for.
    [[nodiscard]] static Result<SceneLights> create(vk::Device& device, uint32_t capacity);
    // Writes the lights of a frame, and how they differ from those of the last call. The frame slot must not
    // be in flight.
    void write(uint32_t slot, std::span<const shared::Light> lights);
    void add_versions(std::map<std::string, uint64_t, std::less<>>& to) const;
    void bind(vk::ImportBindings& to) const;

 private:
    FrameBuffer lights_;
    FrameBuffer changes_;
    std::optional<std::vector<shared::Light>> last_;  // The lights of the last write().
};

}  // namespace weft::render
