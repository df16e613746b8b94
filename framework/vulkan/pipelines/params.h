// Purpose: writes the `Params` blocks of all passes for one frame: literals come from the plan, per-frame
// values such as the time from the caller. Push constants are written while commands are recorded. Other
// blocks are in uniform memory with one copy per frame slot, so that they can be written while the previous
// frame is still running. Errors: V410 (out of memory), V409 (any other failure).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "graph/rest/unit_validity.h"
#include "vulkan/memory/frame_areas.h"
#include "vulkan/memory/resource_table.h"
#include "vulkan/memory/slot_buffers.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

// The values of a frame that Params can contain.
struct FrameValues {
    const FrameInput& frame;
    FrameResources resources;
    const FrameAreas& areas;
    // Null: the values Builtin::unit_valid and Builtin::unit_bits become 0.
    const UnitValidity* validity = nullptr;
    Combination switches = kAllSwitchesOn;  // The switches that are on in the frame.
};

// Writes the parameter values of a pass to `bytes`, which has PassDecl::params_bytes bytes. Bytes that belong
// to no parameter become zero.
void write_params(const ResolvedGraph& graph, PassId pass, const FrameValues& values,
                  std::span<std::byte> bytes);

class ParamsMemory {
 public:
    [[nodiscard]] static Result<ParamsMemory> create(Device& device, const FramePlan& plan);
    // Returns the size of the buffer that each frame slot gets; 0: none.
    [[nodiscard]] static uint64_t slot_bytes(const Device& device, const FramePlan& plan);

    // Returns the memory of the Params block of the pass at index `position` of the execution order. Call it
    // only for passes whose Params are in a buffer.
    [[nodiscard]] VkDescriptorBufferInfo descriptor(Position position, uint32_t slot) const;
    // Writes the Params blocks of all passes to the memory of frame slot `slot`. Call it before the frame is
    // submitted.
    void write(const FramePlan& plan, const FrameValues& values, uint32_t slot);

 private:
    struct Block {
        uint64_t offset_bytes = 0;
        // Size of the Params block in bytes; 0 if the pass has no block in uniform memory.
        uint64_t size_bytes = 0;
    };
    // Fills `blocks_`, and returns the bytes of all blocks.
    [[nodiscard]] uint64_t lay_out(const Device& device, const FramePlan& plan);

    // One block for each pass, in execution order.
    std::vector<Block> blocks_;
    SlotBuffers memory_;
};

}  // namespace weft::vk
