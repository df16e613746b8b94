// The Vulkan objects that an engine has without Weft. Only the features with which the device is created come
// from Weft. Failures throw std::runtime_error.
#pragma once

#include <vulkan/vulkan.h>
#include <weft/vulkan/device_features.h>

#include <cstdint>
#include <string>
#include <vector>

struct OwnDevice {
    VkInstance instance = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
    uint32_t messages = 0;  // of the validation layer
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    uint32_t family = 0;
    VkQueue queue = VK_NULL_HANDLE;
    weft::vk::FeatureChain enabled;  // the features with which `device` was created

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

// Copies an RGBA8 image in TRANSFER_SRC_OPTIMAL on the device's queue and returns its texels.
std::vector<uint8_t> read_image(const OwnDevice& own, VkImage image, uint32_t width, uint32_t height);
