// Purpose: a Vulkan instance, a device and its queues, created by Weft or provided by an embedder. Vulkan
// functions are called through tables of pointers, so that tests can replace a function and inject faults.
// Errors, each with a remedy; for V401 to V406 the program ends with exit code 4:
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
#include "weft/vulkan/embedder_callbacks.h"
#include "weft/vulkan/messages.h"

namespace weft::vk {

struct DeviceFunctions;
struct InstanceFunctions;

struct DeviceOptions {
    // True: enables the validation layer with synchronisation validation, and collects all its messages.
    bool validate = false;
    // The device to use: an index, or a part of its name. Empty: the first suitable device, in the order
    // discrete, integrated, virtual, CPU.
    std::string device;
    // Time-out for every wait for the GPU. It is long because a CPU device compiles its shaders in the first
    // frame, and because the machine may be busy.
    uint64_t timeout_ns = 60'000'000'000;
    // Number of logical queues that plans will use. logical_queues() chooses their families. If a family has
    // fewer queues than needed, several logical queues share one device queue.
    uint32_t queues = 1;
};

struct LayerInfo {
    std::string name;
    std::string version;  // Version as text, such as "1.3.239".
};

struct DeviceInfo {
    std::string name;
    std::string driver;  // Driver and its version, such as "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)".
    std::string api_version;
    bool is_cpu = false;
    // True for llvmpipe, which compiles a shader again when a uniform value changes; see opaque_uniforms.h.
    bool compiles_for_uniforms = false;
    std::vector<LayerInfo> layers;  // The layers that are enabled.
    // Names of required features that the device lacks, such as "dynamicRendering".
    std::vector<std::string> missing;
    float timestamp_period_ns = 1;
    bool timestamps = false;
};

struct Queue {
    VkQueue handle = VK_NULL_HANDLE;
    uint32_t family = 0;
};

// The Vulkan objects of an embedder. Weft uses them but never destroys them.
struct EmbedderDevice {
    VkInstance instance = VK_NULL_HANDLE;  // Must be created for Vulkan 1.3 (VkApplicationInfo::apiVersion).
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    // Weft submits only to these queues, from the thread that calls Weft. While such a call runs, other
    // threads must not use the queues. The first queue must support graphics and compute.
    std::vector<Queue> queues;
    // The features that are enabled in `device`; see enable_features(). No extension is required.
    const FeatureChain* enabled = nullptr;
    EmbedderCallbacks callbacks = {};
    // Time-out for every wait for the GPU, also for a frame that the program submits itself
    // (FrameSubmit::ticket).
    uint64_t timeout_ns = 60'000'000'000;
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
    // Makes a Device from the embedder's objects. `own.enabled` is read only during the call. messages()
    // stays empty: messages go to EmbedderCallbacks::log. Errors: V401, and V404, which names all missing
    // features.
    [[nodiscard]] static Result<std::unique_ptr<Device>> adopt(const EmbedderDevice& own);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] VkInstance instance() const { return instance_; }
    [[nodiscard]] VkPhysicalDevice physical() const { return physical_; }
    [[nodiscard]] VkDevice handle() const { return device_; }
    [[nodiscard]] Queue queue() const { return queue_; }
    // Returns the queue families of the physical device. The index is the number of the family.
    [[nodiscard]] const std::vector<QueueFamily>& families() const { return families_; }
    // Returns the families to name when a resource is created with VK_SHARING_MODE_CONCURRENT: all families
    // with queues, or none if only one family has queues.
    [[nodiscard]] const std::vector<uint32_t>& sharing_families() const { return sharing_families_; }
    [[nodiscard]] const DeviceFunctions& fn() const { return *functions_; }
    // Returns the function table for writing: tests replace functions to inject faults.
    [[nodiscard]] DeviceFunctions& fn() { return *functions_; }
    [[nodiscard]] const InstanceFunctions& instance_fn() const { return *instance_functions_; }
    [[nodiscard]] const DeviceInfo& info() const { return info_; }
    [[nodiscard]] const DeviceProfile& profile() const { return profile_; }
    [[nodiscard]] const VkPhysicalDeviceMemoryProperties& memory() const { return memory_; }
    [[nodiscard]] MessageCollector& messages() { return messages_; }
    [[nodiscard]] uint64_t timeout_ns() const { return timeout_ns_; }
    [[nodiscard]] const EmbedderCallbacks& callbacks() const { return callbacks_; }
    // Sends warnings or errors, from diagnostics[first] on, to the program's log function, if there is one.
    void log(const Diagnostics& diagnostics, size_t first = 0) const;
    // Keeps all objects from being destroyed from now on. It is called after a time-out, because the device
    // may still use the objects, and Vulkan forbids the destruction of objects in use.
    void abandon() { abandoned_ = true; }
    [[nodiscard]] bool abandoned() const { return abandoned_; }
    [[nodiscard]] bool validating() const { return messenger_ != VK_NULL_HANDLE; }

    // Returns true if uniform values must be hidden from the compiler of this driver; see opaque_uniforms.h.
    // Weft can hide them only if the device has the feature shaderUniformBufferArrayDynamicIndexing.
    [[nodiscard]] bool hides_uniforms() const;

    // Returns the optional features that are enabled.
    [[nodiscard]] const OptionalFeatures& optional() const { return optional_; }

    // Returns the index of a memory type that is allowed by `type_bits` and has all properties `wanted`;
    // UINT32_MAX if there is none.
    [[nodiscard]] uint32_t memory_type(uint32_t type_bits, VkMemoryPropertyFlags wanted) const;
    // Gives an object a name for validation messages and captures. Does nothing without the debug utils
    // extension.
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
    // Atomic, because one thread may call abandon() while another thread creates objects.
    std::atomic<bool> abandoned_ = false;
    std::unique_ptr<InstanceFunctions> instance_functions_;
    std::unique_ptr<DeviceFunctions> functions_;
    DeviceInfo info_;
    DeviceProfile profile_;
    OptionalFeatures optional_;
    VkPhysicalDeviceMemoryProperties memory_{};
    uint64_t timeout_ns_ = 0;
    EmbedderCallbacks callbacks_;
    friend struct DeviceBuilder;
};

// Destroys a device and returns all messages of the validation layer. They include messages about the
// destruction, which tell about objects that were not freed.
[[nodiscard]] std::vector<Message> destroy_device(std::unique_ptr<Device> device);

// Information about the machine that needs no logical device: physical devices, layers, versions.
struct MachineReport {
    std::string loader_version;
    std::vector<DeviceInfo> devices;  // The physical devices; empty if there is no driver.
    std::vector<LayerInfo> layers;    // The layers that are installed.
};
// Collects the report. Errors: V401, V406.
[[nodiscard]] Result<MachineReport> inspect_machine();

}  // namespace weft::vk
