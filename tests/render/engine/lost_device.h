// Purpose: simulates the loss of a device. The device itself still works, so its objects can be destroyed
// under validation. The simulation uses global data, so only one lost device may exist at a time.
#pragma once

#include "weft/vulkan/device.h"

namespace weft::test {

// The call that notices the loss.
enum class Loss : uint8_t { none, in_wait, in_submit, in_second_submit };

// From the given call on, all submissions, waits and queries of the device return VK_ERROR_DEVICE_LOST.
void lose_device(vk::Device& device, Loss loss);

}  // namespace weft::test
