// Purpose: the shader stages of a pipeline, with the specialisation constants of a pass and, for draws, of a
// variant of the draw list. The shader modules live only while the pipeline is being created. Errors: V412 (a
// module could not be created).
#pragma once

#include <memory>
#include <vector>

#include "vulkan/device/handle.h"
#include "weft/imports.h"
#include "weft/plan.h"
#include "weft/shader_interface.h"

namespace weft::vk {

class ShaderStages {
 public:
    // `variant` may be null. If the shader declares a specialisation constant with the name of one of the
    // variant's constants, the shader's constant gets the variant's value.
    [[nodiscard]] static Result<ShaderStages> create(Device& device, const FramePlan& plan,
                                                     const PassDecl& pass, const ShaderProgram& program,
                                                     const DrawVariant* variant);

    [[nodiscard]] const std::vector<VkPipelineShaderStageCreateInfo>& infos() const { return infos_; }

 private:
    // The constants are allocated on the heap, so that pointers to them stay valid when a ShaderStages object
    // is moved.
    struct Constants {
        std::vector<VkSpecializationMapEntry> entries;
        std::vector<uint32_t> words;
        VkSpecializationInfo info{};
    };
    static std::unique_ptr<Constants> make_constants(const PassDecl& pass, const ShaderInterface& interface,
                                                     const DrawVariant* variant);

    std::unique_ptr<Constants> constants_;
    std::vector<ShaderModuleHandle> modules_;
    std::vector<VkPipelineShaderStageCreateInfo> infos_;
};

}  // namespace weft::vk
