#include "weft/vulkan/heap_use.h"

#include <map>

#include "vulkan/device/executor_errors.h"
#include "vulkan/memory/buffer_demand.h"
#include "vulkan/memory/readback.h"
#include "vulkan/memory/transient_heap.h"
#include "vulkan/memory/uploads.h"
#include "vulkan/pipelines/params.h"

namespace weft::vk {
namespace {

class HeapCounter {
 public:
    explicit HeapCounter(Device& device) : device_(device) {}

    // Returns false if there is no memory type that fits.
    [[nodiscard]] bool add(uint64_t size_bytes, uint32_t type) {
        if (type == UINT32_MAX) return false;
        const uint32_t heap = device_.memory().memoryTypes[type].heapIndex;
        HeapUse& use = heaps_[heap];
        use.heap = heap;
        use.size_bytes += size_bytes;
        ++use.allocations;
        return true;
    }
    // Adds the buffers of all frame slots.
    [[nodiscard]] bool add_slots(uint64_t size_bytes, VkBufferUsageFlags usage, Buffer::Memory memory) {
        if (size_bytes == 0) return true;
        const BufferDemand demand = buffer_demand(device_, size_bytes, usage, memory);
        bool fits = true;
        for (uint32_t slot = 0; slot < kFramesInFlight; ++slot)
            fits = fits && add(demand.size_bytes, demand.type);
        return fits;
    }
    [[nodiscard]] std::vector<HeapUse> result() const {
        std::vector<HeapUse> uses;
        for (const auto& [heap, use] : heaps_) uses.push_back(use);
        return uses;
    }

 private:
    Device& device_;
    std::map<uint32_t, HeapUse> heaps_;
};

}  // namespace

Result<std::vector<HeapUse>> heap_use(Device& device, const FramePlan& plan) {
    Result<uint64_t> readback_bytes = ReadbackMemory::slot_bytes(plan);
    if (!readback_bytes) return readback_bytes.take_errors();
    HeapCounter counter(device);
    bool fits = true;
    for (const HeapPlan& heap : plan.memory.heaps)
        fits = counter.add(heap.size_bytes, heap_memory_type(device, heap)) && fits;
    fits = counter.add_slots(ParamsMemory::slot_bytes(device, plan), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                             Buffer::Memory::upload) &&
           fits;
    fits = counter.add_slots(UploadMemory::slot_bytes(plan), VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                             Buffer::Memory::upload) &&
           fits;
    fits = counter.add_slots(*readback_bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, Buffer::Memory::readback) &&
           fits;
    if (!fits)
        return failed_call("V411", "finding a memory type for each heap of the plan",
                           VK_ERROR_FEATURE_NOT_PRESENT);
    return counter.result();
}

}  // namespace weft::vk
