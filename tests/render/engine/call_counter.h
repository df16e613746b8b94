// Purpose: counts calls of functions in a device's table that a frame must not make. Only calls on the thread
// that created the counter count. The counting functions are plain functions, so only one CallCounter may
// exist at a time.
#pragma once

#include <cstdint>

#include "vulkan/device/functions.h"
#include "weft/vulkan/device.h"

namespace weft::test {

struct CallCounts {
    int64_t allocations = 0;  // vkAllocateMemory
    int64_t idle_waits = 0;   // vkQueueWaitIdle, vkDeviceWaitIdle
    int64_t pipelines = 0;    // vkCreateGraphicsPipelines, vkCreateComputePipelines
    int64_t submissions = 0;  // vkQueueSubmit, vkQueueSubmit2
    // vkCreateCommandPool. Each session creates pools of its own, so 0 also means that no session was
    // created.
    int64_t command_pools = 0;
    bool operator==(const CallCounts&) const = default;
};

class CallCounter {
 public:
    explicit CallCounter(vk::Device& device);
    ~CallCounter();
    CallCounter(const CallCounter&) = delete;
    CallCounter& operator=(const CallCounter&) = delete;

    [[nodiscard]] CallCounts counts() const;

 private:
    vk::Device& device_;
    vk::DeviceFunctions functions_;  // The original functions, which the destructor puts back.
};

}  // namespace weft::test
