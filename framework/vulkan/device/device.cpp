#include "weft/vulkan/device.h"

#include <utility>

#include "vulkan/device/functions.h"

namespace weft::vk {

Device::Device()
    : instance_functions_(std::make_unique<InstanceFunctions>()),
      functions_(std::make_unique<DeviceFunctions>()) {}

Device::~Device() {
    tear_down();
}

void Device::tear_down() {
    const bool destroys = std::exchange(owned_, false) && !abandoned_;
    // The messenger is destroyed after the device, so that it also reports objects that were still alive when
    // the device was destroyed. The messenger of an adopted device, which the program created, refers to this
    // object. So that messenger is destroyed even after abandon().
    if (destroys && device_ != VK_NULL_HANDLE) functions_->vkDestroyDevice(device_, nullptr);
    if (messenger_ != VK_NULL_HANDLE && (destroys || callbacks_.log))
        instance_functions_->vkDestroyDebugUtilsMessengerEXT(instance_, std::exchange(messenger_, nullptr),
                                                             nullptr);
    if (destroys && instance_ != VK_NULL_HANDLE) instance_functions_->vkDestroyInstance(instance_, nullptr);
}

std::vector<Message> destroy_device(std::unique_ptr<Device> device) {
    device->tear_down();
    return device->messages().messages();
}

bool Device::hides_uniforms() const {
    return info_.compiles_for_uniforms && optional_.uniform_array_indexing;
}

uint32_t Device::memory_type(uint32_t type_bits, VkMemoryPropertyFlags wanted) const {
    for (uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
        if ((type_bits & (1u << i)) == 0) continue;
        if ((memory_.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    }
    return UINT32_MAX;
}

void Device::log(const Diagnostics& diagnostics, size_t first) const {
    if (!callbacks_.log) return;
    for (size_t i = first; i < diagnostics.size(); ++i) {
        const Diagnostic& d = diagnostics[i];
        callbacks_.log({d.severity == Severity::error ? MessageSeverity::error : MessageSeverity::warning,
                        d.code,
                        {},
                        to_text({d})});
    }
}

void Device::name(VkObjectType type, uint64_t handle, const std::string& text) const {
    if (!debug_utils_ || handle == 0) return;
    VkDebugUtilsObjectNameInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
    info.objectType = type;
    info.objectHandle = handle;
    info.pObjectName = text.c_str();
    // If the call fails, only the name of the object in messages is lost, so the result is ignored.
    (void)instance_functions_->vkSetDebugUtilsObjectNameEXT(device_, &info);
}

}  // namespace weft::vk
