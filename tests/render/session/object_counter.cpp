#include "tests/render/session/object_counter.h"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <map>
#include <mutex>
#include <utility>

#include "vulkan/device/functions.h"

namespace weft::test {
namespace {

// Global, because the counting functions are plain functions. They have no access to the ObjectCounter.
std::atomic<int64_t> live_objects = 0;

// The allocations of device memory.
struct {
    std::mutex mutex;
    std::map<VkDeviceMemory, uint64_t> sizes_bytes;
    uint64_t live_bytes = 0, most_bytes = 0;
    PFN_vkAllocateMemory allocate = nullptr;
    PFN_vkFreeMemory free = nullptr;
} device_memory;

VKAPI_ATTR VkResult VKAPI_CALL allocate_counted(VkDevice device, const VkMemoryAllocateInfo* info,
                                                const VkAllocationCallbacks* callbacks,
                                                VkDeviceMemory* memory) {
    const VkResult result = device_memory.allocate(device, info, callbacks, memory);
    if (result != VK_SUCCESS) return result;
    ++live_objects;
    const std::lock_guard lock(device_memory.mutex);
    device_memory.sizes_bytes[*memory] = info->allocationSize;
    device_memory.live_bytes += info->allocationSize;
    device_memory.most_bytes = std::max(device_memory.most_bytes, device_memory.live_bytes);
    return result;
}

VKAPI_ATTR void VKAPI_CALL free_counted(VkDevice device, VkDeviceMemory memory,
                                        const VkAllocationCallbacks* callbacks) {
    --live_objects;
    {
        const std::lock_guard lock(device_memory.mutex);
        if (const auto found = device_memory.sizes_bytes.find(memory);
            found != device_memory.sizes_bytes.end()) {
            device_memory.live_bytes -= found->second;
            device_memory.sizes_bytes.erase(found);
        }
    }
    device_memory.free(device, memory, callbacks);
}

void count_memory(vk::DeviceFunctions& table) {
    device_memory.sizes_bytes.clear();
    device_memory.live_bytes = device_memory.most_bytes = 0;
    device_memory.allocate = table.vkAllocateMemory;
    device_memory.free = table.vkFreeMemory;
    table.vkAllocateMemory = allocate_counted;
    table.vkFreeMemory = free_counted;
}

template <auto Create, class Function>
struct Made;
template <auto Create, class... Args>
struct Made<Create, VkResult(VKAPI_PTR*)(Args...)> {
    static inline VkResult(VKAPI_PTR* real)(Args...) = nullptr;
    static VKAPI_ATTR VkResult VKAPI_CALL call(Args... args) {
        const VkResult result = real(args...);
        if (result == VK_SUCCESS) ++live_objects;
        return result;
    }
};

template <auto Destroy, class Function>
struct Gone;
template <auto Destroy, class... Args>
struct Gone<Destroy, void(VKAPI_PTR*)(Args...)> {
    static inline void(VKAPI_PTR* real)(Args...) = nullptr;
    static VKAPI_ATTR void VKAPI_CALL call(Args... args) {
        --live_objects;
        real(args...);
    }
};

template <auto Create>
void count_made(vk::DeviceFunctions& table) {
    using MadeBy = Made<Create, std::remove_reference_t<decltype(table.*Create)>>;
    MadeBy::real = table.*Create;
    table.*Create = MadeBy::call;
}

template <auto Create, auto Destroy>
void count(vk::DeviceFunctions& table) {
    using GoneBy = Gone<Destroy, std::remove_reference_t<decltype(table.*Destroy)>>;
    count_made<Create>(table);
    GoneBy::real = table.*Destroy;
    table.*Destroy = GoneBy::call;
}

}  // namespace

ObjectCounter::ObjectCounter(vk::Device& device) : device_(device), functions_(device.fn()) {
    using Table = vk::DeviceFunctions;
    Table& table = device.fn();
    live_objects = 0;
    count<&Table::vkCreateImage, &Table::vkDestroyImage>(table);
    count<&Table::vkCreateBuffer, &Table::vkDestroyBuffer>(table);
    count<&Table::vkCreateImageView, &Table::vkDestroyImageView>(table);
    count_memory(table);
    count<&Table::vkCreateSampler, &Table::vkDestroySampler>(table);
    count<&Table::vkCreateDescriptorSetLayout, &Table::vkDestroyDescriptorSetLayout>(table);
    count<&Table::vkCreateDescriptorPool, &Table::vkDestroyDescriptorPool>(table);
    count<&Table::vkCreatePipelineLayout, &Table::vkDestroyPipelineLayout>(table);
    count<&Table::vkCreatePipelineCache, &Table::vkDestroyPipelineCache>(table);
    // Counting calls is enough for pipelines, because each call in these tests makes one pipeline. Graphics
    // and compute pipelines share one destroy function.
    count<&Table::vkCreateGraphicsPipelines, &Table::vkDestroyPipeline>(table);
    count_made<&Table::vkCreateComputePipelines>(table);
    count<&Table::vkCreateShaderModule, &Table::vkDestroyShaderModule>(table);
    count<&Table::vkCreateCommandPool, &Table::vkDestroyCommandPool>(table);
    count<&Table::vkCreateFence, &Table::vkDestroyFence>(table);
    count<&Table::vkCreateSemaphore, &Table::vkDestroySemaphore>(table);
    count<&Table::vkCreateQueryPool, &Table::vkDestroyQueryPool>(table);
}

ObjectCounter::~ObjectCounter() {
    device_.fn() = functions_;
}

int64_t ObjectCounter::live() const {
    return live_objects;
}

uint64_t ObjectCounter::live_bytes() const {
    const std::lock_guard lock(device_memory.mutex);
    return device_memory.live_bytes;
}

uint64_t ObjectCounter::take_most_bytes() {
    const std::lock_guard lock(device_memory.mutex);
    return std::exchange(device_memory.most_bytes, device_memory.live_bytes);
}

uint64_t resident_bytes() {
    malloc_trim(0);
    uint64_t pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return resident * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace weft::test
