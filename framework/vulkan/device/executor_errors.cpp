#include "vulkan/device/executor_errors.h"

#include "vulkan/device/vk_result.h"

namespace weft::vk {

Diagnostic failed_call(const char* code, const std::string& what, VkResult result) {
    Diagnostic diagnostic = vk_error(result, what);
    if (diagnostic.code == "V409") diagnostic.code = code;
    return diagnostic;
}

Diagnostic pass_error(const FramePlan& plan, const PassDecl& pass, const char* code,
                      const std::string& what) {
    return plan.graph.sources.error(pass.loc, code, "pass \"" + pass.name + "\": " + what);
}

Diagnostic failed_pass_call(const FramePlan& plan, const PassDecl& pass, const char* code,
                            const std::string& what, VkResult result) {
    const Diagnostic call = failed_call(code, what, result);
    Diagnostic diagnostic = pass_error(plan, pass, call.code.c_str(), call.message);
    diagnostic.help = call.help;
    return diagnostic;
}

void append(Diagnostics& all, const Diagnostics& more) {
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace weft::vk
