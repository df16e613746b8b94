// Purpose: the Vulkan features that Weft uses; the tables are in device_features.cpp. A device that lacks a
// required feature is rejected. Optional features are enabled if the device has them; a graph that needs a
// missing feature gets an error with the name of the feature. An embedder calls enable_features() before it
// creates its device, and passes the device and the features to Device::adopt().
#pragma once

#include <vulkan/vulkan_core.h>

#include <string>
#include <vector>

namespace weft::vk {

// Features that a device may lack. A graph that needs a missing feature gets an error with the name of the
// feature.
struct OptionalFeatures {
    bool fill_mode_non_solid = false;
    bool depth_clamp = false;
    bool depth_bias_clamp = false;
    bool cube_arrays = false;
    // textureGather() with four offsets, or with an offset that is not constant.
    bool image_gather_extended = false;
    bool storage_read_without_format = false;
    bool draw_indirect_first_instance = false;
    bool draw_indirect_count = false;
    bool multi_draw_indirect = false;
    bool sampler_anisotropy = false;
    // Samplers that return the least or the greatest texel of a lookup.
    bool sampler_min_max = false;
    // Dynamic indices into arrays of uniform buffers. On llvmpipe, rewritten shaders use them; see
    // opaque_uniforms.h.
    bool uniform_array_indexing = false;
    // One draw for several views. Every device of Vulkan 1.1 has it, but an embedder must enable it.
    bool multiview = false;
    // Vertex shaders may write gl_Layer, the layer to which a triangle is drawn (SPIR-V capability
    // ShaderLayer).
    bool output_layer = false;
    // The three features that tables of textures need; see texture_tables().
    bool runtime_arrays = false;
    bool sampled_array_indexing = false;
    bool nonuniform_sampled_array_indexing = false;

    // True: shaders can index tables of textures, with numbers that differ between invocations.
    [[nodiscard]] bool texture_tables() const {
        return runtime_arrays && sampled_array_indexing && nonuniform_sampled_array_indexing;
    }
};

// The feature structs of Vulkan 1.0 to 1.3, linked through pNext. The class is not copyable, because the
// links are addresses of its members.
class FeatureChain {
 public:
    FeatureChain();
    FeatureChain(const FeatureChain&) = delete;
    FeatureChain& operator=(const FeatureChain&) = delete;

    [[nodiscard]] VkPhysicalDeviceFeatures2& head() { return core_; }
    // Pass this pointer as VkDeviceCreateInfo::pNext.
    [[nodiscard]] const VkPhysicalDeviceFeatures2& head() const { return core_; }

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

// Enables in `chain` all features that Weft requires. Also enables the optional features and
// robustBufferAccess, as far as they are enabled in `supported`. Other features in `chain` do not change, so
// that an embedder can add its own.
void enable_features(const FeatureChain& supported, FeatureChain& chain);
// Enables in `chain` the features that every device must have. enable_features() calls this function.
void required_features(FeatureChain& chain);
// Enables in `chain` every optional feature that `supported` has, and returns them.
OptionalFeatures enable_optional_features(const FeatureChain& supported, FeatureChain& chain);
// Returns the names of required features that `supported` lacks, such as "dynamicRendering".
[[nodiscard]] std::vector<std::string> missing_features(const FeatureChain& supported);

}  // namespace weft::vk
