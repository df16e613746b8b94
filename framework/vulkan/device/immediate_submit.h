// Purpose: submits a few commands outside any frame and waits for them with a separate fence. Errors: V407
// (time-out), V408 (device lost), V410 (out of memory), V418 (any other failure).
#pragma once

#include <functional>
#include <string>

#include "weft/result.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

// Records commands with `record`, submits them to the main queue, and waits until they have finished. `what`
// names the work in error messages, such as "reading image \"output\"". A time-out abandons the device.
[[nodiscard]] Status immediate_submit(Device& device, const std::string& what,
                                      const std::function<void(VkCommandBuffer)>& record);

}  // namespace weft::vk
