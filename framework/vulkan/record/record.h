// Purpose: records the commands of one pass in a frame.
#pragma once

#include "vulkan/record/plan_objects.h"

namespace weft::vk {

struct RecordContext {
    Device& device;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    // True if the queue supports debug labels.
    bool labels = false;
    uint32_t family = 0;  // The queue family of the command buffer.
    uint32_t slot = 0;
    const FrameInput& frame;
    const PlanObjects& objects;
    FrameResources resources;
    // For each view that a pass records: the number of draws that were left out because they are outside of
    // the frustum of the view. The views of all passes are in one list. `first_view` contains, for each
    // position in the execution order, the index of the first view of the pass; see count_recorded_views().
    std::vector<uint32_t>& draws_left_out;
    std::span<const uint32_t> first_view;
    Combination switches = kAllSwitchesOn;  // The switches that are on in the frame.
};

// Counts the views for which each pass records its draws. Element i of the result is the sum of these numbers
// for all passes before position i of the execution order. The last element is the sum for all passes.
[[nodiscard]] std::vector<uint32_t> count_recorded_views(const FramePlan& plan);

// Records the pass at index `position` of the execution order, without its barriers. Calls one of the
// functions below, or for readback and custom passes ReadbackMemory::record() or record_custom().
void record_pass(const RecordContext& context, Position position);

void record_compute(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared);
void record_fullscreen(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared);
void record_raster(const RecordContext& context, Position position, const PassDecl& pass,
                   const PreparedPass& prepared);
void record_clear(const RecordContext& context, const PassDecl& pass);
void record_copy(const RecordContext& context, const PassDecl& pass);

}  // namespace weft::vk
