// Purpose: dummy descriptors for bindings that a graph leaves unconnected. The shader's constant HAS_x is
// false then, so its code does not access them, but a descriptor that a shader uses statically must still be
// valid. Errors: V411, V413.
#pragma once

#include <deque>
#include <vector>

#include "weft/shader_interface.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {

class DummyDescriptors {
 public:
    explicit DummyDescriptors(Device& device) : device_(&device) {}

    // A view of one texel (six for cubes), and its layout after record_layouts() has run; the caller adds the
    // sampler.
    [[nodiscard]] Result<VkDescriptorImageInfo> image(const ShaderBinding& binding);
    // A buffer of at least `size_bytes`, with undefined content.
    [[nodiscard]] Result<VkBuffer> buffer(uint64_t size_bytes);
    // Records the layout transitions, for submission before the first frame. This class submits nothing
    // itself.
    void record_layouts(VkCommandBuffer commands) const;

 private:
    Device* device_;
    std::deque<Image> images_;
    std::vector<VkImageMemoryBarrier2> first_layouts_;  // one transition per image
    std::deque<Buffer> buffers_;
};

}  // namespace weft::vk
