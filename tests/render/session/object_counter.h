// Purpose: counts the live objects of a device by replacing the functions that create and destroy them. Only
// one counter at a time, because the device's table holds plain functions.
#pragma once

#include <cstdint>

#include "vulkan/device/functions.h"
#include "weft/vulkan/device.h"

namespace weft::test {

class ObjectCounter {
 public:
    explicit ObjectCounter(vk::Device& device);
    ~ObjectCounter();
    ObjectCounter(const ObjectCounter&) = delete;
    ObjectCounter& operator=(const ObjectCounter&) = delete;

    // Counts only objects made since the counter was created.
    [[nodiscard]] int64_t live() const;

 private:
    vk::Device& device_;
    vk::DeviceFunctions functions_;  // the original functions
};

// Memory of this process that is in use, in bytes, after the allocator returned unused memory to the system.
[[nodiscard]] uint64_t resident_bytes();

}  // namespace weft::test
