// Purpose: maps every resource of a plan to a Vulkan object: transient and persistent ones from the heaps,
// imports from the program. Errors: V414 when an import is missing or has another shape than in the resolved
// graph.
#pragma once

#include <vector>

#include "vulkan/memory/rings.h"
#include "vulkan/memory/transient_heap.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

struct ResourceTable {
    std::vector<VkImage> images;    // indexed by the ResourceId placed there; null for buffers and unused
                                    // resources
    std::vector<VkBuffer> buffers;  // the same for buffers
    Rings rings;
};

// The table for one frame, in which each resource of a ring refers to one particular copy.
class FrameResources {
 public:
    FrameResources(const ResourceTable& table, uint64_t frame) : table_(&table), frame_(frame) {}

    [[nodiscard]] VkImage image(ResourceId id) const {
        return table_->images[table_->rings.copy(id, frame_)];
    }
    [[nodiscard]] VkBuffer buffer(ResourceId id) const {
        return table_->buffers[table_->rings.copy(id, frame_)];
    }
    [[nodiscard]] const Rings& rings() const { return table_->rings; }
    [[nodiscard]] uint64_t frame() const { return frame_; }

 private:
    const ResourceTable* table_;
    uint64_t frame_;
};

[[nodiscard]] Result<ResourceTable> bind_resources(const FramePlan& plan, const TransientHeap& heap,
                                                   const ImportBindings& bindings);

}  // namespace weft::vk
