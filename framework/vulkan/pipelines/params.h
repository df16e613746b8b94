// Purpose: the `Params` block of every pass for one frame: literals from the plan, per-frame values from the
// caller. Push constants are written while recording; the others have a place in uniform memory, one copy a
// frame slot, so that a frame may be written while the one before is still running. Errors: V410, V411.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "vulkan/memory/resource_table.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

// Unnamed bytes are zero. `bytes` holds PassDecl::params_bytes.
void write_params(const PassDecl& pass, const FrameInput& frame, const FrameResources& resources,
                  std::span<std::byte> bytes);

class ParamsMemory {
 public:
    [[nodiscard]] static Result<ParamsMemory> create(Device& device, const FramePlan& plan);

    // By schedule position; only for passes whose Params the device reads from a buffer.
    [[nodiscard]] VkDescriptorBufferInfo descriptor(uint32_t position, uint32_t slot) const;
    // Writes the blocks of all passes into this slot's memory, before the frame is submitted.
    void write(const FramePlan& plan, const FrameInput& frame, const FrameResources& resources,
               uint32_t slot);

 private:
    struct Block {
        uint64_t offset_bytes = 0;
        uint64_t size_bytes = 0;  // 0: no uniform block
    };
    std::vector<Block> blocks_;  // by position
    std::array<Buffer, kFramesInFlight> memory_;
};

}  // namespace weft::vk
