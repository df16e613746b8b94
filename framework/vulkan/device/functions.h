// Purpose: Vulkan's functions as plain tables: one for the loader, one per instance and one per device. Weft
// does not link to libvulkan, defines no symbols with the names of Vulkan functions, and has no global table.
// So a program that uses Weft can itself link to libvulkan, and a test can replace functions in the table of
// one device. Errors: load_loader() returns nullopt if no usable loader library is found; functions that do
// not exist are null in the tables.
#pragma once

#include <vulkan/vulkan_core.h>

#include <optional>
#include <string>

namespace weft::vk {

inline constexpr const char* kLoaderLibrary = "libvulkan.so.1";

// The functions that can be called without a VkInstance.
struct LoaderFunctions {
    PFN_vkGetInstanceProcAddr vkGetInstanceProcAddr = nullptr;
    PFN_vkCreateInstance vkCreateInstance = nullptr;
    PFN_vkEnumerateInstanceVersion vkEnumerateInstanceVersion = nullptr;
    PFN_vkEnumerateInstanceLayerProperties vkEnumerateInstanceLayerProperties = nullptr;
    PFN_vkEnumerateInstanceExtensionProperties vkEnumerateInstanceExtensionProperties = nullptr;
};

struct InstanceFunctions {
    PFN_vkDestroyInstance vkDestroyInstance = nullptr;
    PFN_vkEnumeratePhysicalDevices vkEnumeratePhysicalDevices = nullptr;
    PFN_vkGetPhysicalDeviceProperties2 vkGetPhysicalDeviceProperties2 = nullptr;
    PFN_vkGetPhysicalDeviceFeatures2 vkGetPhysicalDeviceFeatures2 = nullptr;
    PFN_vkGetPhysicalDeviceMemoryProperties vkGetPhysicalDeviceMemoryProperties = nullptr;
    PFN_vkGetPhysicalDeviceQueueFamilyProperties vkGetPhysicalDeviceQueueFamilyProperties = nullptr;
    PFN_vkGetPhysicalDeviceFormatProperties vkGetPhysicalDeviceFormatProperties = nullptr;
    PFN_vkGetPhysicalDeviceImageFormatProperties vkGetPhysicalDeviceImageFormatProperties = nullptr;
    PFN_vkEnumerateDeviceExtensionProperties vkEnumerateDeviceExtensionProperties = nullptr;
    PFN_vkCreateDevice vkCreateDevice = nullptr;
    PFN_vkGetDeviceProcAddr vkGetDeviceProcAddr = nullptr;
    // The functions from here to the end of the struct are null if VK_EXT_debug_utils is not enabled.
    PFN_vkCreateDebugUtilsMessengerEXT vkCreateDebugUtilsMessengerEXT = nullptr;
    PFN_vkDestroyDebugUtilsMessengerEXT vkDestroyDebugUtilsMessengerEXT = nullptr;
    PFN_vkSetDebugUtilsObjectNameEXT vkSetDebugUtilsObjectNameEXT = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT vkCmdBeginDebugUtilsLabelEXT = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT vkCmdEndDebugUtilsLabelEXT = nullptr;
};

// All device functions that Weft calls.
// clang-format off
#define WEFT_DEVICE_FUNCTIONS(X)           \
    X(vkAllocateCommandBuffers)            \
    X(vkAllocateDescriptorSets)            \
    X(vkAllocateMemory)                    \
    X(vkBeginCommandBuffer)                \
    X(vkBindBufferMemory)                  \
    X(vkBindImageMemory)                   \
    X(vkCmdBeginRendering)                 \
    X(vkCmdBindDescriptorSets)             \
    X(vkCmdBindIndexBuffer)                \
    X(vkCmdBindPipeline)                   \
    X(vkCmdBindVertexBuffers)              \
    X(vkCmdBlitImage)                      \
    X(vkCmdClearColorImage)                \
    X(vkCmdClearDepthStencilImage)         \
    X(vkCmdCopyBuffer)                     \
    X(vkCmdCopyBufferToImage)              \
    X(vkCmdCopyImage)                      \
    X(vkCmdCopyImageToBuffer)              \
    X(vkCmdDispatch)                       \
    X(vkCmdDispatchIndirect)               \
    X(vkCmdDraw)                           \
    X(vkCmdDrawIndexed)                    \
    X(vkCmdDrawIndexedIndirect)            \
    X(vkCmdDrawIndexedIndirectCount)       \
    X(vkCmdDrawIndirect)                   \
    X(vkCmdDrawIndirectCount)              \
    X(vkCmdEndRendering)                   \
    X(vkCmdFillBuffer)                     \
    X(vkCmdPipelineBarrier2)               \
    X(vkCmdPushConstants)                  \
    X(vkCmdSetCullMode)                    \
    X(vkCmdSetFrontFace)                   \
    X(vkCmdSetScissor)                     \
    X(vkCmdSetViewport)                    \
    X(vkCmdWriteTimestamp2)                \
    X(vkCreateBuffer)                      \
    X(vkCreateCommandPool)                 \
    X(vkCreateComputePipelines)            \
    X(vkCreateDescriptorPool)              \
    X(vkCreateDescriptorSetLayout)         \
    X(vkCreateFence)                       \
    X(vkCreateGraphicsPipelines)           \
    X(vkCreateImage)                       \
    X(vkCreateImageView)                   \
    X(vkCreatePipelineCache)               \
    X(vkCreatePipelineLayout)              \
    X(vkCreateQueryPool)                   \
    X(vkCreateSampler)                     \
    X(vkCreateSemaphore)                   \
    X(vkCreateShaderModule)                \
    X(vkDestroyBuffer)                     \
    X(vkDestroyCommandPool)                \
    X(vkDestroyDescriptorPool)             \
    X(vkDestroyDescriptorSetLayout)        \
    X(vkDestroyDevice)                     \
    X(vkDestroyFence)                      \
    X(vkDestroyImage)                      \
    X(vkDestroyImageView)                  \
    X(vkDestroyPipeline)                   \
    X(vkDestroyPipelineCache)              \
    X(vkDestroyPipelineLayout)             \
    X(vkDestroyQueryPool)                  \
    X(vkDestroySampler)                    \
    X(vkDestroySemaphore)                  \
    X(vkDestroyShaderModule)               \
    X(vkDeviceWaitIdle)                    \
    X(vkEndCommandBuffer)                  \
    X(vkFreeMemory)                        \
    X(vkGetBufferMemoryRequirements)       \
    X(vkGetDeviceBufferMemoryRequirements) \
    X(vkGetDeviceImageMemoryRequirements)  \
    X(vkGetDeviceQueue)                    \
    X(vkGetFenceStatus)                    \
    X(vkGetImageMemoryRequirements)        \
    X(vkGetQueryPoolResults)               \
    X(vkGetSemaphoreCounterValue)          \
    X(vkMapMemory)                         \
    X(vkQueueSubmit)                       \
    X(vkQueueSubmit2)                      \
    X(vkQueueWaitIdle)                     \
    X(vkResetCommandPool)                  \
    X(vkResetFences)                       \
    X(vkResetQueryPool)                    \
    X(vkUpdateDescriptorSets)              \
    X(vkWaitForFences)                     \
    X(vkWaitSemaphores)
// clang-format on

struct DeviceFunctions {
#define WEFT_MEMBER(name) PFN_##name name = nullptr;
    WEFT_DEVICE_FUNCTIONS(WEFT_MEMBER)
#undef WEFT_MEMBER
};

// Loads the Vulkan loader library. The library stays loaded until the process ends, because unloading can
// crash drivers.
[[nodiscard]] std::optional<LoaderFunctions> load_loader(const char* library = kLoaderLibrary);
[[nodiscard]] InstanceFunctions load_instance_functions(const LoaderFunctions& loader, VkInstance instance);
[[nodiscard]] DeviceFunctions load_device_functions(const InstanceFunctions& functions, VkDevice device);

// Returns a Vulkan version as text, such as "1.3.239".
[[nodiscard]] std::string version_text(uint32_t version);

}  // namespace weft::vk
