// Purpose: the light functions of a scene for descriptor set 0. A light function shapes the light of a lamp
// with doors, a picture (gobo) and a falloff curve. There is a buffer of functions and an array of pictures.
// A scene without functions or without pictures gets one unused element instead.
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
