// Purpose: a Vulkan layer for tests on a driver with one queue family. The layer reports three families with
// one queue each: family 0 supports graphics, compute and transfer; family 1 compute and transfer; family 2
// only transfer. The layer submits all work to the only queue of the driver. The validation layer is above
// this layer and sees three families, so it checks ownership transfers, sharing and the capabilities of each
// queue. tests/vulkan/queue_families_vk_test.cpp loads the layer.
#include <vulkan/vk_layer.h>

#include <algorithm>
#include <cstring>

#include "tests/vulkan/mock_families/dispatch.h"

namespace weft::mock_families {
namespace {

constexpr std::array<VkQueueFamilyProperties, kFamilyCount> kFamilies{{
    {VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT | VK_QUEUE_TRANSFER_BIT, 1, 64, {1, 1, 1}},
    {VK_QUEUE_COMPUTE_BIT | VK_QUEUE_TRANSFER_BIT, 1, 64, {1, 1, 1}},
    {VK_QUEUE_TRANSFER_BIT, 1, 0, {1, 1, 1}},
}};

// Index of the only queue family of the driver.
constexpr uint32_t kRealFamily = 0;

VKAPI_ATTR void VKAPI_CALL get_families(VkPhysicalDevice, uint32_t* count, VkQueueFamilyProperties* out) {
    if (out == nullptr) {
        *count = kFamilyCount;
        return;
    }
    *count = std::min(*count, kFamilyCount);
    std::copy_n(kFamilies.begin(), *count, out);
}

VKAPI_ATTR void VKAPI_CALL get_families2(VkPhysicalDevice, uint32_t* count, VkQueueFamilyProperties2* out) {
    if (out == nullptr) {
        *count = kFamilyCount;
        return;
    }
    *count = std::min(*count, kFamilyCount);
    for (uint32_t i = 0; i < *count; ++i) out[i].queueFamilyProperties = kFamilies[i];
}

template <class Link, VkStructureType Type>
Link* find_link(const void* chain) {
    for (auto* at = static_cast<const VkBaseInStructure*>(chain); at != nullptr; at = at->pNext) {
        if (at->sType != Type) continue;
        // The chain is const in Vulkan's functions. But every layer must change the loader's link, so that
        // the link points to the next layer. So const_cast is necessary here.
        auto* link = const_cast<Link*>(reinterpret_cast<const Link*>(at));
        if (link->function == VK_LAYER_LINK_INFO) return link;
    }
    return nullptr;
}

VKAPI_ATTR VkResult VKAPI_CALL create_instance(const VkInstanceCreateInfo* info,
                                               const VkAllocationCallbacks* allocator, VkInstance* instance) {
    auto* link =
        find_link<VkLayerInstanceCreateInfo, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO>(info->pNext);
    const PFN_vkGetInstanceProcAddr next = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(next(VK_NULL_HANDLE, "vkCreateInstance"));
    const VkResult result = create(info, allocator, instance);
    if (result == VK_SUCCESS) add_instance(*instance, next);
    return result;
}

VKAPI_ATTR void VKAPI_CALL destroy_instance(VkInstance instance, const VkAllocationCallbacks* allocator) {
    const PFN_vkDestroyInstance destroy = functions_of(instance).vkDestroyInstance;
    forget(instance);
    destroy(instance, allocator);
}

VKAPI_ATTR VkResult VKAPI_CALL create_device(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                             const VkAllocationCallbacks* allocator, VkDevice* device) {
    auto* link = find_link<VkLayerDeviceCreateInfo, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO>(info->pNext);
    const PFN_vkGetInstanceProcAddr next = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    const PFN_vkGetDeviceProcAddr next_device = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(next(VK_NULL_HANDLE, "vkCreateDevice"));
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueFamilyIndex = kRealFamily;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo real = *info;
    real.queueCreateInfoCount = 1;
    real.pQueueCreateInfos = &queue;
    const VkResult result = create(physical, &real, allocator, device);
    if (result == VK_SUCCESS) add_device(*device, next_device);
    return result;
}

VKAPI_ATTR void VKAPI_CALL destroy_device(VkDevice device, const VkAllocationCallbacks* allocator) {
    const PFN_vkDestroyDevice destroy = functions_of(device).vkDestroyDevice;
    forget(device);
    destroy(device, allocator);
}

VKAPI_ATTR void VKAPI_CALL get_queue(VkDevice device, uint32_t family, uint32_t, VkQueue* queue) {
    VkQueue real = VK_NULL_HANDLE;
    functions_of(device).vkGetDeviceQueue(device, kRealFamily, 0, &real);
    *queue = mock_queue(device, family, real);
}

VKAPI_ATTR void VKAPI_CALL get_queue2(VkDevice device, const VkDeviceQueueInfo2* info, VkQueue* queue) {
    get_queue(device, info->queueFamilyIndex, info->queueIndex, queue);
}

VKAPI_ATTR VkResult VKAPI_CALL submit(VkQueue queue, uint32_t count, const VkSubmitInfo* infos,
                                      VkFence fence) {
    return functions_of(queue).vkQueueSubmit(real_queue(queue), count, infos, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL submit2(VkQueue queue, uint32_t count, const VkSubmitInfo2* infos,
                                       VkFence fence) {
    return functions_of(queue).vkQueueSubmit2(real_queue(queue), count, infos, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL wait_idle(VkQueue queue) {
    return functions_of(queue).vkQueueWaitIdle(real_queue(queue));
}

VKAPI_ATTR VkResult VKAPI_CALL create_pool(VkDevice device, const VkCommandPoolCreateInfo* info,
                                           const VkAllocationCallbacks* allocator, VkCommandPool* pool) {
    VkCommandPoolCreateInfo real = *info;
    real.queueFamilyIndex = kRealFamily;
    return functions_of(device).vkCreateCommandPool(device, &real, allocator, pool);
}

template <class CreateInfo>
CreateInfo unshared(const CreateInfo& info) {
    CreateInfo real = info;
    real.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    real.queueFamilyIndexCount = 0;
    real.pQueueFamilyIndices = nullptr;
    return real;
}

VKAPI_ATTR VkResult VKAPI_CALL create_buffer(VkDevice device, const VkBufferCreateInfo* info,
                                             const VkAllocationCallbacks* allocator, VkBuffer* buffer) {
    const VkBufferCreateInfo real = unshared(*info);
    return functions_of(device).vkCreateBuffer(device, &real, allocator, buffer);
}

VKAPI_ATTR VkResult VKAPI_CALL create_image(VkDevice device, const VkImageCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkImage* image) {
    const VkImageCreateInfo real = unshared(*info);
    return functions_of(device).vkCreateImage(device, &real, allocator, image);
}

VKAPI_ATTR void VKAPI_CALL buffer_needs(VkDevice device, const VkDeviceBufferMemoryRequirements* info,
                                        VkMemoryRequirements2* needs) {
    const VkBufferCreateInfo real = unshared(*info->pCreateInfo);
    VkDeviceBufferMemoryRequirements query = *info;
    query.pCreateInfo = &real;
    functions_of(device).vkGetDeviceBufferMemoryRequirements(device, &query, needs);
}

VKAPI_ATTR void VKAPI_CALL image_needs(VkDevice device, const VkDeviceImageMemoryRequirements* info,
                                       VkMemoryRequirements2* needs) {
    const VkImageCreateInfo real = unshared(*info->pCreateInfo);
    VkDeviceImageMemoryRequirements query = *info;
    query.pCreateInfo = &real;
    functions_of(device).vkGetDeviceImageMemoryRequirements(device, &query, needs);
}

template <class Barrier>
std::vector<Barrier> without_families(const Barrier* barriers, uint32_t count) {
    std::vector<Barrier> real(barriers, barriers + count);
    for (Barrier& barrier : real)
        barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    return real;
}

VKAPI_ATTR void VKAPI_CALL pipeline_barrier2(VkCommandBuffer commands, const VkDependencyInfo* info) {
    const auto images = without_families(info->pImageMemoryBarriers, info->imageMemoryBarrierCount);
    const auto buffers = without_families(info->pBufferMemoryBarriers, info->bufferMemoryBarrierCount);
    VkDependencyInfo real = *info;
    real.pImageMemoryBarriers = images.data();
    real.pBufferMemoryBarriers = buffers.data();
    functions_of(commands).vkCmdPipelineBarrier2(commands, &real);
}

struct Entry {
    const char* name;
    PFN_vkVoidFunction function;
};

template <class Function>
Entry entry(const char* name, Function function) {
    return {name, reinterpret_cast<PFN_vkVoidFunction>(function)};
}

PFN_vkVoidFunction find_entry(std::initializer_list<Entry> entries, const char* name) {
    const auto it = std::find_if(entries.begin(), entries.end(),
                                 [&](const Entry& e) { return std::strcmp(e.name, name) == 0; });
    return it == entries.end() ? nullptr : it->function;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_device_function(VkDevice device, const char* name);

PFN_vkVoidFunction find_device_function(const char* name) {
    return find_entry(
        {entry("vkGetDeviceProcAddr", get_device_function), entry("vkDestroyDevice", destroy_device),
         entry("vkGetDeviceQueue", get_queue), entry("vkGetDeviceQueue2", get_queue2),
         entry("vkQueueSubmit", submit), entry("vkQueueSubmit2", submit2),
         entry("vkQueueWaitIdle", wait_idle), entry("vkCreateCommandPool", create_pool),
         entry("vkCreateBuffer", create_buffer), entry("vkCreateImage", create_image),
         entry("vkGetDeviceBufferMemoryRequirements", buffer_needs),
         entry("vkGetDeviceImageMemoryRequirements", image_needs),
         entry("vkCmdPipelineBarrier2", pipeline_barrier2)},
        name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_device_function(VkDevice device, const char* name) {
    if (const PFN_vkVoidFunction own = find_device_function(name)) return own;
    return next_of(device)(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_instance_function(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction own = find_entry(
        {entry("vkGetInstanceProcAddr", get_instance_function), entry("vkCreateInstance", create_instance),
         entry("vkDestroyInstance", destroy_instance), entry("vkCreateDevice", create_device),
         entry("vkGetPhysicalDeviceQueueFamilyProperties", get_families),
         entry("vkGetPhysicalDeviceQueueFamilyProperties2", get_families2),
         entry("vkGetPhysicalDeviceQueueFamilyProperties2KHR", get_families2)},
        name);
    if (own != nullptr) return own;
    if (const PFN_vkVoidFunction device = find_device_function(name)) return device;
    return instance == VK_NULL_HANDLE ? nullptr : functions_of(instance).next(instance, name);
}

}  // namespace
}  // namespace weft::mock_families

extern "C" VK_LAYER_EXPORT VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* layer) {
    layer->loaderLayerInterfaceVersion = 2;
    layer->pfnGetInstanceProcAddr = weft::mock_families::get_instance_function;
    layer->pfnGetDeviceProcAddr = weft::mock_families::get_device_function;
    layer->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
