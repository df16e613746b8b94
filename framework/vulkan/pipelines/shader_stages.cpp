#include "vulkan/pipelines/shader_stages.h"

#include <cstring>
#include <map>

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"

namespace weft::vk {
namespace {

uint32_t constant_bits(ScalarType type, double value) {
    if (type == ScalarType::boolean) return value != 0 ? VK_TRUE : VK_FALSE;
    if (type != ScalarType::f32) return static_cast<uint32_t>(static_cast<int64_t>(value));
    const float narrowed = static_cast<float>(value);
    uint32_t bits = 0;
    std::memcpy(&bits, &narrowed, sizeof bits);
    return bits;
}

}  // namespace

std::unique_ptr<ShaderStages::Constants> ShaderStages::make_constants(const PassDecl& pass,
                                                                      const ShaderInterface& interface,
                                                                      const DrawVariant* variant) {
    // The value of each specialisation constant as 32 bits, by its constant id.
    std::map<uint32_t, uint32_t> bits;
    for (const SpecValue& value : pass.spec_values) bits[value.id] = value.bits;
    if (variant != nullptr)
        for (const NamedValue& value : variant->spec_constants)
            for (const SpecConstant& constant : interface.spec_constants)
                if (constant.name == value.name)
                    bits[constant.id] = constant_bits(constant.type, value.value);
    auto constants = std::make_unique<Constants>();
    for (const auto& [id, word] : bits) {
        const auto offset = static_cast<uint32_t>(constants->words.size() * sizeof(uint32_t));
        constants->entries.push_back({id, offset, sizeof(uint32_t)});
        constants->words.push_back(word);
    }
    constants->info.mapEntryCount = static_cast<uint32_t>(constants->entries.size());
    constants->info.pMapEntries = constants->entries.data();
    constants->info.dataSize = constants->words.size() * sizeof(uint32_t);
    constants->info.pData = constants->words.data();
    return constants;
}

Result<ShaderStages> ShaderStages::create(Device& device, const FramePlan& plan, const PassDecl& pass,
                                          const ShaderProgram& program, const DrawVariant* variant) {
    ShaderStages stages;
    stages.constants_ = make_constants(pass, program.interface, variant);
    for (const ShaderModule& module : program.modules) {
        VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
        info.codeSize = module.spirv.size() * sizeof(uint32_t);
        info.pCode = module.spirv.data();
        VkShaderModule object = VK_NULL_HANDLE;
        const VkResult result = device.fn().vkCreateShaderModule(device.handle(), &info, nullptr, &object);
        if (result != VK_SUCCESS)
            return failed_pass_call(plan, pass, "V412",
                                    "creating the shader module of \"" + pass.shader + "\"", result);
        stages.modules_.emplace_back(device, object);
        VkPipelineShaderStageCreateInfo stage{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
        stage.stage = to_vk(module.stage);
        stage.module = object;
        stage.pName = "main";
        stage.pSpecializationInfo = &stages.constants_->info;
        stages.infos_.push_back(stage);
    }
    return stages;
}

}  // namespace weft::vk
