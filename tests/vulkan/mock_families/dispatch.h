// Purpose: what the layer keeps: the next layer's functions by instance and device, and the queues that it
// invents. Handles of one instance or device begin with the same pointer, the loader's, which is the key.
#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <vector>

namespace weft::mock_families {

inline constexpr uint32_t kFamilyCount = 3;

// The next layer's functions behind those that the layer replaces.
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

// Asked for while the instance was made: later on, the loader answers with the top of the chain, not the
// rest.
struct InstanceFunctions {
    PFN_vkGetInstanceProcAddr next = nullptr;
    PFN_vkDestroyInstance vkDestroyInstance = nullptr;
};
[[nodiscard]] InstanceFunctions functions_of(VkInstance instance);
[[nodiscard]] PFN_vkGetDeviceProcAddr next_of(VkDevice device);

[[nodiscard]] const DeviceFunctions& functions_of(const void* dispatchable);

// The queue that stands for the driver's `real` one in this family.
[[nodiscard]] VkQueue mock_queue(VkDevice device, uint32_t family, VkQueue real);
[[nodiscard]] VkQueue real_queue(VkQueue mock);

}  // namespace weft::mock_families
