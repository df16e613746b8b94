// Purpose: an instance, a device and its queues, brought up by us or brought along by an embedder. Functions
// are in per-device tables: swapping one pointer is how tests inject faults.
// Errors, each with what to install or do; the program maps V401 to V406 to exit code 4:
//   V401 no loader library    V402 no device           V403 no device of that name
//   V404 a feature is missing V405 no validation layer V406 creation refused
//   V407 time-out             V408 device lost         V409 any other failure       V410 out of memory
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "weft/device_profile.h"
#include "weft/result.h"
#include "weft/vulkan/device_features.h"
#include "weft/vulkan/functions.h"
#include "weft/vulkan/messages.h"

namespace weft::vk {

struct DeviceOptions {
    bool validate = false;  // core and synchronisation validation; any message is collected
    // Index or part of a name. Empty: the first discrete, integrated, virtual, then CPU one that is fit.
    std::string device;
    // For every fence. Generous: a CPU device compiles its shaders within the first frame, on a machine that
    // may be busy.
    uint64_t timeout_ns = 60'000'000'000;
    // How many logical queues plans will use: logical_queues() of the device's profile says which families
    // they are in. Fewer real queues are made where a family has fewer.
    uint32_t queues = 1;
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
    bool compiles_for_uniforms = false;  // llvmpipe: see opaque_uniforms.h
    std::vector<LayerInfo> layers;       // enabled ones
    std::vector<std::string> missing;    // what Weft needs and it lacks: "dynamicRendering"
    float timestamp_period_ns = 1;
    bool timestamps = false;
};

struct Queue {
    VkQueue handle = VK_NULL_HANDLE;
    uint32_t family = 0;
};

// An embedder's own objects. Weft uses them and never destroys them.
struct EmbedderDevice {
    VkInstance instance = VK_NULL_HANDLE;  // made for Vulkan 1.3: VkApplicationInfo::apiVersion
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    // Weft submits to these and no others, from the thread that calls it; nobody else may meanwhile. The
    // first shall draw and compute.
    std::vector<Queue> queues;
    // What `device` was made with: see enable_features(). No extension is needed.
    const FeatureChain* enabled = nullptr;
};

// A queue family of the physical device, and the queues that were made of it.
struct QueueFamily {
    VkQueueFlags flags = 0;
    bool timestamps = false;
    std::vector<VkQueue> queues;
};

class Device {
 public:
    [[nodiscard]] static Result<std::unique_ptr<Device>> create(const DeviceOptions& options);
    // `own.enabled` is read, not kept. Nothing reports to messages(). Errors: V401, and V404 naming all that
    // is missing.
    [[nodiscard]] static Result<std::unique_ptr<Device>> adopt(const EmbedderDevice& own);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] VkInstance instance() const { return instance_; }
    [[nodiscard]] VkPhysicalDevice physical() const { return physical_; }
    [[nodiscard]] VkDevice handle() const { return device_; }
    [[nodiscard]] Queue queue() const { return queue_; }
    // By family index.
    [[nodiscard]] const std::vector<QueueFamily>& families() const { return families_; }
    // The families with queues where there are several, else none: who may share a CONCURRENT resource.
    [[nodiscard]] const std::vector<uint32_t>& sharing_families() const { return sharing_families_; }
    [[nodiscard]] const DeviceFunctions& fn() const { return functions_; }
    [[nodiscard]] DeviceFunctions& fn() { return functions_; }  // for fault injection
    [[nodiscard]] const InstanceFunctions& instance_fn() const { return instance_functions_; }
    [[nodiscard]] const DeviceInfo& info() const { return info_; }
    [[nodiscard]] const DeviceProfile& profile() const { return profile_; }
    [[nodiscard]] const VkPhysicalDeviceMemoryProperties& memory() const { return memory_; }
    [[nodiscard]] MessageCollector& messages() { return messages_; }
    [[nodiscard]] uint64_t timeout_ns() const { return timeout_ns_; }
    // After a time-out the device may still be at work with anything: from now on nothing is destroyed, which
    // is better than destroying it under the device.
    void abandon() { abandoned_ = true; }
    [[nodiscard]] bool abandoned() const { return abandoned_; }
    [[nodiscard]] bool validating() const { return messenger_ != VK_NULL_HANDLE; }

    // Shaders hide the values of their uniforms from this driver: see opaque_uniforms.h. Only where the
    // device was made with shaderUniformBufferArrayDynamicIndexing.
    [[nodiscard]] bool hides_uniforms() const;

    [[nodiscard]] const OptionalFeatures& optional() const { return optional_; }  // the enabled ones

    // Index of a memory type that fits `type_bits` and has `wanted`, or UINT32_MAX.
    [[nodiscard]] uint32_t memory_type(uint32_t type_bits, VkMemoryPropertyFlags wanted) const;
    // Names an object for validation messages and captures; nothing without the debug extension.
    void name(VkObjectType type, uint64_t handle, const std::string& text) const;

 private:
    Device() = default;
    void tear_down();
    friend std::vector<Message> destroy_device(std::unique_ptr<Device> device);

    MessageCollector messages_;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    Queue queue_;
    std::vector<QueueFamily> families_;
    std::vector<uint32_t> sharing_families_;
    bool owned_ = false;
    bool debug_utils_ = false;
    std::atomic<bool> abandoned_ = false;  // one thread may give up while another makes objects
    InstanceFunctions instance_functions_{};
    DeviceFunctions functions_{};
    DeviceInfo info_;
    DeviceProfile profile_;
    OptionalFeatures optional_;
    VkPhysicalDeviceMemoryProperties memory_{};
    uint64_t timeout_ns_ = 0;
    friend struct DeviceBuilder;
};

// Destroys a device and returns all messages, with those that destruction itself caused: objects that are
// still alive are reported only then.
[[nodiscard]] std::vector<Message> destroy_device(std::unique_ptr<Device> device);

// What a run of the program reports about this machine without keeping a device: every device, layers,
// versions.
struct MachineReport {
    std::string loader_version;
    std::vector<DeviceInfo> devices;  // empty without a driver
    std::vector<LayerInfo> layers;    // installed ones
};
// Errors: V401, V406.
[[nodiscard]] Result<MachineReport> inspect_machine();

}  // namespace weft::vk
