#include <algorithm>
#include <cassert>
#include <utility>

#include "graph/diagnostics/make_error.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/instance.h"
#include "vulkan/device/messenger.h"
#include "vulkan/device/physical_device.h"
#include "vulkan/device/vk_result.h"
#include "weft/compile.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

namespace {

// Returns, for each queue family of the device, the number of queues to create for `count` logical queues of
// a plan. The number for a family is at most the number of queues that the family has.
std::vector<uint32_t> queue_counts(const DeviceProfile& profile, uint32_t main_family, uint32_t count) {
    std::vector<uint32_t> counts(profile.queue_families.size(), 0);
    counts[main_family] = 1;
    bool first = true;
    for (const LogicalQueue& queue : logical_queues(profile, count)) {
        // The first logical queue is the main queue, which is already counted above, in `main_family`.
        if (!std::exchange(first, false)) ++counts[queue.family];
    }
    for (size_t family = 0; family < counts.size(); ++family)
        counts[family] = std::min(counts[family], profile.queue_families[family].count);
    return counts;
}

std::vector<VkDeviceQueueCreateInfo> queue_create_infos(const std::vector<uint32_t>& counts,
                                                        const std::vector<float>& priorities) {
    std::vector<VkDeviceQueueCreateInfo> infos;
    for (uint32_t family = 0; family < counts.size(); ++family) {
        if (counts[family] == 0) continue;
        VkDeviceQueueCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
        info.queueFamilyIndex = family;
        info.queueCount = counts[family];
        info.pQueuePriorities = priorities.data();
        infos.push_back(info);
    }
    return infos;
}

}  // namespace

// Fills a Device step by step. If a step fails, the destructor of the incomplete device frees the Vulkan
// objects that have been created so far.
struct DeviceBuilder {
    std::unique_ptr<Device> device{new Device};

    Status make_instance(const LoaderFunctions& loader, const DeviceOptions& options);
    Status make_messenger();
    Status make_device(const Candidate& chosen, uint32_t queues);
    void take_queues(const std::vector<uint32_t>& counts);
    void find_sharing_families();
    void describe(const Candidate& candidate);
};

Status DeviceBuilder::make_instance(const LoaderFunctions& loader, const DeviceOptions& options) {
    MessageCollector* collector = options.validate ? &device->messages_ : nullptr;
    Result<Instance> instance = vk::make_instance(loader, collector);
    if (!instance) return instance.take_errors();
    device->owned_ = true;
    device->instance_ = instance->handle;
    *device->instance_functions_ = instance->functions;
    device->debug_utils_ = instance->debug_utils;
    device->info_.layers = std::move(instance->layers);
    return options.validate ? make_messenger() : Status(Unit{});
}

Status DeviceBuilder::make_messenger() {
    const VkDebugUtilsMessengerCreateInfoEXT info = messenger_create_info(device->messages_);
    const VkResult result = device->instance_functions_->vkCreateDebugUtilsMessengerEXT(
        device->instance_, &info, nullptr, &device->messenger_);
    if (result != VK_SUCCESS) return vk_error(result, "creating the validation messenger");
    return Unit{};
}

Status DeviceBuilder::make_device(const Candidate& chosen, uint32_t queues) {
    const InstanceFunctions& fn = *device->instance_functions_;
    FeatureChain supported;
    fn.vkGetPhysicalDeviceFeatures2(chosen.handle, &supported.head());
    FeatureChain enabled;
    required_features(enabled);
    device->optional_ = enable_optional_features(supported, enabled);

    const std::vector<uint32_t> counts = queue_counts(make_profile(fn, chosen.handle), chosen.family, queues);
    const std::vector<float> priorities(std::max(1u, *std::max_element(counts.begin(), counts.end())), 1.0f);
    const std::vector<VkDeviceQueueCreateInfo> queue_infos = queue_create_infos(counts, priorities);
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &enabled.head();
    info.queueCreateInfoCount = static_cast<uint32_t>(queue_infos.size());
    info.pQueueCreateInfos = queue_infos.data();
    const VkResult result = fn.vkCreateDevice(chosen.handle, &info, nullptr, &device->device_);
    if (result != VK_SUCCESS) {
        Diagnostic error = vk_error(result, "creating a device on \"" + chosen.info.name + "\"");
        if (error.code == "V409") error.code = "V406";
        return error;
    }
    *device->functions_ = load_device_functions(fn, device->device_);
    device->families_ = describe_families(fn, chosen.handle);
    take_queues(counts);
    device->queue_ = {device->families_[chosen.family].queues.front(), chosen.family};
    return Unit{};
}

void DeviceBuilder::take_queues(const std::vector<uint32_t>& counts) {
    for (uint32_t family = 0; family < counts.size(); ++family) {
        std::vector<VkQueue>& queues = device->families_[family].queues;
        queues.resize(counts[family]);
        for (uint32_t i = 0; i < counts[family]; ++i)
            device->functions_->vkGetDeviceQueue(device->device_, family, i, &queues[i]);
    }
    find_sharing_families();
}

void DeviceBuilder::find_sharing_families() {
    for (uint32_t family = 0; family < device->families_.size(); ++family)
        if (!device->families_[family].queues.empty()) device->sharing_families_.push_back(family);
    if (device->sharing_families_.size() < 2) device->sharing_families_.clear();
}

void DeviceBuilder::describe(const Candidate& candidate) {
    const InstanceFunctions& fn = *device->instance_functions_;
    device->physical_ = candidate.handle;
    std::vector<LayerInfo> layers = std::move(device->info_.layers);
    device->info_ = candidate.info;
    device->info_.layers = std::move(layers);
    device->profile_ = make_profile(fn, candidate.handle);
    add_optional_features(device->optional_, device->profile_);
    fn.vkGetPhysicalDeviceMemoryProperties(candidate.handle, &device->memory_);
}

Result<std::unique_ptr<Device>> Device::create(const DeviceOptions& options) {
    const Result<LoaderFunctions> loader = require_loader();
    if (!loader) return loader.errors();
    DeviceBuilder builder;
    builder.device->timeout_ns_ = options.timeout_ns;
    if (Status made = builder.make_instance(*loader, options); !made) return made.take_errors();
    const auto candidates = list_devices(*builder.device->instance_functions_, builder.device->instance_);
    const Result<Candidate> chosen = choose_device(candidates, options.device);
    if (!chosen) return chosen.errors();
    if (Status made = builder.make_device(*chosen, options.queues); !made) return made.take_errors();
    builder.describe(*chosen);
    return std::move(builder.device);
}

namespace {

// Returns the features and queues that an embedder's own device lacks. Vulkan cannot report the features that
// a device was created with, so the embedder states them in `own.enabled`.
std::vector<std::string> missing_in(const EmbedderDevice& own, const DeviceInfo& info,
                                    const std::vector<QueueFamily>& families) {
    std::vector<std::string> missing = missing_features(*own.enabled);
    if (info.compiles_for_uniforms && own.enabled->v10().shaderUniformBufferArrayDynamicIndexing != VK_TRUE)
        missing.emplace_back("shaderUniformBufferArrayDynamicIndexing (" + info.driver +
                             " would compile shaders again in every frame without this feature)");
    constexpr VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    const uint32_t first = own.queues.empty() ? UINT32_MAX : own.queues.front().family;
    if (first >= families.size() || (families[first].flags & needed) != needed)
        missing.emplace_back("a first queue that draws and computes");
    for (const Queue& queue : own.queues)
        if (queue.handle == VK_NULL_HANDLE || queue.family >= families.size())
            missing.push_back("a queue of family " + std::to_string(queue.family));
    return missing;
}

Diagnostic incomplete_error(const std::string& name, const std::vector<std::string>& missing) {
    Diagnostic error;
    error.code = "V404";
    error.message = "the VkDevice that the program created on \"" + name + "\" lacks ";
    for (size_t i = 0; i < missing.size(); ++i) error.message += (i == 0 ? "" : ", ") + missing[i];
    error.help = {
        "pass the features that enable_features() sets to vkCreateDevice, and the same features to adopt()"};
    return error;
}

Diagnostic old_instance_error() {
    return make_error("V404", "the VkInstance was created for a Vulkan version older than 1.3",
                      {"set VkApplicationInfo::apiVersion to VK_API_VERSION_1_3"});
}

}  // namespace

Result<std::unique_ptr<Device>> Device::adopt(const EmbedderDevice& own) {
    assert(own.enabled != nullptr && "adopt() can't ask Vulkan what the device was made with");
    const Result<LoaderFunctions> loader = require_loader();
    if (!loader) return loader.errors();
    DeviceBuilder builder;
    Device& made = *builder.device;
    made.timeout_ns_ = own.timeout_ns;
    made.callbacks_ = own.callbacks;
    made.instance_ = own.instance;
    *made.instance_functions_ = load_instance_functions(*loader, own.instance);
    made.debug_utils_ = made.instance_functions_->vkSetDebugUtilsObjectNameEXT != nullptr;
    if (made.instance_functions_->vkGetPhysicalDeviceFeatures2 == nullptr) return old_instance_error();
    const Candidate candidate = describe_device(*made.instance_functions_, own.physical);
    if (!candidate.info.missing.empty()) return unsuitable_error(candidate);
    made.families_ = describe_families(*made.instance_functions_, own.physical);
    const std::vector<std::string> missing = missing_in(own, candidate.info, made.families_);
    if (!missing.empty()) return incomplete_error(candidate.info.name, missing);
    made.device_ = own.device;
    *made.functions_ = load_device_functions(*made.instance_functions_, own.device);
    if (made.functions_->vkCmdPipelineBarrier2 == nullptr) return old_instance_error();
    FeatureChain ours;
    made.optional_ = enable_optional_features(*own.enabled, ours);
    made.queue_ = own.queues.front();
    for (const Queue& queue : own.queues) made.families_[queue.family].queues.push_back(queue.handle);
    builder.find_sharing_families();
    builder.describe(candidate);
    made.info_.timestamps = made.families_[made.queue_.family].timestamps;
    if (!own.callbacks.log) return std::move(builder.device);
    made.messages_.send_to(own.callbacks.log);
    if (made.instance_functions_->vkCreateDebugUtilsMessengerEXT == nullptr) return std::move(builder.device);
    if (Status logged = builder.make_messenger(); !logged) return logged.take_errors();
    return std::move(builder.device);
}

}  // namespace weft::vk
