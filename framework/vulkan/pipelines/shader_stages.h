// Purpose: the pipeline stages of a program, with the specialisation constants of a pass and, for draws, of a
// variant. Shader modules live only while pipelines are being created. Errors: V412.
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
    // `variant` may be null. A constant of the variant is used if the shader declares a constant of that
    // name.
    [[nodiscard]] static Result<ShaderStages> create(Device& device, const FramePlan& plan,
                                                     const PassDecl& pass, const ShaderProgram& program,
                                                     const DrawVariant* variant);

    [[nodiscard]] const std::vector<VkPipelineShaderStageCreateInfo>& infos() const { return infos_; }

 private:
    // Allocated on the heap, because the stages point to it.
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
