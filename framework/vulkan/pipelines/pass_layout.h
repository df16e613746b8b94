// Purpose: the pipeline layout of a pass: set 1 from its shader's ports, sets 0, 2 and 3 from the draw source
// if the shader declares them, and the range of its push constants. Errors: V413, V415.
#pragma once

#include <array>

#include "vulkan/device/handle.h"
#include "weft/plan.h"
#include "weft/result.h"
#include "weft/shader_interface.h"
#include "weft/vulkan/draw_source.h"

namespace weft::vk {

inline constexpr uint32_t kFrameSet = 0;
inline constexpr uint32_t kPortSet = 1;
inline constexpr uint32_t kMaterialSet = 2;
inline constexpr uint32_t kInstanceSet = 3;
inline constexpr uint32_t kSetCount = 4;

// The Params block is a uniform buffer of the port set, not push constants.
[[nodiscard]] inline bool params_in_buffer(const ShaderInterface& interface) {
    return interface.has_params && !interface.params.push_constants;
}

struct PassLayout {
    SetLayoutHandle ports;
    SetLayoutHandle empty;  // used for unused sets below the highest one in use
    PipelineLayoutHandle pipeline;
    std::array<bool, kSetCount> declares{};  // index: set; true if the shader uses it
    VkShaderStageFlags push_stages = 0;      // 0: no push constants
    VkShaderStageFlags index_stages = 0;     // with hidden uniforms: stages of the push constant that is
                                             // always 0, see opaque_uniforms.h

    [[nodiscard]] bool has_ports() const { return declares[kPortSet]; }
};

// `draws` may be null if the shader declares none of the draw source's sets.
[[nodiscard]] Result<PassLayout> make_pass_layout(Device& device, const FramePlan& plan, const PassDecl& pass,
                                                  const ShaderInterface& interface, const DrawSource* draws);

}  // namespace weft::vk
