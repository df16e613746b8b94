#include <utility>

#include "vulkan/device/instance.h"
#include "vulkan/device/physical_device.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

Result<MachineReport> inspect_machine() {
    const Result<LoaderFunctions> loader = require_loader();
    if (!loader) return loader.errors();
    MachineReport report;
    uint32_t version = 0;
    if (loader->vkEnumerateInstanceVersion(&version) == VK_SUCCESS)
        report.loader_version = version_text(version);
    report.layers = installed_layers(*loader);

    Result<Instance> instance = make_instance(*loader, nullptr);
    if (!instance) {
        // If the machine has no driver, the report has no devices; this is a valid result, not an error.
        if (instance.errors().front().code == "V402") return report;
        return instance.take_errors();
    }
    for (Candidate& candidate : list_devices(instance->functions, instance->handle)) {
        report.devices.push_back(std::move(candidate.info));
    }
    instance->functions.vkDestroyInstance(instance->handle, nullptr);
    return report;
}

}  // namespace weft::vk
