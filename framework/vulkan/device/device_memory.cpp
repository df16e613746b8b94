#include "vulkan/device/device_memory.h"

#include "vulkan/device/functions.h"
#include "weft/vulkan/native.h"

namespace weft::vk {

VkResult allocate_memory(const Device& device, const MemoryRequest& request, MemoryBlock& block) {
    if (MemoryAllocator* own = device.callbacks().memory) return own->allocate(request, block);
    const DeviceFunctions& fn = device.fn();
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = request.size_bytes;
    info.memoryTypeIndex = request.type;
    MemoryBlock made;
    VkResult result = fn.vkAllocateMemory(device.handle(), &info, nullptr, &made.memory);
    if (result != VK_SUCCESS) return result;
    device.name(VK_OBJECT_TYPE_DEVICE_MEMORY, object_id(made.memory), std::string(request.name));
    if (request.mapped) {
        void* mapped = nullptr;
        result = fn.vkMapMemory(device.handle(), made.memory, 0, VK_WHOLE_SIZE, 0, &mapped);
        made.mapped = static_cast<std::byte*>(mapped);
    }
    if (result == VK_SUCCESS)
        block = made;
    else
        free_memory(device, made);
    return result;
}

void free_memory(const Device& device, const MemoryBlock& block) {
    if (block.memory == VK_NULL_HANDLE || device.abandoned()) return;
    if (MemoryAllocator* own = device.callbacks().memory) return own->free(block);
    // vkFreeMemory also unmaps the memory.
    device.fn().vkFreeMemory(device.handle(), block.memory, nullptr);
}

}  // namespace weft::vk
