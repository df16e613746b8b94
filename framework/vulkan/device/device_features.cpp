#include "weft/vulkan/device_features.h"

#include <array>

namespace weft::vk {
namespace {

template <class Struct>
struct Feature {
    const char* name;
    VkBool32 Struct::*member;
};

template <class Struct>
struct OptionalFeature {
    VkBool32 Struct::*member;
    bool OptionalFeatures::*flag;
};

using F10 = VkPhysicalDeviceFeatures;
using F11 = VkPhysicalDeviceVulkan11Features;
using F12 = VkPhysicalDeviceVulkan12Features;
using F13 = VkPhysicalDeviceVulkan13Features;

constexpr std::array kRequired10{
    Feature<F10>{"independentBlend", &F10::independentBlend},
    Feature<F10>{"fragmentStoresAndAtomics", &F10::fragmentStoresAndAtomics},
    Feature<F10>{"shaderStorageImageExtendedFormats", &F10::shaderStorageImageExtendedFormats},
    Feature<F10>{"shaderStorageImageWriteWithoutFormat", &F10::shaderStorageImageWriteWithoutFormat},
};
constexpr std::array kRequired12{
    Feature<F12>{"timelineSemaphore", &F12::timelineSemaphore},
    Feature<F12>{"hostQueryReset", &F12::hostQueryReset},
    Feature<F12>{"separateDepthStencilLayouts", &F12::separateDepthStencilLayouts},
    Feature<F12>{"uniformBufferStandardLayout", &F12::uniformBufferStandardLayout},
};
// Weft needs `maintenance4` because glslang uses LocalSizeId if specialisation constants set a work group
// size. Weft needs the last two features of this table because shader compilers translate GLSL's `discard` to
// an instruction that requires one of them.
constexpr std::array kRequired13{
    Feature<F13>{"dynamicRendering", &F13::dynamicRendering},
    Feature<F13>{"synchronization2", &F13::synchronization2},
    Feature<F13>{"maintenance4", &F13::maintenance4},
    Feature<F13>{"shaderDemoteToHelperInvocation", &F13::shaderDemoteToHelperInvocation},
    Feature<F13>{"shaderTerminateInvocation", &F13::shaderTerminateInvocation},
};

constexpr std::array kOptional10{
    OptionalFeature<F10>{&F10::fillModeNonSolid, &OptionalFeatures::fill_mode_non_solid},
    OptionalFeature<F10>{&F10::depthClamp, &OptionalFeatures::depth_clamp},
    OptionalFeature<F10>{&F10::depthBiasClamp, &OptionalFeatures::depth_bias_clamp},
    OptionalFeature<F10>{&F10::imageCubeArray, &OptionalFeatures::cube_arrays},
    OptionalFeature<F10>{&F10::drawIndirectFirstInstance, &OptionalFeatures::draw_indirect_first_instance},
    OptionalFeature<F10>{&F10::multiDrawIndirect, &OptionalFeatures::multi_draw_indirect},
    OptionalFeature<F10>{&F10::samplerAnisotropy, &OptionalFeatures::sampler_anisotropy},
    OptionalFeature<F10>{&F10::shaderImageGatherExtended, &OptionalFeatures::image_gather_extended},
    OptionalFeature<F10>{&F10::shaderUniformBufferArrayDynamicIndexing,
                         &OptionalFeatures::uniform_array_indexing},
    OptionalFeature<F10>{&F10::shaderSampledImageArrayDynamicIndexing,
                         &OptionalFeatures::sampled_array_indexing},
    OptionalFeature<F10>{&F10::shaderStorageImageReadWithoutFormat,
                         &OptionalFeatures::storage_read_without_format},
};
constexpr std::array kOptional11{
    OptionalFeature<F11>{&F11::multiview, &OptionalFeatures::multiview},
};
constexpr std::array kOptional12{
    OptionalFeature<F12>{&F12::drawIndirectCount, &OptionalFeatures::draw_indirect_count},
    OptionalFeature<F12>{&F12::samplerFilterMinmax, &OptionalFeatures::sampler_min_max},
    OptionalFeature<F12>{&F12::runtimeDescriptorArray, &OptionalFeatures::runtime_arrays},
    OptionalFeature<F12>{&F12::shaderSampledImageArrayNonUniformIndexing,
                         &OptionalFeatures::nonuniform_sampled_array_indexing},
    OptionalFeature<F12>{&F12::shaderOutputLayer, &OptionalFeatures::output_layer},
};

// robustBufferAccess keeps out-of-range accesses to storage and uniform buffers inside the memory of the
// buffer. Weft enables the feature where the device has it, but nothing depends on it.
constexpr VkBool32 F10::*kRobustBuffers = &F10::robustBufferAccess;

template <class Table, class Struct>
void enable(const Table& table, Struct& features) {
    for (const auto& feature : table) features.*feature.member = VK_TRUE;
}

template <class Table, class Struct>
void enable_present(const Table& table, const Struct& supported, Struct& enabled, OptionalFeatures& flags) {
    for (const auto& feature : table) {
        if (supported.*feature.member != VK_TRUE) continue;
        enabled.*feature.member = VK_TRUE;
        flags.*feature.flag = true;
    }
}

template <class Table, class Struct>
void list_missing(const Table& table, const Struct& supported, std::vector<std::string>& missing) {
    for (const auto& feature : table) {
        if (supported.*feature.member != VK_TRUE) missing.emplace_back(feature.name);
    }
}

}  // namespace

FeatureChain::FeatureChain() {
    core_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    v11_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES;
    v12_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    v13_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    core_.pNext = &v11_;
    v11_.pNext = &v12_;
    v12_.pNext = &v13_;
}

void required_features(FeatureChain& chain) {
    enable(kRequired10, chain.v10());
    enable(kRequired12, chain.v12());
    enable(kRequired13, chain.v13());
}

OptionalFeatures enable_optional_features(const FeatureChain& supported, FeatureChain& chain) {
    OptionalFeatures flags;
    enable_present(kOptional10, supported.v10(), chain.v10(), flags);
    enable_present(kOptional11, supported.v11(), chain.v11(), flags);
    enable_present(kOptional12, supported.v12(), chain.v12(), flags);
    if (supported.v10().*kRobustBuffers == VK_TRUE) chain.v10().*kRobustBuffers = VK_TRUE;
    return flags;
}

void enable_features(const FeatureChain& supported, FeatureChain& chain) {
    required_features(chain);
    enable_optional_features(supported, chain);
}

std::vector<std::string> missing_features(const FeatureChain& supported) {
    std::vector<std::string> missing;
    list_missing(kRequired10, supported.v10(), missing);
    list_missing(kRequired12, supported.v12(), missing);
    list_missing(kRequired13, supported.v13(), missing);
    return missing;
}

}  // namespace weft::vk
