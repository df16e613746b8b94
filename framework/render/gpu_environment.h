// Purpose: the environment of a scene as a texture with mips; a black texel for a scene without one.
#pragma once

#include "vulkan/device/handle.h"
#include "weft/scene/environment.h"
#include "weft/vulkan/memory.h"

namespace weft::render {

class GpuEnvironment {
 public:
    [[nodiscard]] static Result<GpuEnvironment> create(vk::Device& device,
                                                       const scene::Environment& environment);

    // Repeats horizontally, and is clamped at the poles.
    [[nodiscard]] VkDescriptorImageInfo descriptor() const;

 private:
    vk::Image image_;
    vk::SamplerHandle sampler_;
};

}  // namespace weft::render
