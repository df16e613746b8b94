// Purpose: turns errors of the executor into diagnostics, which name the pass or resource concerned. Codes:
// V411 memory, image or view, V412 pipeline, V413 descriptors, V414 an import that the program did not give,
// or an image of the wrong shape (format, size, mips, layers or samples), V415 a DrawSource that is missing
// or lacks a descriptor set, V416 vertex format, V417 a plan that this executor cannot run, V418 recording,
// submitting or reading back. Time-outs, lost devices and exhausted memory have the codes of vk_result.h.
#pragma once

#include <string>

#include "vulkan/device/functions.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft::vk {

// Returns the error for an operation (`what`: "making the descriptor pool") that failed with `result`. The
// error has the code `code`, unless vk_error() has a special code for `result`, such as V408 for a lost
// device.
[[nodiscard]] Diagnostic failed_call(const char* code, const std::string& what, VkResult result);
// Returns an error of a pass, with the place in the graph file where the pass is declared.
[[nodiscard]] Diagnostic pass_error(const FramePlan& plan, const PassDecl& pass, const char* code,
                                    const std::string& what);
// Returns the error for a Vulkan call that failed with `result` while it worked for `pass`.
[[nodiscard]] Diagnostic failed_pass_call(const FramePlan& plan, const PassDecl& pass, const char* code,
                                          const std::string& what, VkResult result);

void append(Diagnostics& all, const Diagnostics& more);

}  // namespace weft::vk
