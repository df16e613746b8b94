// Purpose: the Vulkan features that Weft uses, in one table: required features, without which a device is
// rejected, and optional ones, which are enabled if supported and checked by name before use. An embedder
// creates its device with the features set by enable_features(), and passes both to Device::adopt().
#pragma once

#include <vulkan/vulkan_core.h>

#include <string>
#include <vector>

namespace weft::vk {

// Features that may be missing. A graph that needs one of them gets an error naming it.
struct OptionalFeatures {
    bool fill_mode_non_solid = false;
    bool depth_clamp = false;
    bool depth_bias_clamp = false;
    bool cube_arrays = false;
    bool image_gather_extended = false;  // textureGather with several offsets, or with a variable one
    bool storage_read_without_format = false;
    bool draw_indirect_first_instance = false;
    bool uniform_array_indexing = false;  // required on llvmpipe: see opaque_uniforms.h
};

// The feature structs of Vulkan 1.0 to 1.3, linked to each other. Not copyable, because the links are
// addresses.
class FeatureChain {
 public:
    FeatureChain();
    FeatureChain(const FeatureChain&) = delete;
    FeatureChain& operator=(const FeatureChain&) = delete;

    [[nodiscard]] VkPhysicalDeviceFeatures2& head() { return core_; }
    [[nodiscard]] const VkPhysicalDeviceFeatures2& head() const {
        return core_;
    }  // for VkDeviceCreateInfo::pNext

    [[nodiscard]] VkPhysicalDeviceFeatures& v10() { return core_.features; }
    [[nodiscard]] const VkPhysicalDeviceFeatures& v10() const { return core_.features; }
    [[nodiscard]] VkPhysicalDeviceVulkan11Features& v11() { return v11_; }
    [[nodiscard]] const VkPhysicalDeviceVulkan11Features& v11() const { return v11_; }
    [[nodiscard]] VkPhysicalDeviceVulkan12Features& v12() { return v12_; }
    [[nodiscard]] const VkPhysicalDeviceVulkan12Features& v12() const { return v12_; }
    [[nodiscard]] VkPhysicalDeviceVulkan13Features& v13() { return v13_; }
    [[nodiscard]] const VkPhysicalDeviceVulkan13Features& v13() const { return v13_; }

 private:
    VkPhysicalDeviceFeatures2 core_{};
    VkPhysicalDeviceVulkan11Features v11_{};
    VkPhysicalDeviceVulkan12Features v12_{};
    VkPhysicalDeviceVulkan13Features v13_{};
};

// Enables in `chain` all features that Weft requires, and the optional ones that `supported` has. Other
// features do not change, so an embedder can add its own.
void enable_features(const FeatureChain& supported, FeatureChain& chain);
// A part of enable_features(): the features that every device must have.
void required_features(FeatureChain& chain);
// Enables in `chain` every optional feature that `supported` has, and returns them.
OptionalFeatures enable_optional_features(const FeatureChain& supported, FeatureChain& chain);
// Names of required features that `supported` lacks: "dynamicRendering".
[[nodiscard]] std::vector<std::string> missing_features(const FeatureChain& supported);

}  // namespace weft::vk
