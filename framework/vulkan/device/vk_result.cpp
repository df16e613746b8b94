#include "vulkan/device/vk_result.h"

#include <array>
#include <utility>

namespace weft::vk {
namespace {

constexpr std::array<std::pair<VkResult, const char*>, 15> kNames{{
    {VK_SUCCESS, "VK_SUCCESS"},
    {VK_NOT_READY, "VK_NOT_READY"},
    {VK_TIMEOUT, "VK_TIMEOUT"},
    {VK_INCOMPLETE, "VK_INCOMPLETE"},
    {VK_ERROR_OUT_OF_HOST_MEMORY, "VK_ERROR_OUT_OF_HOST_MEMORY"},
    {VK_ERROR_OUT_OF_DEVICE_MEMORY, "VK_ERROR_OUT_OF_DEVICE_MEMORY"},
    {VK_ERROR_INITIALIZATION_FAILED, "VK_ERROR_INITIALIZATION_FAILED"},
    {VK_ERROR_DEVICE_LOST, "VK_ERROR_DEVICE_LOST"},
    {VK_ERROR_MEMORY_MAP_FAILED, "VK_ERROR_MEMORY_MAP_FAILED"},
    {VK_ERROR_LAYER_NOT_PRESENT, "VK_ERROR_LAYER_NOT_PRESENT"},
    {VK_ERROR_EXTENSION_NOT_PRESENT, "VK_ERROR_EXTENSION_NOT_PRESENT"},
    {VK_ERROR_FEATURE_NOT_PRESENT, "VK_ERROR_FEATURE_NOT_PRESENT"},
    {VK_ERROR_INCOMPATIBLE_DRIVER, "VK_ERROR_INCOMPATIBLE_DRIVER"},
    {VK_ERROR_FORMAT_NOT_SUPPORTED, "VK_ERROR_FORMAT_NOT_SUPPORTED"},
    {VK_ERROR_OUT_OF_POOL_MEMORY, "VK_ERROR_OUT_OF_POOL_MEMORY"},
}};

}  // namespace

std::string result_name(VkResult result) {
    for (const auto& [value, name] : kNames) {
        if (value == result) return name;
    }
    return "VkResult " + std::to_string(static_cast<int>(result));
}

Diagnostic vk_error(VkResult result, std::string_view what) {
    Diagnostic error;
    error.message = std::string(what) + " failed: " + result_name(result);
    switch (result) {
        case VK_TIMEOUT:
            error.code = "V407";
            error.help = {"look for an endless loop in a shader, or allow more time with --timeout SECONDS"};
            break;
        case VK_ERROR_DEVICE_LOST:
            error.code = "V408";
            error.help = {
                "the driver has lost the device; look for the cause with --validate",
                "a program that embeds Weft must destroy the session, Weft's device and the VkDevice, "
                "and create them again"};
            break;
        case VK_ERROR_OUT_OF_HOST_MEMORY:
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        case VK_ERROR_OUT_OF_POOL_MEMORY:
            error.code = "V410";
            error.help = {"use a smaller --size, or a scene with fewer or smaller textures"};
            break;
        default:
            error.code = "V409";
            error.help = {"look at the drivers and devices of this machine with `weft doctor`"};
            break;
    }
    return error;
}

}  // namespace weft::vk
