// Purpose: submits a few commands outside any frame and waits for them with a separate fence. Errors: V407
// time-out, V408 device lost, V418.
#pragma once

#include <functional>
#include <string>

#include "weft/result.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

// `what` names the work in messages: "reading image \"output\"".
[[nodiscard]] Status immediate_submit(Device& device, const std::string& what,
                                      const std::function<void(VkCommandBuffer)>& record);

}  // namespace weft::vk
