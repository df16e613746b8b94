// Purpose: describes the devices of this machine as plain data, and chooses one of them with a pure function.
// Errors: V402 no device, V403 no device of that name, V404 it lacks a feature that Weft requires.
#pragma once

#include <string>
#include <vector>

#include "vulkan/device/functions.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

struct Candidate {
    VkPhysicalDevice handle = VK_NULL_HANDLE;
    VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
    DeviceInfo info;      // info.missing has the reasons why the device cannot be used
    uint32_t family = 0;  // a queue family for graphics and compute
};

// Reads name, driver, version, missing features, and the first family for graphics and compute.
[[nodiscard]] Candidate describe_device(const InstanceFunctions& fn, VkPhysicalDevice physical);
[[nodiscard]] std::vector<Candidate> list_devices(const InstanceFunctions& fn, VkInstance instance);
// `wanted` is an index, part of a name, or empty.
[[nodiscard]] Result<Candidate> choose_device(const std::vector<Candidate>& candidates,
                                              const std::string& wanted);
// The capabilities of the families; their numbers of queues are not set yet.
[[nodiscard]] std::vector<QueueFamily> describe_families(const InstanceFunctions& fn,
                                                         VkPhysicalDevice physical);
// V404, naming the missing features.
[[nodiscard]] Diagnostic unsuitable_error(const Candidate& candidate);
// V402, naming packages that contain a driver.
[[nodiscard]] Diagnostic no_device_error();

// Adds the parts of a profile that depend on features, for the features enabled on the device.
void add_optional_features(const OptionalFeatures& enabled, DeviceProfile& profile);
// Converts the device's properties to the profile that the compiler uses.
[[nodiscard]] DeviceProfile make_profile(const InstanceFunctions& fn, VkPhysicalDevice physical);

}  // namespace weft::vk
