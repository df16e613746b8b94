// Purpose: the descriptor sets 0 of passes that read their view from a buffer of the graph. The draw source
// writes the sets. Errors: V415 (the draw source offers no views in buffers), and those of the draw source.
#pragma once

#include <memory>

#include "vulkan/memory/resource_table.h"
#include "weft/vulkan/draw_source.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

class PassViewSets {
 public:
    // Makes the sets for all passes of the plan.
    [[nodiscard]] static Result<PassViewSets> create(const FramePlan& plan, const ResourceTable& resources,
                                                     const DrawSource* draws);
    // Returns the set of the pass at a position, which must have PassDecl::view_use.
    [[nodiscard]] VkDescriptorSet set(Position position, uint64_t frame, uint32_t slot) const;

 private:
    // A pass has one set for each frame of its period and each frame slot; see descriptors.h.
    struct PassSets {
        size_t first = 0;
        uint32_t period = 0;
    };
    std::unique_ptr<ViewSets> sets_;
    std::vector<PassSets> passes_;  // Index: position. Empty if no pass reads a view from a buffer.
};

}  // namespace weft::vk
