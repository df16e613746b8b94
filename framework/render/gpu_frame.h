// Purpose: set 0 of every frame in flight, one set for each view that a pass may use. It has the frame
// constants, the sun's cascades and the view in host-written memory, one copy per slot, and data common to
// all frames: the environment and the light functions.
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

    // The slot must not be in flight: Executor::begin_frame() returns a free one.
    void write(uint32_t slot, const shared::FrameConstants& frame, const shared::ViewConstants& camera,
               const SunCascades& sun);
    [[nodiscard]] VkDescriptorSetLayout layout() const { return sets_.layout.get(); }
    // For a view of import_catalog.h.
    [[nodiscard]] VkDescriptorSet set(uint32_t slot, std::string_view view) const;

 private:
    DescriptorSets sets_;  // index: slot and view
    vk::Buffer constants_;
    GpuEnvironment environment_;
    GpuLightFunctions light_functions_;
};

}  // namespace weft::render
