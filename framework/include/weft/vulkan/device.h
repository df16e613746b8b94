// Purpose: an instance, a device and its queues, created by Weft or provided by an embedder. Functions are in
// tables per device, so tests can inject faults by replacing a pointer.
// Errors, each with a remedy; the program maps V401 to V406 to exit code 4:
//   V401 no loader library    V402 no device           V403 no device of that name
//   V404 a feature is missing V405 no validation layer V406 creation failed
//   V407 time-out             V408 device lost         V409 any other failure       V410 out of memory
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "weft/device_profile.h"
#include "weft/result.h"
#include "weft/vulkan/device_features.h"
#include "weft/vulkan/messages.h"

namespace weft::vk {

struct DeviceFunctions;
struct InstanceFunctions;

struct DeviceOptions {
    bool validate = false;  // core and synchronisation validation; all messages are collected
    // Index or part of a name. Empty: the first suitable device, in the order discrete, integrated, virtual,
    // CPU.
    std::string device;
    // Time-out for every fence. It is long, because a CPU device compiles its shaders in the first frame, and
    // the machine may be busy.
    uint64_t timeout_ns = 60'000'000'000;
    // Number of logical queues that plans will use, in the families given by logical_queues() of the device's
    // profile. If a family has fewer queues, fewer are created.
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
    bool compiles_for_uniforms = false;  // for llvmpipe: see opaque_uniforms.h
    std::vector<LayerInfo> layers;       // the enabled layers
    std::vector<std::string> missing;    // required features that it lacks: "dynamicRendering"
    float timestamp_period_ns = 1;
    bool timestamps = false;
};

struct Queue {
    VkQueue handle = VK_NULL_HANDLE;
    uint32_t family = 0;
};

// An embedder's own objects. Weft uses them but never destroys them.
struct EmbedderDevice {
    VkInstance instance = VK_NULL_HANDLE;  // created for Vulkan 1.3: VkApplicationInfo::apiVersion
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    // Weft submits only to these queues, from the thread that calls it; other threads must not use them
    // meanwhile. The first queue must support graphics and compute.
    std::vector<Queue> queues;
    // The features that `device` was created with: see enable_features(). No extension is required.
    const FeatureChain* enabled = nullptr;
};

// A queue family of the physical device, and the queues created from it.
struct QueueFamily {
    VkQueueFlags flags = 0;
    bool timestamps = false;
    std::vector<VkQueue> queues;
};

class Device {
 public:
    [[nodiscard]] static Result<std::unique_ptr<Device>> create(const DeviceOptions& options);
    // `own.enabled` is read, but not kept. messages() stays empty. Errors: V401, and V404 naming all missing
    // features.
    [[nodiscard]] static Result<std::unique_ptr<Device>> adopt(const EmbedderDevice& own);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] VkInstance instance() const { return instance_; }
    [[nodiscard]] VkPhysicalDevice physical() const { return physical_; }
    [[nodiscard]] VkDevice handle() const { return device_; }
    [[nodiscard]] Queue queue() const { return queue_; }
    // Indexed by family.
    [[nodiscard]] const std::vector<QueueFamily>& families() const { return families_; }
    // The families with queues if there are several, else none: the families of a CONCURRENT resource.
    [[nodiscard]] const std::vector<uint32_t>& sharing_families() const { return sharing_families_; }
    [[nodiscard]] const DeviceFunctions& fn() const { return *functions_; }
    [[nodiscard]] DeviceFunctions& fn() { return *functions_; }  // for fault injection
    [[nodiscard]] const InstanceFunctions& instance_fn() const { return *instance_functions_; }
    [[nodiscard]] const DeviceInfo& info() const { return info_; }
    [[nodiscard]] const DeviceProfile& profile() const { return profile_; }
    [[nodiscard]] const VkPhysicalDeviceMemoryProperties& memory() const { return memory_; }
    [[nodiscard]] MessageCollector& messages() { return messages_; }
    [[nodiscard]] uint64_t timeout_ns() const { return timeout_ns_; }
    // Prevents all later destruction of objects: after a time-out the device may still use them, and
    // destroying an object in use would be worse.
    void abandon() { abandoned_ = true; }
    [[nodiscard]] bool abandoned() const { return abandoned_; }
    [[nodiscard]] bool validating() const { return messenger_ != VK_NULL_HANDLE; }

    // True if shaders must hide uniform values from this driver: see opaque_uniforms.h. Requires a device
    // created with shaderUniformBufferArrayDynamicIndexing.
    [[nodiscard]] bool hides_uniforms() const;

    [[nodiscard]] const OptionalFeatures& optional() const { return optional_; }  // the enabled features

    // Index of a memory type that is in `type_bits` and has the properties `wanted`, or UINT32_MAX.
    [[nodiscard]] uint32_t memory_type(uint32_t type_bits, VkMemoryPropertyFlags wanted) const;
    // Names an object for validation messages and captures; does nothing without the debug extension.
    void name(VkObjectType type, uint64_t handle, const std::string& text) const;

 private:
    Device();
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
    std::unique_ptr<InstanceFunctions> instance_functions_;
    std::unique_ptr<DeviceFunctions> functions_;
    DeviceInfo info_;
    DeviceProfile profile_;
    OptionalFeatures optional_;
    VkPhysicalDeviceMemoryProperties memory_{};
    uint64_t timeout_ns_ = 0;
    friend struct DeviceBuilder;
};

// Destroys a device and returns all messages, including those of the destruction itself, which reports
// objects that were not freed.
[[nodiscard]] std::vector<Message> destroy_device(std::unique_ptr<Device> device);

// Information about this machine that needs no device: all devices, layers, versions.
struct MachineReport {
    std::string loader_version;
    std::vector<DeviceInfo> devices;  // empty if there is no driver
    std::vector<LayerInfo> layers;    // the installed layers
};
// Errors: V401, V406.
[[nodiscard]] Result<MachineReport> inspect_machine();

}  // namespace weft::vk
