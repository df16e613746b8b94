// Purpose: set 0 of every frame in flight: frame constants and the view, in host-written memory, one copy a
// slot, and what all frames share: the environment and what shapes the lights.
#pragma once

#include "render/descriptor_sets.h"
#include "render/frame_data.h"
#include "render/gpu_environment.h"
#include "render/gpu_light_functions.h"
#include "vulkan/executor.h"

namespace weft::render {

class GpuFrame {
 public:
    [[nodiscard]] static Result<GpuFrame> create(vk::Device& device, const scene::Scene& scene);

    // The slot must not be in flight: Executor::begin_frame() says which one is free.
    void write(uint32_t slot, const shared::FrameConstants& frame, const shared::ViewConstants& camera);
    [[nodiscard]] VkDescriptorSetLayout layout() const { return sets_.layout.get(); }
    [[nodiscard]] VkDescriptorSet set(uint32_t slot) const { return sets_.sets[slot]; }

 private:
    DescriptorSets sets_;  // one a slot
    vk::Buffer constants_;
    GpuEnvironment environment_;
    GpuLightFunctions light_functions_;
};

}  // namespace weft::render
