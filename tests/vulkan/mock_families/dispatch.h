// Purpose: the layer's state: the next layer's functions by instance and device, and the queues that it
// simulates. Handles of one instance or device begin with the same pointer, the loader's dispatch table,
// which is used as the key.
#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <vector>

namespace weft::mock_families {

inline constexpr uint32_t kFamilyCount = 3;

// The next layer's versions of the functions that this layer replaces.
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

// Queried during instance creation: later the loader returns functions of the top layer, not of the next one.
struct InstanceFunctions {
    PFN_vkGetInstanceProcAddr next = nullptr;
    PFN_vkDestroyInstance vkDestroyInstance = nullptr;
};
[[nodiscard]] InstanceFunctions functions_of(VkInstance instance);
[[nodiscard]] PFN_vkGetDeviceProcAddr next_of(VkDevice device);

[[nodiscard]] const DeviceFunctions& functions_of(const void* dispatchable);

// The simulated queue in this family for the driver's queue `real`.
[[nodiscard]] VkQueue mock_queue(VkDevice device, uint32_t family, VkQueue real);
[[nodiscard]] VkQueue real_queue(VkQueue mock);

}  // namespace weft::mock_families
