// Purpose: host-visible buffers. Each frame slot has its own buffer, so that the host can use one buffer
// while the device uses another. Errors: those of Buffer::create().
#pragma once

#include <array>
#include <string>

#include "weft/result.h"
#include "weft/vulkan/executor.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {

using SlotBuffers = std::array<Buffer, kFramesInFlight>;

// Creates one buffer of `size_bytes` for each frame slot, and none if the size is 0. `name` is used in
// messages.
[[nodiscard]] Status create_slot_buffers(SlotBuffers& buffers, Device& device, uint64_t size_bytes,
                                         VkBufferUsageFlags usage, Buffer::Memory memory,
                                         const std::string& name);

}  // namespace weft::vk
