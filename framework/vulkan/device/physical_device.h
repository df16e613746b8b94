// Purpose: describes the devices of this machine as plain data, and chooses one of them with a pure function.
// Errors: V402 (no device), V403 (no device has the wanted name or index), V404 (the device lacks a feature
// that Weft requires).
#pragma once

#include <string>
#include <vector>

#include "vulkan/device/functions.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

struct Candidate {
    VkPhysicalDevice handle = VK_NULL_HANDLE;
    VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
    // Properties of the device. info.missing lists the reasons why Weft cannot use the device; it is empty
    // for a usable one.
    DeviceInfo info;
    // Index of the first queue family that supports graphics and compute.
    uint32_t family = 0;
};

// Reads the name, driver, Vulkan version and missing features of a device, and finds its first queue family
// for graphics and compute.
[[nodiscard]] Candidate describe_device(const InstanceFunctions& fn, VkPhysicalDevice physical);
[[nodiscard]] std::vector<Candidate> list_devices(const InstanceFunctions& fn, VkInstance instance);
// Chooses a device. `wanted` is an index into `candidates`, part of a device name, or empty. If `wanted` is
// empty, the function chooses among the usable devices, in this order of preference: discrete GPU, integrated
// GPU, virtual GPU, CPU, other.
[[nodiscard]] Result<Candidate> choose_device(const std::vector<Candidate>& candidates,
                                              const std::string& wanted);
// Returns the capabilities of each queue family. QueueFamily::queues is empty, because a physical device has
// no VkQueue handles.
[[nodiscard]] std::vector<QueueFamily> describe_families(const InstanceFunctions& fn,
                                                         VkPhysicalDevice physical);
// Returns error V404, which names the features that `candidate` lacks.
[[nodiscard]] Diagnostic unsuitable_error(const Candidate& candidate);
// Returns error V402 (no Vulkan device); its help text names packages that contain a driver.
[[nodiscard]] Diagnostic no_device_error();

// Sets the members of `profile` that depend on optional features. `enabled` says which of these features the
// device has enabled.
void add_optional_features(const OptionalFeatures& enabled, DeviceProfile& profile);
// Converts the properties of a physical device to a DeviceProfile, which Weft's graph compiler needs to make
// plans.
[[nodiscard]] DeviceProfile make_profile(const InstanceFunctions& fn, VkPhysicalDevice physical);

}  // namespace weft::vk
