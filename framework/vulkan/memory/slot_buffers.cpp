#include "vulkan/memory/slot_buffers.h"

#include <utility>

namespace weft::vk {

Status create_slot_buffers(SlotBuffers& buffers, Device& device, uint64_t size_bytes,
                           VkBufferUsageFlags usage, Buffer::Memory memory, const std::string& name) {
    if (size_bytes == 0) return Unit{};
    for (Buffer& buffer : buffers) {
        Result<Buffer> made = Buffer::create(device, size_bytes, usage, memory, name);
        if (!made) return made.take_errors();
        buffer = std::move(*made);
    }
    return Unit{};
}

}  // namespace weft::vk
