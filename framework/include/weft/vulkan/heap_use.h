// Purpose: computes the device memory that an executor will allocate for a plan, before the executor exists.
// Units: bytes.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"
#include "weft/result.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

struct HeapUse {
    uint32_t heap = 0;  // Index of the memory heap (VkPhysicalDeviceMemoryProperties::memoryHeaps).
    uint64_t size_bytes = 0;
    uint32_t allocations = 0;  // Number of blocks; each has its own vkAllocateMemory() or allocate() call.
};

// Returns, for each memory heap of the device, the memory for the heaps of the plan and for the buffers of
// parameters, uploads and readbacks. Heaps of the device that the plan does not use are left out. The imports
// are not included, because they exist already. The small dummy resources for descriptors without a port are
// not included either. Creates no object. Errors: V411 the device has no memory type for a heap of the plan;
// V417 the executor cannot run the plan.
[[nodiscard]] Result<std::vector<HeapUse>> heap_use(Device& device, const FramePlan& plan);

}  // namespace weft::vk
