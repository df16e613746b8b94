// Purpose: counts the Vulkan objects of a device that were created and not destroyed yet. It replaces the
// functions in the device's table that create and destroy objects. The replacements are plain
// functions without access to the counter. So the number of live objects is a global variable, and only one
// ObjectCounter may exist at a time.
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

    // Returns the number of live objects. Only objects made since the counter was created count.
    [[nodiscard]] int64_t live() const;
    // Returns the size of the device memory that was allocated since the counter was made and is not freed
    // yet.
    [[nodiscard]] uint64_t live_bytes() const;
    // Returns the largest value of live_bytes() since the last call.
    uint64_t take_most_bytes();

 private:
    vk::Device& device_;
    // The device's original functions, which the destructor puts back.
    vk::DeviceFunctions functions_;
};

// Returns the memory that this process uses, in bytes, after the allocator has returned unused memory to the
// system.
[[nodiscard]] uint64_t resident_bytes();

// Number of live Vulkan objects and bytes of memory at one moment. A test compares two moments with many
// edits or resizes between them.
struct Leftovers {
    int64_t objects = 0;
    uint64_t bytes = 0;
};

}  // namespace weft::test
