#include "vulkan/memory/transient_heap.h"

#include <algorithm>

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/memory/rings.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {
namespace {

// The functions of Vulkan for images and for buffers.
struct ImageTraits {
    using Object = VkImage;
    using Owner = ImageHandle;
    using Query = VkDeviceImageMemoryRequirements;
    static constexpr const char* kWord = "image";
    static constexpr VkObjectType kType = VK_OBJECT_TYPE_IMAGE;
    static constexpr auto kInfo = image_create_info;
    static constexpr VkStructureType kQueryType = VK_STRUCTURE_TYPE_DEVICE_IMAGE_MEMORY_REQUIREMENTS;
    static constexpr auto kNeeds = &DeviceFunctions::vkGetDeviceImageMemoryRequirements;
    static constexpr auto kCreate = &DeviceFunctions::vkCreateImage;
    static constexpr auto kBind = &DeviceFunctions::vkBindImageMemory;
};
struct BufferTraits {
    using Object = VkBuffer;
    using Owner = BufferHandle;
    using Query = VkDeviceBufferMemoryRequirements;
    static constexpr const char* kWord = "buffer";
    static constexpr VkObjectType kType = VK_OBJECT_TYPE_BUFFER;
    static constexpr auto kInfo = buffer_create_info;
    static constexpr VkStructureType kQueryType = VK_STRUCTURE_TYPE_DEVICE_BUFFER_MEMORY_REQUIREMENTS;
    static constexpr auto kNeeds = &DeviceFunctions::vkGetDeviceBufferMemoryRequirements;
    static constexpr auto kCreate = &DeviceFunctions::vkCreateBuffer;
    static constexpr auto kBind = &DeviceFunctions::vkBindBufferMemory;
};

template <class Kind>
MemoryNeed need_of(Device& device, const ResourceDecl& decl, const Sharing& sharing) {
    auto info = Kind::kInfo(decl);
    share(info, sharing);
    typename Kind::Query query{};
    query.sType = Kind::kQueryType;
    query.pCreateInfo = &info;
    VkMemoryRequirements2 answer{VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
    (device.fn().*Kind::kNeeds)(device.handle(), &query, &answer);
    const VkMemoryRequirements& needs = answer.memoryRequirements;
    return {needs.size, needs.alignment, needs.memoryTypeBits};
}

// Returns memory requirements that suit both sharing modes of a resource, exclusive and concurrent. The plan
// decides later which resources several queue families share.
MemoryNeed any_need(Device& device, const ResourceDecl& decl) {
    const auto need = decl.kind == ResourceKind::image ? need_of<ImageTraits> : need_of<BufferTraits>;
    MemoryNeed exclusive = need(device, decl, Sharing{});
    if (device.sharing_families().empty()) return exclusive;
    const MemoryNeed concurrent = need(device, decl, concurrent_sharing(device));
    return {std::max(exclusive.size_bytes, concurrent.size_bytes),
            std::max(exclusive.alignment_bytes, concurrent.alignment_bytes),
            exclusive.type_bits & concurrent.type_bits};
}

// True if several queue families must be able to access `resource`. A resource with history has several
// copies that rotate. So if the plan shares one of them, all of them are shared.
bool is_concurrent(const FramePlan& plan, const Rings& rings, ResourceId resource) {
    const std::vector<uint8_t>& concurrent = plan.barriers.concurrent;
    const std::vector<ResourceId> roles = rings.roles(resource);
    return std::any_of(roles.begin(), roles.end(),
                       [&](ResourceId role) { return role < concurrent.size() && concurrent[role] != 0; });
}

// Returns the alignment that the memory of a heap needs: the offsets of the plan are multiples of the
// alignments of its resources. Memory of vkAllocateMemory() fits every resource, so only an allocator of the
// program needs to know the alignment.
uint64_t heap_alignment(Device& device, const FramePlan& plan, size_t heap) {
    if (device.callbacks().memory == nullptr) return 1;
    uint64_t alignment_bytes = 1;
    for (const Placement& placement : plan.memory.placements)
        if (placement.heap == heap)
            alignment_bytes = std::max(
                alignment_bytes, any_need(device, plan.graph.resources[placement.resource]).alignment_bytes);
    return alignment_bytes;
}

MemoryContent heap_content(const FramePlan& plan, size_t heap) {
    bool images = false, buffers = false;
    for (const Placement& placement : plan.memory.placements) {
        if (placement.heap != heap) continue;
        const bool image = plan.graph.resources[placement.resource].kind == ResourceKind::image;
        (image ? images : buffers) = true;
    }
    if (images && buffers) return MemoryContent::both;
    return images ? MemoryContent::images : MemoryContent::buffers;
}

Result<DeviceMemory> allocate_heap(Device& device, const FramePlan& plan, size_t index,
                                   const std::string& what, const std::string& name) {
    const HeapPlan& heap = plan.memory.heaps[index];
    const uint32_t type = heap_memory_type(device, heap);
    if (type == UINT32_MAX)
        return failed_call("V411", what + " in any memory type of the device", VK_ERROR_FEATURE_NOT_PRESENT);
    MemoryBlock block;
    const VkResult result = allocate_memory(
        device,
        {heap.size_bytes, heap_alignment(device, plan, index), type, false, name, heap_content(plan, index)},
        block);
    if (result != VK_SUCCESS) return failed_call("V411", what, result);
    return DeviceMemory(device, block);
}

// Creates an image or a buffer and binds it to memory.
template <class Kind>
Result<typename Kind::Owner> create_bound(Device& device, const ResourceDecl& decl, const Sharing& sharing,
                                          const MemoryBlock& memory, uint64_t offset_bytes) {
    const std::string what = std::string(Kind::kWord) + " \"" + decl.name + "\"";
    auto info = Kind::kInfo(decl);
    share(info, sharing);
    typename Kind::Object object = VK_NULL_HANDLE;
    VkResult result = (device.fn().*Kind::kCreate)(device.handle(), &info, nullptr, &object);
    if (result != VK_SUCCESS) return failed_call("V411", "creating " + what, result);
    typename Kind::Owner owner(device, object);
    device.name(Kind::kType, reinterpret_cast<uint64_t>(object), decl.name);
    result = (device.fn().*Kind::kBind)(device.handle(), object, memory.memory,
                                        memory.offset_bytes + offset_bytes);
    if (result != VK_SUCCESS) return failed_call("V411", "binding memory of " + what, result);
    return owner;
}

// Creates an image or a buffer with memory of its own. All queue families may use it, because the plans that
// share it may use it on different queues.
Result<SharedObject> make_shared_object(Device& device, const FramePlan& plan, const Placement& placement) {
    const ResourceDecl& decl = plan.graph.resources[placement.resource];
    const uint64_t size_bytes = plan.memory.heaps[placement.heap].size_bytes;
    Result<DeviceMemory> memory = allocate_heap(
        device, plan, placement.heap,
        "allocating " + std::to_string(size_bytes) + " bytes for the shared resource \"" + decl.name + "\"",
        decl.name);
    if (!memory) return memory.take_errors();
    SharedObject object;
    object.memory = std::move(*memory);
    const Sharing sharing = concurrent_sharing(device);
    if (decl.kind == ResourceKind::buffer) {
        Result<BufferHandle> buffer =
            create_bound<BufferTraits>(device, decl, sharing, object.memory.block(), 0);
        if (!buffer) return buffer.take_errors();
        object.buffer = std::move(*buffer);
        return object;
    }
    Result<ImageHandle> image = create_bound<ImageTraits>(device, decl, sharing, object.memory.block(), 0);
    if (!image) return image.take_errors();
    object.image = std::move(*image);
    return object;
}

}  // namespace

MemoryNeeds query_memory_needs(Device& device, const ResolvedGraph& graph) {
    MemoryNeeds needs(graph.resources.size());
    for (size_t i = 0; i < graph.resources.size(); ++i) {
        const ResourceDecl& decl = graph.resources[i];
        // A resource that no pass uses has no usage flags. Vulkan forbids objects without usage flags, so
        // such a resource gets no object.
        if (decl.lifetime == ResourceLifetime::imported || decl.usage == 0) continue;
        needs[i] = any_need(device, decl);
    }
    return needs;
}

uint32_t heap_memory_type(const Device& device, const HeapPlan& heap) {
    const uint32_t type = device.memory_type(heap.type_bits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    return type != UINT32_MAX ? type : device.memory_type(heap.type_bits, 0);
}

Status TransientHeap::allocate(Device& device, const FramePlan& plan) {
    for (size_t i = 0; i < plan.memory.heaps.size(); ++i) {
        const HeapPlan& heap = plan.memory.heaps[i];
        if (heap.shared) {
            memory_.emplace_back();
            continue;
        }
        const std::string what =
            "allocating heap " + std::to_string(i) + " of " + std::to_string(heap.size_bytes) + " bytes";
        Result<DeviceMemory> made = allocate_heap(device, plan, i, what, "heap " + std::to_string(i));
        if (!made) return made.take_errors();
        memory_.push_back(std::move(*made));
        if (!heap.persistent) bytes_ += heap.size_bytes;
    }
    return Unit{};
}

Status TransientHeap::place(Device& device, const ResourceDecl& decl, const Placement& placement,
                            const Sharing& sharing) {
    const MemoryBlock& memory = memory_[placement.heap].block();
    if (decl.kind == ResourceKind::buffer) {
        Result<BufferHandle> buffer =
            create_bound<BufferTraits>(device, decl, sharing, memory, placement.offset_bytes);
        if (!buffer) return buffer.take_errors();
        buffers_[placement.resource] = std::move(*buffer);
        return Unit{};
    }
    Result<ImageHandle> image =
        create_bound<ImageTraits>(device, decl, sharing, memory, placement.offset_bytes);
    if (!image) return image.take_errors();
    images_[placement.resource] = std::move(*image);
    return Unit{};
}

Status TransientHeap::lease(Device& device, const FramePlan& plan, const Placement& placement,
                            SharedStore& shared) {
    const ResourceDecl& decl = plan.graph.resources[placement.resource];
    Result<SharedLease> lease = shared.get(decl, [&] { return make_shared_object(device, plan, placement); });
    if (!lease) return lease.take_errors();
    shared_[placement.resource] = std::move(*lease);
    return Unit{};
}

Result<TransientHeap> TransientHeap::create(Device& device, const FramePlan& plan, SharedStore& shared) {
    TransientHeap heap;
    heap.images_.resize(plan.graph.resources.size());
    heap.buffers_.resize(plan.graph.resources.size());
    heap.shared_.resize(plan.graph.resources.size());
    if (Status status = heap.allocate(device, plan); !status) return status.take_errors();
    Diagnostics errors;
    const Rings rings(plan);
    for (const Placement& placement : plan.memory.placements) {
        const ResourceDecl& decl = plan.graph.resources[placement.resource];
        const bool concurrent = is_concurrent(plan, rings, placement.resource);
        const Sharing sharing = concurrent ? concurrent_sharing(device) : Sharing{};
        const Status status = plan.memory.heaps[placement.heap].shared
                                  ? heap.lease(device, plan, placement, shared)
                                  : heap.place(device, decl, placement, sharing);
        if (!status) append(errors, status.errors());
    }
    if (!errors.empty()) return errors;
    return heap;
}

}  // namespace weft::vk
