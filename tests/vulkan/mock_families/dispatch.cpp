#include "tests/vulkan/mock_families/dispatch.h"

#include <map>
#include <memory>
#include <mutex>

namespace weft::mock_families {
namespace {

// A simulated queue. Every dispatchable handle of Vulkan points to an object that begins with the loader's
// dispatch pointer.
struct MockQueue {
    const void* loader_data = nullptr;
    VkQueue real = VK_NULL_HANDLE;
};

struct DeviceEntry {
    PFN_vkGetDeviceProcAddr next = nullptr;
    DeviceFunctions functions;
    std::array<MockQueue, kFamilyCount> queues;
};

// State of the layer. It is global, because the loader calls plain functions and passes no object of the
// layer.
struct Registry {
    std::mutex mutex;
    std::map<const void*, InstanceFunctions> instances;
    std::map<const void*, std::unique_ptr<DeviceEntry>> devices;
};

Registry& registry() {
    static Registry all;
    return all;
}

const void* key_of(const void* dispatchable) {
    return *static_cast<const void* const*>(dispatchable);
}

template <class Function>
void load(PFN_vkGetDeviceProcAddr get, VkDevice device, const char* name, Function& function) {
    function = reinterpret_cast<Function>(get(device, name));
}

DeviceEntry& device_entry(const void* dispatchable) {
    const std::lock_guard lock(registry().mutex);
    return *registry().devices.at(key_of(dispatchable));
}

}  // namespace

void add_instance(VkInstance instance, PFN_vkGetInstanceProcAddr next) {
    const std::lock_guard lock(registry().mutex);
    registry().instances[key_of(instance)] = {
        next, reinterpret_cast<PFN_vkDestroyInstance>(next(instance, "vkDestroyInstance"))};
}

void add_device(VkDevice device, PFN_vkGetDeviceProcAddr next) {
    auto entry = std::make_unique<DeviceEntry>();
    entry->next = next;
    DeviceFunctions& f = entry->functions;
    load(next, device, "vkDestroyDevice", f.vkDestroyDevice);
    load(next, device, "vkGetDeviceQueue", f.vkGetDeviceQueue);
    load(next, device, "vkQueueSubmit", f.vkQueueSubmit);
    load(next, device, "vkQueueSubmit2", f.vkQueueSubmit2);
    load(next, device, "vkQueueWaitIdle", f.vkQueueWaitIdle);
    load(next, device, "vkCreateCommandPool", f.vkCreateCommandPool);
    load(next, device, "vkCreateBuffer", f.vkCreateBuffer);
    load(next, device, "vkCreateImage", f.vkCreateImage);
    load(next, device, "vkGetDeviceBufferMemoryRequirements", f.vkGetDeviceBufferMemoryRequirements);
    load(next, device, "vkGetDeviceImageMemoryRequirements", f.vkGetDeviceImageMemoryRequirements);
    load(next, device, "vkCmdPipelineBarrier2", f.vkCmdPipelineBarrier2);
    const std::lock_guard lock(registry().mutex);
    registry().devices[key_of(device)] = std::move(entry);
}

void forget(VkInstance instance) {
    const std::lock_guard lock(registry().mutex);
    registry().instances.erase(key_of(instance));
}

void forget(VkDevice device) {
    const std::lock_guard lock(registry().mutex);
    registry().devices.erase(key_of(device));
}

InstanceFunctions functions_of(VkInstance instance) {
    const std::lock_guard lock(registry().mutex);
    return registry().instances.at(key_of(instance));
}

PFN_vkGetDeviceProcAddr next_of(VkDevice device) {
    return device_entry(device).next;
}

const DeviceFunctions& functions_of(const void* dispatchable) {
    return device_entry(dispatchable).functions;
}

VkQueue mock_queue(VkDevice device, uint32_t family, VkQueue real) {
    MockQueue& queue = device_entry(device).queues.at(family);
    queue = {key_of(device), real};
    return reinterpret_cast<VkQueue>(&queue);
}

VkQueue real_queue(VkQueue mock) {
    return reinterpret_cast<MockQueue*>(mock)->real;
}

}  // namespace weft::mock_families
