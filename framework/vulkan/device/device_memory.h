// Purpose: blocks of device memory, from the allocator of the program or, without one, from
// vkAllocateMemory(). Units: bytes.
#pragma once

#include <utility>

#include "weft/vulkan/device.h"

namespace weft::vk {

// Allocates a block, and maps it if `request.mapped` is true.
[[nodiscard]] VkResult allocate_memory(const Device& device, const MemoryRequest& request,
                                       MemoryBlock& block);
// Frees a block; does nothing for an empty block and after Device::abandon().
void free_memory(const Device& device, const MemoryBlock& block);

// Owns a block of memory. It can be moved but not copied. The Device must outlive it.
class DeviceMemory {
 public:
    DeviceMemory() = default;
    DeviceMemory(const Device& device, const MemoryBlock& block) : device_(&device), block_(block) {}
    ~DeviceMemory() { reset(); }
    DeviceMemory(DeviceMemory&& other) noexcept
        : device_(other.device_), block_(std::exchange(other.block_, {})) {}
    DeviceMemory& operator=(DeviceMemory&& other) noexcept {
        if (this == &other) return *this;
        reset();
        device_ = other.device_;
        block_ = std::exchange(other.block_, {});
        return *this;
    }

    [[nodiscard]] const MemoryBlock& block() const { return block_; }
    void reset() {
        if (device_ != nullptr) free_memory(*device_, block_);
        block_ = {};
    }

 private:
    const Device* device_ = nullptr;
    MemoryBlock block_;
};

}  // namespace weft::vk
