// Purpose: creates the Vulkan objects that an engine already has before it embeds Weft. Weft only chooses the
// features with which the device is created. If a Vulkan function fails, std::runtime_error is thrown.
#pragma once

#include <vulkan/vulkan.h>
#include <weft/vulkan/device_features.h>

#include <cstdint>
#include <string>
#include <vector>

struct OwnDevice {
    VkInstance instance = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
    uint32_t messages = 0;  // Number of messages that the validation layer has reported.
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    uint32_t family = 0;
    VkQueue queue = VK_NULL_HANDLE;
    weft::vk::FeatureChain enabled;  // The features with which `device` was created.

    explicit OwnDevice(bool validate);
    ~OwnDevice() { destroy(); }
    OwnDevice(const OwnDevice&) = delete;
    void destroy();
};

struct OwnImage {
    VkImage image = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
};
OwnImage make_image(const OwnDevice& own, const VkImageCreateInfo& info);
void destroy_image(const OwnDevice& own, const OwnImage& image);

// Copies an image of 4 bytes per texel to the CPU and returns its bytes. The image must have the layout
// TRANSFER_SRC_OPTIMAL. Waits until `own.queue` has finished the copy.
std::vector<uint8_t> read_image(const OwnDevice& own, VkImage image, uint32_t width, uint32_t height);

// A buffer in memory that the CPU writes.
struct OwnBuffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    void* mapped = nullptr;
};
OwnBuffer make_buffer(const OwnDevice& own, VkDeviceSize bytes, VkBufferUsageFlags usage);
void destroy_buffer(const OwnDevice& own, const OwnBuffer& buffer);
