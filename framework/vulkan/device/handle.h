// Purpose: a Handle owns one Vulkan object, and destroys it through the device's function table. After
// Device::abandon(), it destroys nothing. A Handle can be moved but not copied. The Device must outlive it.
#pragma once

#include <utility>

#include "vulkan/device/functions.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

// `Destroy` is the member of DeviceFunctions that destroys an object of type T, such as
// &DeviceFunctions::vkDestroyImage. Its arguments are device, object and allocator.
template <class T, auto Destroy>
class Handle {
 public:
    Handle() = default;
    Handle(const Device& device, T object) : device_(&device), object_(object) {}
    ~Handle() { reset(); }
    Handle(Handle&& other) noexcept
        : device_(other.device_), object_(std::exchange(other.object_, VK_NULL_HANDLE)) {}
    Handle& operator=(Handle&& other) noexcept {
        if (this != &other) {
            reset();
            device_ = other.device_;
            object_ = std::exchange(other.object_, VK_NULL_HANDLE);
        }
        return *this;
    }

    [[nodiscard]] T get() const { return object_; }
    explicit operator bool() const { return object_ != VK_NULL_HANDLE; }
    void reset() {
        if (object_ != VK_NULL_HANDLE && !device_->abandoned())
            (device_->fn().*Destroy)(device_->handle(), object_, nullptr);
        object_ = VK_NULL_HANDLE;
    }

 private:
    const Device* device_ = nullptr;
    T object_ = VK_NULL_HANDLE;
};

using ImageHandle = Handle<VkImage, &DeviceFunctions::vkDestroyImage>;
using BufferHandle = Handle<VkBuffer, &DeviceFunctions::vkDestroyBuffer>;
using ImageViewHandle = Handle<VkImageView, &DeviceFunctions::vkDestroyImageView>;
using SamplerHandle = Handle<VkSampler, &DeviceFunctions::vkDestroySampler>;
using SetLayoutHandle = Handle<VkDescriptorSetLayout, &DeviceFunctions::vkDestroyDescriptorSetLayout>;
using PipelineLayoutHandle = Handle<VkPipelineLayout, &DeviceFunctions::vkDestroyPipelineLayout>;
using PipelineHandle = Handle<VkPipeline, &DeviceFunctions::vkDestroyPipeline>;
using PipelineCacheHandle = Handle<VkPipelineCache, &DeviceFunctions::vkDestroyPipelineCache>;
using ShaderModuleHandle = Handle<VkShaderModule, &DeviceFunctions::vkDestroyShaderModule>;
using DescriptorPoolHandle = Handle<VkDescriptorPool, &DeviceFunctions::vkDestroyDescriptorPool>;
using CommandPoolHandle = Handle<VkCommandPool, &DeviceFunctions::vkDestroyCommandPool>;
using FenceHandle = Handle<VkFence, &DeviceFunctions::vkDestroyFence>;
using SemaphoreHandle = Handle<VkSemaphore, &DeviceFunctions::vkDestroySemaphore>;
using QueryPoolHandle = Handle<VkQueryPool, &DeviceFunctions::vkDestroyQueryPool>;

}  // namespace weft::vk
