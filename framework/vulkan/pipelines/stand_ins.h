// Purpose: something valid behind a binding that the graph leaves out. The shader's HAS_x constant is false
// then and its code never looks, but a descriptor that a shader names statically must still be valid. Errors:
// V411, V413.
#pragma once

#include <deque>
#include <vector>

#include "weft/shader_interface.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {

class StandIns {
 public:
    explicit StandIns(Device& device) : device_(&device) {}

    // A view of one texel (six for cubes) and the layout that it has once record_layouts() has run; the
    // sampler is the caller's.
    [[nodiscard]] Result<VkDescriptorImageInfo> image(const ShaderBinding& binding);
    // At least `size_bytes` of anything.
    [[nodiscard]] Result<VkBuffer> buffer(uint64_t size_bytes);
    // Before the first frame, in commands of its own thread: what makes stand-ins submits nothing.
    void record_layouts(VkCommandBuffer commands) const;

 private:
    Device* device_;
    std::deque<Image> images_;
    std::vector<VkImageMemoryBarrier2> first_layouts_;  // of each image
    std::deque<Buffer> buffers_;
};

}  // namespace weft::vk
