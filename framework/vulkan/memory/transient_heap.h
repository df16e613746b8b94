// Purpose: the memory of a plan: one allocation per heap, with images and buffers bound at the offsets in the
// plan. Also asks the device for memory requirements; from these, the compiler (alias()) computes the
// offsets. Units: bytes. Errors: V410 (out of memory), V411 (any other failure). Source of the method by
// which resources share memory: Y. O'Donnell, "FrameGraph: Extensible Rendering Architecture in Frostbite",
// GDC 2017.
#pragma once

#include <vector>

#include "vulkan/device/handle.h"
#include "vulkan/memory/shared_store.h"
#include "weft/plan.h"
#include "weft/result.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {

class TransientHeap {
 public:
    // Resources with `"keep": "shared"` are leased from `shared`, which must outlive the heap.
    [[nodiscard]] static Result<TransientHeap> create(Device& device, const FramePlan& plan,
                                                      SharedStore& shared);

    // Both functions return VK_NULL_HANDLE for resources of the other kind, and for resources that are not in
    // the plan's heaps, such as imports.
    [[nodiscard]] VkImage image(ResourceId resource) const {
        const SharedObject* shared = shared_[resource].get();
        return shared != nullptr ? shared->image.get() : images_[resource].get();
    }
    [[nodiscard]] VkBuffer buffer(ResourceId resource) const {
        const SharedObject* shared = shared_[resource].get();
        return shared != nullptr ? shared->buffer.get() : buffers_[resource].get();
    }
    // Returns the memory of the heap that contains the resource.
    [[nodiscard]] const MemoryBlock& memory(const Placement& placement) const {
        const SharedObject* shared = shared_[placement.resource].get();
        return shared != nullptr ? shared->memory.block() : memory_[placement.heap].block();
    }
    // Returns the size of the transient heaps in bytes; heaps of persistent resources do not count.
    [[nodiscard]] uint64_t bytes() const { return bytes_; }

 private:
    [[nodiscard]] Status allocate(Device& device, const FramePlan& plan);
    [[nodiscard]] Status lease(Device& device, const FramePlan& plan, const Placement& placement,
                               SharedStore& shared);
    [[nodiscard]] Status place(Device& device, const ResourceDecl& decl, const Placement& placement,
                               const Sharing& sharing);

    // One for each heap; empty for the heaps of shared resources. The memory is declared before the images
    // and buffers bound to it. Members are destroyed in reverse order, so the memory is freed last.
    std::vector<DeviceMemory> memory_;
    // One image for each ResourceId; empty for buffers, imports and unused resources.
    std::vector<ImageHandle> images_;
    // One buffer for each ResourceId; empty for images, imports and unused resources.
    std::vector<BufferHandle> buffers_;
    // One lease for each ResourceId; empty for resources that are not shared.
    std::vector<SharedLease> shared_;
    uint64_t bytes_ = 0;
};

// Returns the memory type in which a heap of a plan is allocated; UINT32_MAX if the device has none that
// fits.
[[nodiscard]] uint32_t heap_memory_type(const Device& device, const HeapPlan& heap);

}  // namespace weft::vk
