// Purpose: transfers host data of custom passes, which are written in C++, to the device. If a custom pass
// writes an output port by copy commands, the port has upload memory, one block per frame slot. The pass
// fills the block through an Uploads object, and records copies from it through a Recorder object. Errors:
// V410 (out of memory), V409 (any other failure).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "graph/rest/rest_state.h"
#include "vulkan/memory/image_regions.h"
#include "vulkan/memory/raw_recorder.h"
#include "vulkan/memory/resource_table.h"
#include "vulkan/memory/slot_buffers.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

// The part of the upload memory that belongs to one port of a pass.
struct UploadPlace {
    std::string port;
    // Index of the port's use in PassDecl::uses.
    uint32_t use = kNoId;
    uint64_t offset_bytes = 0;
    uint64_t capacity_bytes = 0;
    ByteRange target;  // The part of the buffer that the port writes; not used for an image.
    // Copy regions of the port's image; empty if the port is a buffer.
    ImageRegions regions;
};

class UploadMemory {
 public:
    [[nodiscard]] static Result<UploadMemory> create(Device& device, const FramePlan& plan);
    // Returns the size of the buffer that each frame slot gets; 0: none.
    [[nodiscard]] static uint64_t slot_bytes(const FramePlan& plan) { return UploadMemory().lay_out(plan); }

    // Calls the `prepare` function of the pass at index `position` of the execution order. The `prepare`
    // function fills the upload memory of frame slot `slot`. It may also replace lists in `turns`, which say
    // which rounds of a group of passes run in this frame.
    void prepare(Position position, const PassType& type, const PassDecl& pass, const HostInputs& host,
                 uint32_t slot, TurnLists& turns);
    // A pass that is recorded for a frame slot. `position` is its index in the execution order.
    struct Recorded {
        const Device& device;
        Position position;
        const PassType& type;
        const PassDecl& pass;
        uint32_t slot = 0;
    };
    // Calls the `record` function of a pass. This function records copies from the upload memory of its frame
    // slot, or commands of its own with `raw`.
    void record(const RawCommands& raw, const Recorded& recorded, const FrameResources& resources) const;

 private:
    // Fills `places_`, and returns the bytes of all places.
    [[nodiscard]] uint64_t lay_out(const FramePlan& plan);

    // The upload memory of the n-th port of a pass, counting only ports that have upload memory:
    // places_[position of the pass in the execution order][n].
    std::vector<std::vector<UploadPlace>> places_;
    // Number of bytes that the pass has put into a port's upload memory for the current frame of a slot:
    // filled_bytes_[slot][position of the pass in the execution order][n], with n as in places_.
    std::array<std::vector<std::vector<uint64_t>>, kFramesInFlight> filled_bytes_;
    SlotBuffers memory_;
};

}  // namespace weft::vk
