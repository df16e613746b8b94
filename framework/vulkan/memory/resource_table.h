// Purpose: every resource of a plan as a Vulkan object: its own from the heaps, imports from the
// program. Errors: V414 when an import is missing or of another shape than the graph was resolved with.
#pragma once

#include <vector>

#include "vulkan/memory/rings.h"
#include "vulkan/memory/transient_heap.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

struct ResourceTable {
    std::vector<VkImage> images;    // by the ResourceId that is placed there; null for buffers, unused ones
    std::vector<VkBuffer> buffers;  // the same
    Rings rings;
};

// The table in one frame, in which every role of a ring is one certain copy.
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
