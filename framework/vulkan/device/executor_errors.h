// Purpose: the executor's errors as diagnostics. Each names the pass or resource it happened to.
// Codes: V411 transient memory, image or view, V412 pipeline, V413 descriptors, V414 import not offered or of
// another shape, V415 draw source, V416 vertex format, V417 a plan this executor can't replay, V418 frame
// slots, V419 reading an image. Time-outs, lost devices and memory that ran out keep the codes of
// vk_result.h.
#pragma once

#include <string>

#include "weft/plan.h"
#include "weft/result.h"
#include "weft/vulkan/functions.h"

namespace weft::vk {

// `what` was attempted and ended with `result`.
[[nodiscard]] Diagnostic failed_call(const char* code, const std::string& what, VkResult result);
// A fault of `pass`, at the place where the graph declares it.
[[nodiscard]] Diagnostic pass_error(const FramePlan& plan, const PassDecl& pass, const char* code,
                                    const std::string& what);
// A failed call on behalf of `pass`.
[[nodiscard]] Diagnostic failed_pass_call(const FramePlan& plan, const PassDecl& pass, const char* code,
                                          const std::string& what, VkResult result);

void append(Diagnostics& all, const Diagnostics& more);

}  // namespace weft::vk
