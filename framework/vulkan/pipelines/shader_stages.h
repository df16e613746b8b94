// Purpose: the stages of a program as pipelines want them, with the specialisation constants of a pass and,
// for draws, of a variant. Modules live only as long as pipelines are being made. Errors: V412.
#pragma once

#include <memory>
#include <vector>

#include "weft/imports.h"
#include "weft/plan.h"
#include "weft/shader_interface.h"
#include "weft/vulkan/handle.h"

namespace weft::vk {

class ShaderStages {
 public:
    // `variant` may be null. A constant of the variant counts where the shader declares one of that name.
    [[nodiscard]] static Result<ShaderStages> create(Device& device, const FramePlan& plan,
                                                     const PassDecl& pass, const ShaderProgram& program,
                                                     const DrawVariant* variant);

    [[nodiscard]] const std::vector<VkPipelineShaderStageCreateInfo>& infos() const { return infos_; }

 private:
    // On the heap: the stages point at it.
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
