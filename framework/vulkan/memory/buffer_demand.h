// Purpose: the memory that a buffer will need, without creating it.
#pragma once

#include "weft/vulkan/memory.h"

namespace weft::vk {

struct BufferDemand {
    uint64_t size_bytes = 0;
    uint32_t type = 0;  // Index of the memory type; UINT32_MAX if the device has no fitting type.
};

// Returns the memory that Buffer::create() allocates for a buffer with these arguments.
[[nodiscard]] BufferDemand buffer_demand(Device& device, uint64_t size_bytes, VkBufferUsageFlags usage,
                                         Buffer::Memory memory);

}  // namespace weft::vk
