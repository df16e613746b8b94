// Purpose: the descriptor sets 0 of those passes whose view (the matrices of a camera) is in a buffer that
// the graph writes. The draw source writes the sets. Errors: V415 (the draw source does not support views in
// buffers), and those of the draw source.
#pragma once

#include <memory>

#include "vulkan/memory/resource_table.h"
#include "weft/vulkan/draw_source.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

class PassViewSets {
 public:
    // Makes the sets for all passes of the plan that read their view from a buffer.
    [[nodiscard]] static Result<PassViewSets> create(const FramePlan& plan, const ResourceTable& resources,
                                                     const DrawSource* draws);
    // Returns the set of the pass at index `position` of the execution order. The pass must read its view
    // from a buffer (PassDecl::view_use).
    [[nodiscard]] VkDescriptorSet set(Position position, uint64_t frame, uint32_t slot) const;

 private:
    // A pass has one set for each frame of its period and each frame slot. The period is the number of frames
    // after which the pass uses the same copies of its resources again; see descriptors.h.
    struct PassSets {
        size_t first = 0;
        uint32_t period = 0;
    };
    std::unique_ptr<ViewSets> sets_;
    // Index: position in the execution order. Empty if no pass reads its view from a buffer.
    std::vector<PassSets> passes_;
};

}  // namespace weft::vk
