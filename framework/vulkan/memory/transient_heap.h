// Purpose: the memory of a plan: one allocation per heap, with images and buffers bound at the offsets in the
// plan. Also asks the device for memory requirements; from these, the compiler (alias()) computes the
// offsets. Units: bytes. Errors: V410 (out of memory), V411 (any other failure). Source of the method by
// which resources share memory: Y. O'Donnell, "FrameGraph: Extensible Rendering Architecture in Frostbite",
// GDC 2017.
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

    // Both functions return VK_NULL_HANDLE for resources of the other kind, and for resources that are not in
    // the plan's heaps, such as imports.
    [[nodiscard]] VkImage image(ResourceId resource) const { return images_[resource].get(); }
    [[nodiscard]] VkBuffer buffer(ResourceId resource) const { return buffers_[resource].get(); }
    // Returns the size of the transient heaps in bytes; heaps of persistent resources do not count.
    [[nodiscard]] uint64_t bytes() const { return bytes_; }

 private:
    [[nodiscard]] Status allocate(Device& device, const MemoryPlan& memory);
    [[nodiscard]] Status place_image(Device& device, const ResourceDecl& decl, const Placement& placement,
                                     const Sharing& sharing);
    [[nodiscard]] Status place_buffer(Device& device, const ResourceDecl& decl, const Placement& placement,
                                      const Sharing& sharing);

    // The memory is declared before the images and buffers bound to it. Members are destroyed in reverse
    // order, so the memory is freed last.
    std::vector<MemoryHandle> memory_;
    // One image for each ResourceId; empty for buffers, imports and unused resources.
    std::vector<ImageHandle> images_;
    // One buffer for each ResourceId; empty for images, imports and unused resources.
    std::vector<BufferHandle> buffers_;
    uint64_t bytes_ = 0;
};

}  // namespace weft::vk
