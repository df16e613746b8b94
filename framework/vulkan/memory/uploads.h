// Purpose: transfers host data of C++ passes to the device: upload memory for every output port that is
// written by copies, one copy per frame slot, and the Uploads and Recorder objects that passes use. Errors:
// V410, V411.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "vulkan/memory/image_regions.h"
#include "vulkan/memory/resource_table.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

// The upload memory of one port.
struct UploadPlace {
    std::string port;
    uint32_t use = kNoId;  // index into PassDecl::uses
    uint64_t offset_bytes = 0;
    uint64_t capacity_bytes = 0;
    ImageRegions regions;  // if the port is an image
};

class UploadMemory {
 public:
    [[nodiscard]] static Result<UploadMemory> create(Device& device, const FramePlan& plan);

    // Calls `prepare` of the pass at schedule position `position`; it fills this slot's memory.
    void prepare(uint32_t position, const PassType& type, const PassDecl& pass, const HostInputs& host,
                 uint32_t slot);
    // Calls `record` of the pass at schedule position `position`.
    void record(const Device& device, VkCommandBuffer commands, uint32_t position, const PassType& type,
                const PassDecl& pass, uint32_t slot, const FrameResources& resources) const;

 private:
    std::vector<std::vector<UploadPlace>> places_;  // index: schedule position
    std::array<std::vector<std::vector<uint64_t>>, kFramesInFlight>
        filled_bytes_;  // indexed by slot, schedule position, place
    std::array<Buffer, kFramesInFlight> memory_;
};

}  // namespace weft::vk
