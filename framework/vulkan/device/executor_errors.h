// Purpose: turns errors of the executor into diagnostics. Most of them name the pass or resource concerned.
//   V411 memory, an image, a buffer or a view cannot be created
//   V412 a pipeline cannot be created
//   V413 descriptor sets, their layouts or a sampler cannot be created
//   V414 the program did not provide an import, or the image of the import has a wrong format, size or
//        number of mips, layers or samples
//   V415 the DrawSource is missing or lacks a descriptor set
//   V416 a shader reads a vertex input that the draw list does not have
//   V417 this executor cannot run the plan
//   V418 recording, submitting or reading back failed
//   V422, V423 a frame cannot be submitted as the program wishes; see program_submit.h
// Time-outs, lost devices and exhausted memory have the codes of vk_result.h instead.
#pragma once

#include <string>

#include "vulkan/device/functions.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft::vk {

// Returns the error for a failed operation. `what` names the operation, such as "creating the descriptor
// pool"; `result` is the result of its Vulkan call. The error has the code `code`, unless vk_error() has a
// special code for `result`, such as V408 for a lost device.
[[nodiscard]] Diagnostic failed_call(const char* code, const std::string& what, VkResult result);
// Returns an error of a pass, with the place in the graph file where the pass is declared.
[[nodiscard]] Diagnostic pass_error(const FramePlan& plan, const PassDecl& pass, const char* code,
                                    const std::string& what);
// Returns the error for an operation of `pass` that failed. The other arguments are those of failed_call().
[[nodiscard]] Diagnostic failed_pass_call(const FramePlan& plan, const PassDecl& pass, const char* code,
                                          const std::string& what, VkResult result);

void append(Diagnostics& all, const Diagnostics& more);

}  // namespace weft::vk
