// Purpose: the descriptor sets that are bound as set 0: one for each pair of a frame slot and a view that a
// pass may use. Each set refers to the frame constants, the sun's shadow cascades and its view. The host
// writes these for each frame slot. All sets also refer to the same environment and light functions.
#pragma once

#include "render/descriptor_sets.h"
#include "render/frame_data.h"
#include "render/gpu_environment.h"
#include "render/gpu_light_functions.h"
#include "render/sun_cascades.h"
#include "weft/vulkan/executor.h"

namespace weft::render {

class GpuFrame {
 public:
    [[nodiscard]] static Result<GpuFrame> create(vk::Device& device, const scene::Scene& scene);

    // Writes the constants of a frame slot. The slot must not be in flight: Executor::begin_frame() returns a
    // free one.
    void write(uint32_t slot, const shared::FrameConstants& frame, const shared::ViewConstants& camera,
               const SunCascades& sun);
    [[nodiscard]] VkDescriptorSetLayout layout() const { return sets_.layout.get(); }
    // Appends parts of the uniform blocks of a set; see DrawSource::add_frame_bytes().
    void add_bytes(uint32_t slot, std::string_view view, std::span<const FrameRange> ranges,
                   std::vector<std::byte>& bytes) const;
    // Returns descriptor set 0 for a view such as "camera" or "sun(1)"; see import_catalog.h.
    [[nodiscard]] VkDescriptorSet set(uint32_t slot, std::string_view view) const;

 private:
    // One set for each frame slot and view. Index: slot * kViews + index of the view.
    DescriptorSets sets_;
    vk::Buffer constants_;
    GpuEnvironment environment_;
    GpuLightFunctions light_functions_;
};

}  // namespace weft::render
