#include "shader/gate/validate_spirv.h"

#include <memory>

#include "spirv-tools/libspirv.h"

namespace weft::shader {

std::optional<std::string> spirv_fault(const std::vector<uint32_t>& spirv) {
    const std::unique_ptr<spv_context_t, decltype(&spvContextDestroy)> context(
        spvContextCreate(SPV_ENV_VULKAN_1_3), &spvContextDestroy);
    const std::unique_ptr<spv_validator_options_t, decltype(&spvValidatorOptionsDestroy)> options(
        spvValidatorOptionsCreate(), &spvValidatorOptionsDestroy);
    if (context == nullptr || options == nullptr) return "spirv-val is out of memory";
    // Allow LocalSizeId, which needs the device feature maintenance4. glslang uses it for SPIR-V 1.6 if
    // specialisation constants set the work group size.
    spvValidatorOptionsSetAllowLocalSizeId(options.get(), true);

    spv_const_binary_t binary{spirv.data(), spirv.size()};
    spv_diagnostic message = nullptr;
    const spv_result_t result = spvValidateWithOptions(context.get(), options.get(), &binary, &message);
    const std::unique_ptr<spv_diagnostic_t, decltype(&spvDiagnosticDestroy)> owner(message,
                                                                                   &spvDiagnosticDestroy);
    if (result == SPV_SUCCESS) return std::nullopt;
    return message != nullptr && message->error != nullptr ? std::string(message->error)
                                                           : "spirv-val gave no reason";
}

}  // namespace weft::shader
