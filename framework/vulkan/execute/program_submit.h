// Purpose: checks FrameSubmit, in which the program chooses how a frame is submitted, and finds the batches
// that wait for the semaphores in it. Errors: V422 the plan has several batches, V423 contradictory values.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"
#include "weft/result.h"
#include "weft/vulkan/frame_submit.h"

namespace weft::vk {

[[nodiscard]] Status check_submit(const FramePlan& plan, const FrameSubmit& submit);

// Returns, for each wait, the batch that waits for the semaphore; kNoId: all batches of the frame. `empty`
// tells which batches are not submitted (index: batch; 1: not submitted); an empty list means that all
// batches are submitted.
[[nodiscard]] std::vector<uint32_t> waiting_batches(const FramePlan& plan,
                                                    const std::vector<SemaphoreWait>& waits,
                                                    const std::vector<uint8_t>& empty);

}  // namespace weft::vk
