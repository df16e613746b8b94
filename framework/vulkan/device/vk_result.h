// Purpose: converts an unsuccessful VkResult to a Diagnostic. The codes: V407 (time-out), V408 (device lost),
// V410 (out of memory), V409 (every other result).
#pragma once

#include <string>
#include <string_view>

#include "vulkan/device/functions.h"
#include "weft/result.h"

namespace weft::vk {

// Returns the name of the enumerator, such as "VK_ERROR_DEVICE_LOST".
[[nodiscard]] std::string result_name(VkResult result);
// `what` names the failed operation as a noun, such as "allocating 64 bytes for \"lights\"". The message is
// "<what> failed: <name of the result>".
[[nodiscard]] Diagnostic vk_error(VkResult result, std::string_view what);

}  // namespace weft::vk
