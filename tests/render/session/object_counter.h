// Purpose: how many objects of a device are alive, by standing in front of the functions that make and
// destroy them. One at a time: the device's table has room for plain functions only.
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

    // Of all that were made since the counter was.
    [[nodiscard]] int64_t live() const;

 private:
    vk::Device& device_;
    vk::DeviceFunctions functions_;  // as they were
};

// Memory of this process that is in use, in bytes, with what the allocator could give back given back.
[[nodiscard]] uint64_t resident_bytes();

}  // namespace weft::test
