// Purpose: a VkInstance with the layers and extensions that Weft uses. Errors: V401 (no Vulkan loader),
// V402 (no driver), V405 (validation was requested but is not installed), V406 (creation failed).
#pragma once

#include <vector>

#include "vulkan/device/functions.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

inline constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

struct Instance {
    VkInstance handle = VK_NULL_HANDLE;
    InstanceFunctions functions;
    bool debug_utils = false;
    // The enabled layers, with their versions.
    std::vector<LayerInfo> layers;
};

[[nodiscard]] Result<LoaderFunctions> require_loader(const char* library = kLoaderLibrary);
// If `collector` is not null, the validation layer is enabled and reports to `collector`, even while the
// instance is being created.
[[nodiscard]] Result<Instance> make_instance(const LoaderFunctions& loader, MessageCollector* collector);
[[nodiscard]] std::vector<LayerInfo> installed_layers(const LoaderFunctions& loader);

}  // namespace weft::vk
