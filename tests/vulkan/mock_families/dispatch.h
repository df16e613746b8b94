// Purpose: state of the Vulkan layer in layer.cpp: the functions of the next layer for each instance and
// device, and the simulated queues. The objects behind all handles of one instance or device begin with the
// same pointer (the loader's dispatch table). This pointer is the key of the state.
#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <vector>

namespace weft::mock_families {

inline constexpr uint32_t kFamilyCount = 3;

// The functions of the next layer that correspond to the functions that this layer replaces.
struct DeviceFunctions {
    PFN_vkDestroyDevice vkDestroyDevice = nullptr;
    PFN_vkGetDeviceQueue vkGetDeviceQueue = nullptr;
    PFN_vkQueueSubmit vkQueueSubmit = nullptr;
    PFN_vkQueueSubmit2 vkQueueSubmit2 = nullptr;
    PFN_vkQueueWaitIdle vkQueueWaitIdle = nullptr;
    PFN_vkCreateCommandPool vkCreateCommandPool = nullptr;
    PFN_vkCreateBuffer vkCreateBuffer = nullptr;
    PFN_vkCreateImage vkCreateImage = nullptr;
    PFN_vkGetDeviceBufferMemoryRequirements vkGetDeviceBufferMemoryRequirements = nullptr;
    PFN_vkGetDeviceImageMemoryRequirements vkGetDeviceImageMemoryRequirements = nullptr;
    PFN_vkCmdPipelineBarrier2 vkCmdPipelineBarrier2 = nullptr;
};

void add_instance(VkInstance instance, PFN_vkGetInstanceProcAddr next);
void add_device(VkDevice device, PFN_vkGetDeviceProcAddr next);
void forget(VkInstance instance);
void forget(VkDevice device);

// The functions of the next layer for one instance. They are queried while the instance is created. A later
// query to the loader would return the functions of the top layer instead.
struct InstanceFunctions {
    PFN_vkGetInstanceProcAddr next = nullptr;
    PFN_vkDestroyInstance vkDestroyInstance = nullptr;
};
[[nodiscard]] InstanceFunctions functions_of(VkInstance instance);
[[nodiscard]] PFN_vkGetDeviceProcAddr next_of(VkDevice device);

[[nodiscard]] const DeviceFunctions& functions_of(const void* dispatchable);

// Returns the simulated queue of this family; `real` is the driver's queue to which the simulated queue
// submits.
[[nodiscard]] VkQueue mock_queue(VkDevice device, uint32_t family, VkQueue real);
[[nodiscard]] VkQueue real_queue(VkQueue mock);

}  // namespace weft::mock_families
