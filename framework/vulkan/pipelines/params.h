// Purpose: the `Params` blocks of all passes in one frame: literals from the plan, per-frame values from the
// caller. Push constants are written during recording. Other blocks lie in uniform memory with one copy per
// frame slot, so that they can be written while the previous frame is still running. Errors: V410, V411.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "vulkan/memory/resource_table.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

// Bytes that belong to no parameter are zero. The size of `bytes` is PassDecl::params_bytes.
void write_params(const PassDecl& pass, const FrameInput& frame, const FrameResources& resources,
                  std::span<std::byte> bytes);

class ParamsMemory {
 public:
    [[nodiscard]] static Result<ParamsMemory> create(Device& device, const FramePlan& plan);

    // `position` is a schedule position; only for passes whose Params are in a buffer.
    [[nodiscard]] VkDescriptorBufferInfo descriptor(uint32_t position, uint32_t slot) const;
    // Writes the blocks of all passes to this slot's memory; call it before the frame is submitted.
    void write(const FramePlan& plan, const FrameInput& frame, const FrameResources& resources,
               uint32_t slot);

 private:
    struct Block {
        uint64_t offset_bytes = 0;
        uint64_t size_bytes = 0;  // 0: no uniform block
    };
    std::vector<Block> blocks_;  // index: schedule position
    std::array<Buffer, kFramesInFlight> memory_;
};

}  // namespace weft::vk
