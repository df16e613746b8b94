#include "vulkan/device/functions.h"

#include <dlfcn.h>

namespace weft::vk {
namespace {

template <class Function>
void load(PFN_vkGetInstanceProcAddr get, VkInstance instance, const char* name, Function& function) {
    function = reinterpret_cast<Function>(get(instance, name));
}

}  // namespace

std::optional<LoaderFunctions> load_loader(const char* library) {
    void* handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) return std::nullopt;
    LoaderFunctions f;
    const auto get = reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(handle, "vkGetInstanceProcAddr"));
    if (get == nullptr) return std::nullopt;
    f.vkGetInstanceProcAddr = get;
    load(get, VK_NULL_HANDLE, "vkCreateInstance", f.vkCreateInstance);
    load(get, VK_NULL_HANDLE, "vkEnumerateInstanceVersion", f.vkEnumerateInstanceVersion);
    load(get, VK_NULL_HANDLE, "vkEnumerateInstanceLayerProperties", f.vkEnumerateInstanceLayerProperties);
    load(get, VK_NULL_HANDLE, "vkEnumerateInstanceExtensionProperties",
         f.vkEnumerateInstanceExtensionProperties);
    if (f.vkCreateInstance == nullptr || f.vkEnumerateInstanceVersion == nullptr) return std::nullopt;
    return f;
}

InstanceFunctions load_instance_functions(const LoaderFunctions& loader, VkInstance instance) {
    const PFN_vkGetInstanceProcAddr get = loader.vkGetInstanceProcAddr;
    InstanceFunctions f;
    load(get, instance, "vkDestroyInstance", f.vkDestroyInstance);
    load(get, instance, "vkEnumeratePhysicalDevices", f.vkEnumeratePhysicalDevices);
    load(get, instance, "vkGetPhysicalDeviceProperties2", f.vkGetPhysicalDeviceProperties2);
    load(get, instance, "vkGetPhysicalDeviceFeatures2", f.vkGetPhysicalDeviceFeatures2);
    load(get, instance, "vkGetPhysicalDeviceMemoryProperties", f.vkGetPhysicalDeviceMemoryProperties);
    load(get, instance, "vkGetPhysicalDeviceQueueFamilyProperties",
         f.vkGetPhysicalDeviceQueueFamilyProperties);
    load(get, instance, "vkGetPhysicalDeviceFormatProperties", f.vkGetPhysicalDeviceFormatProperties);
    load(get, instance, "vkGetPhysicalDeviceImageFormatProperties",
         f.vkGetPhysicalDeviceImageFormatProperties);
    load(get, instance, "vkEnumerateDeviceExtensionProperties", f.vkEnumerateDeviceExtensionProperties);
    load(get, instance, "vkCreateDevice", f.vkCreateDevice);
    load(get, instance, "vkGetDeviceProcAddr", f.vkGetDeviceProcAddr);
    load(get, instance, "vkCreateDebugUtilsMessengerEXT", f.vkCreateDebugUtilsMessengerEXT);
    load(get, instance, "vkDestroyDebugUtilsMessengerEXT", f.vkDestroyDebugUtilsMessengerEXT);
    load(get, instance, "vkSetDebugUtilsObjectNameEXT", f.vkSetDebugUtilsObjectNameEXT);
    load(get, instance, "vkCmdBeginDebugUtilsLabelEXT", f.vkCmdBeginDebugUtilsLabelEXT);
    load(get, instance, "vkCmdEndDebugUtilsLabelEXT", f.vkCmdEndDebugUtilsLabelEXT);
    return f;
}

DeviceFunctions load_device_functions(const InstanceFunctions& functions, VkDevice device) {
    DeviceFunctions table;
#define WEFT_LOAD(name) \
    table.name = reinterpret_cast<PFN_##name>(functions.vkGetDeviceProcAddr(device, #name));
    WEFT_DEVICE_FUNCTIONS(WEFT_LOAD)
#undef WEFT_LOAD
    return table;
}

std::string version_text(uint32_t version) {
    return std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
           std::to_string(VK_API_VERSION_MINOR(version)) + "." +
           std::to_string(VK_API_VERSION_PATCH(version));
}

}  // namespace weft::vk
