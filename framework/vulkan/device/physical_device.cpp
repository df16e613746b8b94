#include "vulkan/device/physical_device.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "graph/diagnostics/make_error.h"
#include "vulkan/device/functions.h"
#include "weft/vulkan/device_features.h"

namespace weft::vk {
namespace {

// Returns the rank of a kind of device. Among several devices, the one with the smallest rank is preferred.
int rank(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return 0;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return 1;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return 2;
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return 3;
        default:
            return 4;
    }
}

void find_family(const InstanceFunctions& fn, Candidate& candidate) {
    constexpr VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    const std::vector<QueueFamily> families = describe_families(fn, candidate.handle);
    for (uint32_t i = 0; i < families.size(); ++i) {
        if ((families[i].flags & needed) != needed) continue;
        candidate.family = i;
        candidate.info.timestamps = families[i].timestamps;
        return;
    }
    candidate.info.missing.emplace_back("a queue that draws and computes");
}

void find_missing(const InstanceFunctions& fn, Candidate& candidate, uint32_t api_version) {
    if (api_version < VK_API_VERSION_1_3) {
        candidate.info.missing.push_back("Vulkan 1.3 (the device offers " + version_text(api_version) + ")");
        // The feature structs of Vulkan 1.3 must not be queried on an older device.
        return;
    }
    FeatureChain supported;
    fn.vkGetPhysicalDeviceFeatures2(candidate.handle, &supported.head());
    candidate.info.missing = missing_features(supported);
    find_family(fn, candidate);
}

std::string device_list(const std::vector<Candidate>& candidates) {
    std::string text = "this machine has";
    for (size_t i = 0; i < candidates.size(); ++i) {
        text += (i == 0 ? " " : ", ") + std::to_string(i) + ": \"" + candidates[i].info.name + "\"";
    }
    return text;
}

const Candidate* find_wanted(const std::vector<Candidate>& candidates, const std::string& wanted) {
    size_t index = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
    if (error == std::errc{} && end == wanted.data() + wanted.size()) {
        return index < candidates.size() ? &candidates[index] : nullptr;
    }
    const auto it = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& c) {
        return c.info.name.find(wanted) != std::string::npos;
    });
    return it == candidates.end() ? nullptr : &*it;
}

// Returns the words of all device names, for a suggestion "did you mean". One word is enough to select a
// device: "llvmpipe" selects "llvmpipe (LLVM 15.0.6, 256 bits)".
std::vector<std::string> name_words(const std::vector<Candidate>& candidates) {
    std::vector<std::string> words;
    for (const Candidate& candidate : candidates) {
        std::istringstream name(candidate.info.name);
        for (std::string word; name >> word;) words.push_back(word);
    }
    return words;
}

}  // namespace

std::vector<QueueFamily> describe_families(const InstanceFunctions& fn, VkPhysicalDevice physical) {
    uint32_t count = 0;
    fn.vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> properties(count);
    fn.vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, properties.data());
    std::vector<QueueFamily> families;
    for (const VkQueueFamilyProperties& family : properties)
        families.push_back({family.queueFlags, family.timestampValidBits > 0, {}});
    return families;
}

Diagnostic unsuitable_error(const Candidate& candidate) {
    Diagnostic error;
    error.code = "V404";
    error.message = "device \"" + candidate.info.name + "\" lacks ";
    for (size_t i = 0; i < candidate.info.missing.size(); ++i) {
        error.message += (i == 0 ? "" : ", ") + candidate.info.missing[i];
    }
    error.help = {
        "choose another device with --device, or install mesa-vulkan-drivers, whose device llvmpipe has all "
        "required features",
        "`weft doctor` lists the devices of this machine and the features that they lack"};
    return error;
}

Diagnostic no_device_error() {
    return make_error(
        "V402", "no Vulkan device was found",
        {"install a driver: apt-get install mesa-vulkan-drivers (GPUs of AMD and Intel, and llvmpipe, "
         "which needs no GPU)",
         "if a driver is installed, check the environment variables VK_DRIVER_FILES and VK_ICD_FILENAMES"});
}

Candidate describe_device(const InstanceFunctions& fn, VkPhysicalDevice physical) {
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &driver;
    fn.vkGetPhysicalDeviceProperties2(physical, &properties);

    Candidate candidate;
    candidate.handle = physical;
    candidate.type = properties.properties.deviceType;
    candidate.info.name = properties.properties.deviceName;
    candidate.info.driver = std::string(driver.driverName) + " " + driver.driverInfo;
    candidate.info.compiles_for_uniforms = std::string_view(driver.driverName) == "llvmpipe";
    candidate.info.api_version = version_text(properties.properties.apiVersion);
    candidate.info.is_cpu = candidate.type == VK_PHYSICAL_DEVICE_TYPE_CPU;
    candidate.info.timestamp_period_ns = properties.properties.limits.timestampPeriod;
    find_missing(fn, candidate, properties.properties.apiVersion);
    return candidate;
}

std::vector<Candidate> list_devices(const InstanceFunctions& fn, VkInstance instance) {
    uint32_t count = 0;
    if (fn.vkEnumeratePhysicalDevices(instance, &count, nullptr) != VK_SUCCESS) return {};
    std::vector<VkPhysicalDevice> handles(count);
    if (fn.vkEnumeratePhysicalDevices(instance, &count, handles.data()) < VK_SUCCESS) return {};
    handles.resize(count);
    std::vector<Candidate> candidates;
    for (VkPhysicalDevice handle : handles) candidates.push_back(describe_device(fn, handle));
    return candidates;
}

Result<Candidate> choose_device(const std::vector<Candidate>& candidates, const std::string& wanted) {
    if (candidates.empty()) return no_device_error();
    if (!wanted.empty()) {
        const Candidate* found = find_wanted(candidates, wanted);
        if (found == nullptr) {
            Diagnostic error;
            error.code = "V403";
            error.message = "no device matches \"" + wanted + "\"";
            error.help = {device_list(candidates)};
            const std::string guess = did_you_mean_text(wanted, name_words(candidates));
            if (!guess.empty()) error.help.insert(error.help.begin(), guess);
            return error;
        }
        if (!found->info.missing.empty()) return unsuitable_error(*found);
        return *found;
    }
    const Candidate* best = nullptr;
    for (const Candidate& candidate : candidates) {
        if (!candidate.info.missing.empty()) continue;
        if (best == nullptr || rank(candidate.type) < rank(best->type)) best = &candidate;
    }
    if (best != nullptr) return *best;
    Diagnostics errors;
    for (const Candidate& candidate : candidates) errors.push_back(unsuitable_error(candidate));
    return errors;
}

}  // namespace weft::vk
