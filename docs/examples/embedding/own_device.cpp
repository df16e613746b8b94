#include "own_device.h"

#include <cstdio>
#include <stdexcept>

namespace {

void require(VkResult result, const char* what) {
    if (result != VK_SUCCESS)
        throw std::runtime_error(std::string(what) + " failed: " + std::to_string(result));
}

VkBool32 VKAPI_PTR count_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                 const VkDebugUtilsMessengerCallbackDataEXT* data, void* count) {
    std::fprintf(stderr, "validation: %s\n", data->pMessage);
    ++*static_cast<uint32_t*>(count);
    return VK_FALSE;
}

VkInstance make_instance(bool validate) {
    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.pApplicationName = "embedding";
    application.apiVersion = VK_API_VERSION_1_3;  // Weft needs Vulkan 1.3 or newer.
    const char* layer = "VK_LAYER_KHRONOS_validation";
    const char* extensions[] = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
    const VkValidationFeatureEnableEXT enable = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = &enable;
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    if (validate) {
        info.pNext = &features;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &layer;
        info.enabledExtensionCount = 2;
        info.ppEnabledExtensionNames = extensions;
    }
    VkInstance instance = VK_NULL_HANDLE;
    require(vkCreateInstance(&info, nullptr, &instance), "vkCreateInstance");
    return instance;
}

VkDebugUtilsMessengerEXT make_messenger(VkInstance instance, uint32_t* count) {
    VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = count_message;
    info.pUserData = count;
    const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance, "vkCreateDebugUtilsMessengerEXT"));
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
    require(create(instance, &info, nullptr, &messenger), "vkCreateDebugUtilsMessengerEXT");
    return messenger;
}

uint32_t find_family(VkPhysicalDevice physical) {
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    constexpr VkQueueFlags wanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (uint32_t i = 0; i < count; ++i)
        if ((families[i].queueFlags & wanted) == wanted) return i;
    throw std::runtime_error("no queue family draws and computes");
}

uint32_t memory_type(VkPhysicalDevice physical, uint32_t fitting, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(physical, &memory);
    for (uint32_t i = 0; i < memory.memoryTypeCount; ++i)
        if ((fitting >> i & 1u) != 0 && (memory.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    throw std::runtime_error("no memory of that type");
}

VkDeviceMemory allocate(const OwnDevice& own, const VkMemoryRequirements& needs,
                        VkMemoryPropertyFlags wanted) {
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = needs.size;
    info.memoryTypeIndex = memory_type(own.physical, needs.memoryTypeBits, wanted);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    require(vkAllocateMemory(own.device, &info, nullptr, &memory), "vkAllocateMemory");
    return memory;
}

// Records a copy of the image to the buffer, and a barrier that makes the copied texels visible to the CPU.
void record_copy(VkCommandBuffer commands, VkImage image, VkBuffer buffer, uint32_t width, uint32_t height) {
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    require(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {width, height, 1};
    vkCmdCopyImageToBuffer(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer, 1, &region);
    VkMemoryBarrier to_host{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
    to_host.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    to_host.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &to_host,
                         0, nullptr, 0, nullptr);
    require(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
}

void submit_copy(const OwnDevice& own, VkImage image, VkBuffer buffer, uint32_t width, uint32_t height) {
    VkCommandPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool_info.queueFamilyIndex = own.family;
    VkCommandPool pool = VK_NULL_HANDLE;
    require(vkCreateCommandPool(own.device, &pool_info, nullptr, &pool), "vkCreateCommandPool");
    VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    info.commandPool = pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    require(vkAllocateCommandBuffers(own.device, &info, &commands), "vkAllocateCommandBuffers");
    record_copy(commands, image, buffer, width, height);
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    require(vkQueueSubmit(own.queue, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    require(vkQueueWaitIdle(own.queue), "vkQueueWaitIdle");
    vkDestroyCommandPool(own.device, pool, nullptr);
}

}  // namespace

OwnDevice::OwnDevice(bool validate) : instance(make_instance(validate)) {
    if (validate) messenger = make_messenger(instance, &messages);
    uint32_t count = 1;
    if (vkEnumeratePhysicalDevices(instance, &count, &physical) < VK_SUCCESS || count == 0)
        throw std::runtime_error("no Vulkan device");
    family = find_family(physical);
    const float priority = 1;
    VkDeviceQueueCreateInfo queue_info{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue_info.queueFamilyIndex = family;
    queue_info.queueCount = 1;
    queue_info.pQueuePriorities = &priority;
    weft::vk::FeatureChain supported;
    vkGetPhysicalDeviceFeatures2(physical, &supported.head());
    weft::vk::enable_features(supported, enabled);  // An engine would also enable its own features here.
    VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    info.pNext = &enabled.head();
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue_info;
    require(vkCreateDevice(physical, &info, nullptr, &device), "vkCreateDevice");
    vkGetDeviceQueue(device, family, 0, &queue);
}

void OwnDevice::destroy() {
    if (instance == VK_NULL_HANDLE) return;
    vkDestroyDevice(device, nullptr);  // The validation layer reports objects that have not been destroyed.
    const auto destroy_messenger = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance, "vkDestroyDebugUtilsMessengerEXT"));
    if (messenger != VK_NULL_HANDLE) destroy_messenger(instance, messenger, nullptr);
    vkDestroyInstance(instance, nullptr);
    instance = VK_NULL_HANDLE;
}

OwnImage make_image(const OwnDevice& own, const VkImageCreateInfo& info) {
    OwnImage made;
    require(vkCreateImage(own.device, &info, nullptr, &made.image), "vkCreateImage");
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(own.device, made.image, &needs);
    made.memory = allocate(own, needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    require(vkBindImageMemory(own.device, made.image, made.memory, 0), "vkBindImageMemory");
    return made;
}

void destroy_image(const OwnDevice& own, const OwnImage& image) {
    vkDestroyImage(own.device, image.image, nullptr);
    vkFreeMemory(own.device, image.memory, nullptr);
}

std::vector<uint8_t> read_image(const OwnDevice& own, VkImage image, uint32_t width, uint32_t height) {
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = VkDeviceSize{width} * height * 4;
    info.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    VkBuffer buffer = VK_NULL_HANDLE;
    require(vkCreateBuffer(own.device, &info, nullptr, &buffer), "vkCreateBuffer");
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(own.device, buffer, &needs);
    const VkDeviceMemory memory =
        allocate(own, needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    require(vkBindBufferMemory(own.device, buffer, memory, 0), "vkBindBufferMemory");
    submit_copy(own, image, buffer, width, height);
    void* mapped = nullptr;
    require(vkMapMemory(own.device, memory, 0, VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory");
    const auto* bytes = static_cast<const uint8_t*>(mapped);
    std::vector<uint8_t> texels(bytes, bytes + info.size);
    vkDestroyBuffer(own.device, buffer, nullptr);
    vkFreeMemory(own.device, memory, nullptr);
    return texels;
}

OwnBuffer make_buffer(const OwnDevice& own, VkDeviceSize bytes, VkBufferUsageFlags usage) {
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = bytes;
    info.usage = usage;
    OwnBuffer made;
    require(vkCreateBuffer(own.device, &info, nullptr, &made.buffer), "vkCreateBuffer");
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(own.device, made.buffer, &needs);
    made.memory =
        allocate(own, needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    require(vkBindBufferMemory(own.device, made.buffer, made.memory, 0), "vkBindBufferMemory");
    require(vkMapMemory(own.device, made.memory, 0, VK_WHOLE_SIZE, 0, &made.mapped), "vkMapMemory");
    return made;
}

void destroy_buffer(const OwnDevice& own, const OwnBuffer& buffer) {
    vkDestroyBuffer(own.device, buffer.buffer, nullptr);
    vkFreeMemory(own.device, buffer.memory, nullptr);
}
