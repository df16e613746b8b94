// Purpose: converts an unsuccessful VkResult to a Diagnostic with a code. Errors: V407 time-out, V408 device
// lost, V410 out of memory, V409 everything else.
#pragma once

#include <string>
#include <string_view>

#include "vulkan/device/functions.h"
#include "weft/result.h"

namespace weft::vk {

// The name of the enumerator, such as "VK_ERROR_DEVICE_LOST".
[[nodiscard]] std::string result_name(VkResult result);
// `what` names the failed operation as a noun: "allocating 64 bytes for \"lights\"".
[[nodiscard]] Diagnostic vk_error(VkResult result, std::string_view what);

}  // namespace weft::vk
