// Purpose: host memory for readback passes: one host-visible copy per frame slot, which the program gets when
// that slot's frame has finished. Errors: V410, V411.
#pragma once

#include <array>
#include <vector>

#include "vulkan/memory/image_regions.h"
#include "vulkan/memory/resource_table.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

class ReadbackMemory {
 public:
    [[nodiscard]] static Result<ReadbackMemory> create(Device& device, const FramePlan& plan);

    // Records the copy of the readback pass at schedule position `position`.
    void record(const Device& device, VkCommandBuffer commands, uint32_t position, uint32_t slot,
                const FramePlan& plan, const FrameResources& resources) const;
    // Makes the copies of a batch visible to the host; must be recorded last in a batch.
    void record_visibility(const Device& device, VkCommandBuffer commands, uint32_t slot,
                           const Batch& batch) const;
    // One entry per readback pass, in schedule order. Call it after the slot's fence is signalled.
    void deliver(const FramePlan& plan, uint32_t slot, uint64_t frame_index,
                 std::vector<ReadbackData>& out) const;

 private:
    struct Place {
        uint32_t position = 0;
        uint64_t offset_bytes = 0;
        uint64_t buffer_bytes = 0;  // for a pass that reads a buffer
        ImageRegions regions;       // for a pass that reads an image
    };
    std::vector<Place> places_;
    std::array<Buffer, kFramesInFlight> memory_;
};

// Copies an image in the transfer_src layout to the host and waits for the copy. Errors: V407, V408, V410,
// V419.
[[nodiscard]] Result<ReadbackData> read_image_now(Device& device, const Image& image);

}  // namespace weft::vk
