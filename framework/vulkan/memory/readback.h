// Purpose: host memory for readback passes, which copy a resource to the host. There is one host-visible copy
// per frame slot; the program gets the copy when the slot's frame has finished. Errors: V410 (out of memory),
// V417 (the pass does not read exactly one resource), V409 (any other failure).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "vulkan/memory/frame_areas.h"
#include "vulkan/memory/image_regions.h"
#include "vulkan/memory/resource_table.h"
#include "vulkan/memory/slot_buffers.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

// How a frame differed from other frames of its plan.
struct FrameShape {
    // The areas of the images, by ResourceId; empty if the plan has no live sizes.
    std::span<const Extent3D> areas;
    Combination switches = kAllSwitchesOn;  // The switches that were on.
};

class ReadbackMemory {
 public:
    [[nodiscard]] static Result<ReadbackMemory> create(Device& device, const FramePlan& plan);
    // Returns the size of the buffer that each frame slot gets; 0: none. Error: V417.
    [[nodiscard]] static Result<uint64_t> slot_bytes(const FramePlan& plan) {
        return ReadbackMemory().lay_out(plan);
    }

    // Records the copy commands of the readback pass at index `position` of the execution order.
    void record(const Device& device, VkCommandBuffer commands, Position position, uint32_t slot,
                const FramePlan& plan, const FrameResources& resources, const FrameAreas& areas) const;
    // Records a barrier that makes the readback copies of a batch visible to the host. Call this after all
    // passes of the batch are recorded.
    void record_visibility(const Device& device, VkCommandBuffer commands, uint32_t slot,
                           const Batch& batch) const;
    // Appends the data of each readback pass to `out`, in schedule order. Call this after the frame in `slot`
    // has finished. A pass that was switched off delivers nothing.
    void deliver(const FramePlan& plan, uint32_t slot, uint64_t frame_index, const FrameShape& frame,
                 std::vector<ReadbackData>& out) const;

 private:
    struct Place {
        Position position = 0;
        uint64_t offset_bytes = 0;
        // The part of the buffer that the pass reads; its size is 0 if the pass reads an image.
        ByteRange buffer;
        // Copy regions of the image that the pass reads; empty if the pass reads a buffer. For an image with
        // a live size, the regions are those of the whole image.
        ImageRegions regions;
    };
    // Returns the copy regions for a frame in which the image has this area.
    [[nodiscard]] static ImageRegions regions_of(const Place& place, const ResourceDecl& decl,
                                                 const UseDecl& use, const Extent3D& area);
    // Fills `places_`, and returns the bytes of all places.
    [[nodiscard]] Result<uint64_t> lay_out(const FramePlan& plan);

    std::vector<Place> places_;
    SlotBuffers memory_;
};

// Copies an image to the host and waits for the copy. The image must be in the transfer_src layout. Errors:
// V407 (time-out), V408 (device lost), V410 (out of memory), V409 (any other failure to create the buffer),
// V418 (any other failure of the submission).
[[nodiscard]] Result<ReadbackData> read_image_now(Device& device, const Image& image);

}  // namespace weft::vk
