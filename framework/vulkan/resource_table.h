// Purpose: every resource of a plan as a Vulkan object: its own from the transient heap, imports from the
// program. Errors: V414 when an import is missing or of another shape than the graph was resolved with.
#pragma once

#include <vector>

#include "vulkan/executor.h"
#include "vulkan/transient_heap.h"

namespace weft::vk {

struct ResourceTable {
    std::vector<VkImage> images;    // by ResourceId; null for buffers and what is not live
    std::vector<VkBuffer> buffers;  // by ResourceId
};

[[nodiscard]] Result<ResourceTable> bind_resources(const FramePlan& plan, const TransientHeap& heap,
                                                   const ImportBindings& bindings);

}  // namespace weft::vk
