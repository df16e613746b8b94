#include "vulkan/device/instance.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "graph/diagnostics/make_error.h"
#include "vulkan/device/messenger.h"
#include "vulkan/device/physical_device.h"
#include "vulkan/device/vk_result.h"

namespace weft::vk {
namespace {

bool has_extension(const LoaderFunctions& loader, const char* layer, const char* name) {
    uint32_t count = 0;
    if (loader.vkEnumerateInstanceExtensionProperties(layer, &count, nullptr) != VK_SUCCESS) return false;
    std::vector<VkExtensionProperties> properties(count);
    if (loader.vkEnumerateInstanceExtensionProperties(layer, &count, properties.data()) < VK_SUCCESS)
        return false;
    return std::any_of(properties.begin(), properties.end(), [&](const VkExtensionProperties& p) {
        return std::strcmp(p.extensionName, name) == 0;
    });
}

Diagnostic missing_layer_error() {
    return make_error(
        "V405",
        std::string("validation needs the Vulkan layer ") + kValidationLayer + ", which was not found",
        {"install the layer: apt-get install vulkan-validationlayers",
         "if the layer is installed, check the environment variable VK_LAYER_PATH"});
}

Diagnostic creation_error(VkResult result) {
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER) return no_device_error();
    Diagnostic error = vk_error(result, "creating a Vulkan instance");
    if (error.code == "V409") {
        error.code = "V406";
        error.help = {
            "check with `vulkaninfo --summary` (package vulkan-tools) whether the drivers can be loaded"};
    }
    return error;
}

}  // namespace

Result<LoaderFunctions> require_loader(const char* library) {
    if (const auto loader = load_loader(library)) return *loader;
    return make_error("V401", std::string("the Vulkan loader ") + library + " is not installed",
                      {"install the loader and a driver: apt-get install libvulkan1 mesa-vulkan-drivers"});
}

std::vector<LayerInfo> installed_layers(const LoaderFunctions& loader) {
    uint32_t count = 0;
    if (loader.vkEnumerateInstanceLayerProperties(&count, nullptr) != VK_SUCCESS) return {};
    std::vector<VkLayerProperties> properties(count);
    if (loader.vkEnumerateInstanceLayerProperties(&count, properties.data()) < VK_SUCCESS) return {};
    std::vector<LayerInfo> layers;
    for (const VkLayerProperties& layer : properties) {
        layers.push_back({layer.layerName, version_text(layer.specVersion)});
    }
    return layers;
}

Result<Instance> make_instance(const LoaderFunctions& loader, MessageCollector* collector) {
    Instance instance;
    std::vector<const char*> layers;
    std::vector<const char*> extensions;
    instance.debug_utils = has_extension(loader, nullptr, VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

    VkDebugUtilsMessengerCreateInfoEXT messenger{};
    constexpr std::array enables{VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT features{};
    features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
    features.enabledValidationFeatureCount = static_cast<uint32_t>(enables.size());
    features.pEnabledValidationFeatures = enables.data();

    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pEngineName = "weft";
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;

    if (collector != nullptr) {
        const auto installed = installed_layers(loader);
        const auto layer = std::find_if(installed.begin(), installed.end(),
                                        [](const LayerInfo& l) { return l.name == kValidationLayer; });
        if (layer == installed.end()) return missing_layer_error();
        instance.layers.push_back(*layer);
        // The validation layer provides VK_EXT_debug_utils even if the loader does not.
        instance.debug_utils = true;
        layers.push_back(kValidationLayer);
        extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
        messenger = messenger_create_info(*collector);
        messenger.pNext = &features;
        info.pNext = &messenger;
    }
    if (instance.debug_utils) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    info.enabledLayerCount = static_cast<uint32_t>(layers.size());
    info.ppEnabledLayerNames = layers.data();
    info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();

    const VkResult result = loader.vkCreateInstance(&info, nullptr, &instance.handle);
    if (result != VK_SUCCESS) return creation_error(result);
    instance.functions = load_instance_functions(loader, instance.handle);
    return instance;
}

}  // namespace weft::vk
