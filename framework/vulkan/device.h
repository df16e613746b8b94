// Purpose: an instance, a device and its queues, brought up by us or brought along by an embedder. Functions
// are in per-device tables: swapping one pointer is how tests inject faults. Errors: V4xx "no device" carries
// what to install; the program maps them to exit code 4.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "vulkan/functions.h"
#include "vulkan/messages.h"
#include "weft/device_profile.h"
#include "weft/result.h"

namespace weft::vk {

struct DeviceOptions {
    bool validate = false;  // core and synchronisation validation; any message is collected
    std::string
        device;  // index or part of a name; empty: the first discrete, integrated, virtual, then CPU one
    uint64_t timeout_ns = 10'000'000'000;  // for every fence
};

struct LayerInfo {
    std::string name;
    std::string version;  // "1.3.239"
};

struct DeviceInfo {
    std::string name;
    std::string driver;  // "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)"
    std::string api_version;
    bool is_cpu = false;
    std::vector<LayerInfo> layers;  // enabled ones
    float timestamp_period_ns = 1;
    bool timestamps = false;
};

struct Queue {
    VkQueue handle = VK_NULL_HANDLE;
    uint32_t family = 0;
};

class Device {
 public:
    [[nodiscard]] static Result<std::unique_ptr<Device>> create(const DeviceOptions& options);
    // An embedder's own objects; they are used, never destroyed. `queue` must support graphics and compute,
    // and the device must have been made with required_features().
    [[nodiscard]] static Result<std::unique_ptr<Device>> adopt(VkInstance instance, VkPhysicalDevice physical,
                                                               VkDevice device, Queue queue);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] VkInstance instance() const { return instance_; }
    [[nodiscard]] VkPhysicalDevice physical() const { return physical_; }
    [[nodiscard]] VkDevice handle() const { return device_; }
    [[nodiscard]] Queue queue() const { return queue_; }
    [[nodiscard]] const DeviceFunctions& fn() const { return functions_; }
    [[nodiscard]] DeviceFunctions& fn() { return functions_; }  // for fault injection
    [[nodiscard]] const InstanceFunctions& instance_fn() const { return instance_functions_; }
    [[nodiscard]] const DeviceInfo& info() const { return info_; }
    [[nodiscard]] const DeviceProfile& profile() const { return profile_; }
    [[nodiscard]] const VkPhysicalDeviceMemoryProperties& memory() const { return memory_; }
    [[nodiscard]] MessageCollector& messages() { return messages_; }
    [[nodiscard]] uint64_t timeout_ns() const { return timeout_ns_; }
    [[nodiscard]] bool validating() const { return messenger_ != VK_NULL_HANDLE; }

    // Index of a memory type that fits `type_bits` and has `wanted`, or UINT32_MAX.
    [[nodiscard]] uint32_t memory_type(uint32_t type_bits, VkMemoryPropertyFlags wanted) const;
    // Names an object for validation messages and captures; nothing without the debug extension.
    void name(VkObjectType type, uint64_t handle, const std::string& text) const;

 private:
    Device() = default;

    MessageCollector messages_;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    Queue queue_;
    bool owned_ = false;
    bool debug_utils_ = false;
    InstanceFunctions instance_functions_{};
    DeviceFunctions functions_{};
    DeviceInfo info_;
    DeviceProfile profile_;
    VkPhysicalDeviceMemoryProperties memory_{};
    uint64_t timeout_ns_ = 0;
    friend struct DeviceBuilder;
};

// What a run of the program reports about this machine without keeping a device: every device, layers,
// versions.
struct MachineReport {
    std::string loader_version;
    std::vector<DeviceInfo> devices;
    std::vector<LayerInfo> layers;
};
[[nodiscard]] Result<MachineReport> inspect_machine();

}  // namespace weft::vk
