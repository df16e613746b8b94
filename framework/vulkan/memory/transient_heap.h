// Purpose: the memory of a plan: one allocation per heap, with images and buffers bound at the offsets in the
// plan. Also computes the memory requirements that alias() places. Units: bytes. Errors: V411, and V410 when
// memory is exhausted. Aliasing by placement follows Y. O'Donnell, "FrameGraph: Extensible Rendering
// Architecture in Frostbite", GDC 2017.
#pragma once

#include <vector>

#include "vulkan/device/handle.h"
#include "weft/plan.h"
#include "weft/result.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {

class TransientHeap {
 public:
    [[nodiscard]] static Result<TransientHeap> create(Device& device, const FramePlan& plan);

    // VK_NULL_HANDLE for resources that the plan does not place.
    [[nodiscard]] VkImage image(ResourceId resource) const { return images_[resource].get(); }
    [[nodiscard]] VkBuffer buffer(ResourceId resource) const { return buffers_[resource].get(); }
    // Total bytes, without persistent resources.
    [[nodiscard]] uint64_t bytes() const { return bytes_; }

 private:
    [[nodiscard]] Status allocate(Device& device, const MemoryPlan& memory);
    [[nodiscard]] Status place_image(Device& device, const ResourceDecl& decl, const Placement& placement,
                                     const Sharing& sharing);
    [[nodiscard]] Status place_buffer(Device& device, const ResourceDecl& decl, const Placement& placement,
                                      const Sharing& sharing);

    // Declared before the objects bound to it, so that it is freed after them.
    std::vector<MemoryHandle> memory_;
    std::vector<ImageHandle> images_;    // index: ResourceId
    std::vector<BufferHandle> buffers_;  // index: ResourceId
    uint64_t bytes_ = 0;
};

}  // namespace weft::vk
