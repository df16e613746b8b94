// Purpose: what surrounds a scene as a texture with mips; a black texel where there is no environment.
#pragma once

#include "vulkan/device/handle.h"
#include "weft/scene/environment.h"
#include "weft/vulkan/memory.h"

namespace weft::render {

class GpuEnvironment {
 public:
    [[nodiscard]] static Result<GpuEnvironment> create(vk::Device& device,
                                                       const scene::Environment& environment);

    // Around the sides it repeats, at the poles it ends.
    [[nodiscard]] VkDescriptorImageInfo descriptor() const;

 private:
    vk::Image image_;
    vk::SamplerHandle sampler_;
};

}  // namespace weft::render
