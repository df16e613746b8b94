// Purpose: host data of C++ passes on its way to the device: upload memory for every output port that copies
// write, one copy a frame slot, and the Uploads and Recorder that passes see. Errors: V410, V411.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "vulkan/memory/image_regions.h"
#include "vulkan/memory/resource_table.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

// Where one port's bytes wait.
struct UploadPlace {
    std::string port;
    uint32_t use = kNoId;  // index into the pass's uses
    uint64_t offset_bytes = 0;
    uint64_t capacity_bytes = 0;
    ImageRegions regions;  // when the port is an image
};

class UploadMemory {
 public:
    [[nodiscard]] static Result<UploadMemory> create(Device& device, const FramePlan& plan);

    // Runs `prepare` of the pass at `position`, into this slot's memory.
    void prepare(uint32_t position, const PassType& type, const PassDecl& pass, const HostInputs& host,
                 uint32_t slot);
    // Runs `record` of the pass at `position`.
    void record(const Device& device, VkCommandBuffer commands, uint32_t position, const PassType& type,
                const PassDecl& pass, uint32_t slot, const FrameResources& resources) const;

 private:
    std::vector<std::vector<UploadPlace>> places_;  // by position
    std::array<std::vector<std::vector<uint64_t>>, kFramesInFlight>
        filled_bytes_;  // by slot, position, place
    std::array<Buffer, kFramesInFlight> memory_;
};

}  // namespace weft::vk
