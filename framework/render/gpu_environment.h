// Purpose: the environment map of a scene, and its small version for lighting, as textures with mip levels. A
// scene without an environment gets one black texel.
#pragma once

#include "vulkan/device/handle.h"
#include "weft/scene/environment.h"
#include "weft/vulkan/memory.h"

namespace weft::render {

class GpuEnvironment {
 public:
    [[nodiscard]] static Result<GpuEnvironment> create(vk::Device& device,
                                                       const scene::Environment& environment);

    // Returns the texture with a sampler that repeats it horizontally and clamps it at the poles.
    [[nodiscard]] VkDescriptorImageInfo descriptor() const;
    // Returns Environment::light with the same sampler.
    [[nodiscard]] VkDescriptorImageInfo light_descriptor() const;

 private:
    vk::Image image_;
    vk::Image light_image_;
    vk::SamplerHandle sampler_;
};

}  // namespace weft::render
