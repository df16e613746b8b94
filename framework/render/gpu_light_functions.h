// Purpose: the scene's light functions for descriptor set 0: a buffer of functions and an array of pictures
// (gobos). If the scene has none, each contains one unused element.
#pragma once

#include "vulkan/device/handle.h"
#include "weft/scene/scene.h"
#include "weft/vulkan/memory.h"

namespace weft::render {

class GpuLightFunctions {
 public:
    [[nodiscard]] static Result<GpuLightFunctions> create(vk::Device& device, const scene::Scene& scene);

    [[nodiscard]] VkDescriptorBufferInfo functions() const { return {functions_.handle(), 0, VK_WHOLE_SIZE}; }
    // Returns the array of pictures with a sampler that repeats them in all directions.
    [[nodiscard]] VkDescriptorImageInfo pictures() const;

 private:
    vk::Buffer functions_;
    vk::Image pictures_;
    vk::SamplerHandle sampler_;
};

}  // namespace weft::render
