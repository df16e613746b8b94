// Purpose: dummy descriptors for bindings that a graph leaves unconnected. For an unconnected binding `x`,
// the shader's constant HAS_x is false, so the shader does not access the binding. But Vulkan requires a
// valid descriptor for every binding that a shader uses statically. Errors: V410 (out of memory), V421 (the
// device does not support the dummy image), V409 (any other failure).
#pragma once

#include <deque>
#include <vector>

#include "weft/shader_interface.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {

class DummyDescriptors {
 public:
    explicit DummyDescriptors(Device& device) : device_(&device) {}

    // Creates an image of one texel (six for cubes) for an unconnected binding. Returns the view of the
    // image, and the layout of the image after the commands of record_layouts(). The caller adds the sampler.
    [[nodiscard]] Result<VkDescriptorImageInfo> image(const ShaderBinding& binding);
    // Creates a buffer of at least `size_bytes` bytes with undefined content, for an unconnected binding.
    [[nodiscard]] Result<VkBuffer> buffer(uint64_t size_bytes);
    // Records the layout transitions of all dummy images. The caller must submit them before the first frame,
    // because this class submits nothing itself.
    void record_layouts(VkCommandBuffer commands) const;

 private:
    Device* device_;
    std::deque<Image> images_;
    // The layout transition of each dummy image.
    std::vector<VkImageMemoryBarrier2> first_layouts_;
    std::deque<Buffer> buffers_;
};

}  // namespace weft::vk
