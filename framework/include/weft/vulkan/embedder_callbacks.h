// Purpose: functions of an embedding program that Weft calls: for device memory, around the use of queues,
// and for log messages. Units: bytes.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

#include "weft/vulkan/messages.h"

namespace weft::vk {

// The objects that a block of memory contains. A block with both needs the distance
// VkPhysicalDeviceLimits::bufferImageGranularity to its neighbours, like a block with images.
enum class MemoryContent : uint8_t { buffers, images, both };

struct MemoryRequest {
    uint64_t size_bytes = 0;
    uint64_t alignment_bytes = 1;  // The offset of the block must be a multiple of this number.
    uint32_t type = 0;             // Index of the memory type.
    bool mapped = false;           // True: the block must be mapped, and its memory is host-coherent.
    std::string_view name;         // For messages, such as "lights".
    MemoryContent content = MemoryContent::both;
};

struct MemoryBlock {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    uint64_t offset_bytes = 0;
    // Address of the first byte of the block, if MemoryRequest::mapped is true. It must stay valid until
    // free() is called.
    std::byte* mapped = nullptr;
    void* own = nullptr;  // A value of the allocator, which Weft only passes on to free().
};

// Allocates the device memory for everything that Weft creates: the heaps of plans, images and buffers. A
// heap contains images and buffers at offsets of the plan. Threads: Session::prepare() allocates on the
// thread that calls it. If this is not the thread that renders, both functions must be thread-safe.
class MemoryAllocator {
 public:
    virtual ~MemoryAllocator() = default;
    // Fills `block`, or returns an error such as VK_ERROR_OUT_OF_DEVICE_MEMORY (V410).
    [[nodiscard]] virtual VkResult allocate(const MemoryRequest& request, MemoryBlock& block) = 0;
    virtual void free(const MemoryBlock& block) = 0;
};

struct EmbedderCallbacks {
    // Must outlive the Device. Null: Weft calls vkAllocateMemory() for each heap, image and buffer.
    MemoryAllocator* memory = nullptr;
    // Called before and after each vkQueueSubmit() and vkQueueWaitIdle() with the queue. Between the two
    // calls no other thread may use the queue. Set both functions or none.
    std::function<void(VkQueue)> lock_queue;
    std::function<void(VkQueue)> unlock_queue;
    // Receives the warnings of sessions, the errors V407 and V408, and, if VK_EXT_debug_utils is enabled in
    // the instance, the messages of the validation layer with the name of the pass. These messages are about
    // all Vulkan calls with the instance, also the calls of the program; for those, Message::pass is empty.
    // The function may be called on any thread.
    std::function<void(const Message&)> log;
};

}  // namespace weft::vk
