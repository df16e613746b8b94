// Purpose: the devices of this machine as plain data, and the choice among them, which is a pure function.
// Errors: V402 no device at all, V403 none of that name, V404 it lacks what Weft needs.
#pragma once

#include <string>
#include <vector>

#include "weft/vulkan/device.h"

namespace weft::vk {

struct Candidate {
    VkPhysicalDevice handle = VK_NULL_HANDLE;
    VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
    DeviceInfo info;      // info.missing: why it cannot be used
    uint32_t family = 0;  // one that draws and computes
};

// Name, driver, version, what is missing; the first family that does.
[[nodiscard]] Candidate describe_device(const InstanceFunctions& fn, VkPhysicalDevice physical);
[[nodiscard]] std::vector<Candidate> list_devices(const InstanceFunctions& fn, VkInstance instance);
// `wanted` is an index, part of a name, or empty.
[[nodiscard]] Result<Candidate> choose_device(const std::vector<Candidate>& candidates,
                                              const std::string& wanted);
// What the families can do; none has a queue yet.
[[nodiscard]] std::vector<QueueFamily> describe_families(const InstanceFunctions& fn,
                                                         VkPhysicalDevice physical);
// V404, naming what is missing.
[[nodiscard]] Diagnostic unsuitable_error(const Candidate& candidate);
// V402, with the packages that bring a driver.
[[nodiscard]] Diagnostic no_device_error();

// What of a profile hangs on features: a device has those that it was made with.
void add_optional_features(const OptionalFeatures& enabled, DeviceProfile& profile);
// The device as the compiler sees it.
[[nodiscard]] DeviceProfile make_profile(const InstanceFunctions& fn, VkPhysicalDevice physical);

}  // namespace weft::vk
