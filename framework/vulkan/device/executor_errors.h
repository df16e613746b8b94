// Purpose: the executor's errors as diagnostics. Each names the pass or resource concerned. Codes: V411
// transient memory, image or view, V412 pipeline, V413 descriptors, V414 import that is missing or has the
// wrong shape, V415 draw source, V416 vertex format, V417 a plan that this executor cannot replay, V418 frame
// slots, V419 reading an image. Time-outs, lost devices and exhausted memory have the codes of vk_result.h.
#pragma once

#include <string>

#include "vulkan/device/functions.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft::vk {

// The operation `what` failed with `result`.
[[nodiscard]] Diagnostic failed_call(const char* code, const std::string& what, VkResult result);
// A fault of `pass`, located at its declaration in the graph.
[[nodiscard]] Diagnostic pass_error(const FramePlan& plan, const PassDecl& pass, const char* code,
                                    const std::string& what);
// A failed Vulkan call that was made for `pass`.
[[nodiscard]] Diagnostic failed_pass_call(const FramePlan& plan, const PassDecl& pass, const char* code,
                                          const std::string& what, VkResult result);

void append(Diagnostics& all, const Diagnostics& more);

}  // namespace weft::vk
