// Purpose: makes the pipeline layout of a pass: set 1 from the shader's ports, sets 0 (frame), 2 (material)
// and 3 (draw) from the draw source if the shader uses them, and the range of push constants. Errors: V413 (a
// layout could not be created), V415 (the draw source does not have a set that the shader uses).
#pragma once

#include <array>

#include "vulkan/device/handle.h"
#include "weft/plan.h"
#include "weft/result.h"
#include "weft/shader_interface.h"
#include "weft/vulkan/draw_source.h"

namespace weft::vk {

inline constexpr uint32_t kFrameSet = 0;
inline constexpr uint32_t kViewBinding = 1;  // Binding of the constants of the view in kFrameSet.
inline constexpr uint32_t kMaterialSet = 2;
inline constexpr uint32_t kInstanceSet = 3;
inline constexpr uint32_t kSetCount = 4;

// True if the shader's Params block is a uniform buffer in set kPortSet instead of push constants.
[[nodiscard]] inline bool params_in_buffer(const ShaderInterface& interface) {
    return interface.has_params && !interface.params.push_constants;
}

// Returns the number of descriptors of a port's binding. The table of textures that the pass binds gives the
// size of an array without a size.
[[nodiscard]] uint32_t descriptor_count(const ResolvedGraph& graph, const PassDecl& pass,
                                        const ShaderBinding& binding);

struct PassLayout {
    SetLayoutHandle ports;
    // A layout without bindings, for unused sets below the highest set in use.
    SetLayoutHandle empty;
    PipelineLayoutHandle pipeline;
    // For each set number, true if the shader uses the set.
    std::array<bool, kSetCount> declares{};
    // The stages that read Params as push constants; 0 if Params are not push constants.
    VkShaderStageFlags push_stages = 0;
    // On llvmpipe, the stages that read the push constant that is always 0 (see opaque_uniforms.h); 0 on
    // other drivers.
    VkShaderStageFlags index_stages = 0;

    [[nodiscard]] bool has_ports() const { return declares[kPortSet]; }
};

// `draws` may be null if the shader uses none of the sets 0, 2 and 3, which a draw source provides.
[[nodiscard]] Result<PassLayout> make_pass_layout(Device& device, const FramePlan& plan, const PassDecl& pass,
                                                  const ShaderInterface& interface, const DrawSource* draws);

}  // namespace weft::vk
