#include "vulkan/memory/transient_heap.h"

#include <algorithm>

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/memory/rings.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {
namespace {

MemoryNeed to_need(const VkMemoryRequirements& requirements) {
    return {requirements.size, requirements.alignment, requirements.memoryTypeBits};
}

MemoryNeed image_need(Device& device, const ResourceDecl& decl, const Sharing& sharing) {
    VkImageCreateInfo info = image_create_info(decl);
    share(info, sharing);
    VkDeviceImageMemoryRequirements query{VK_STRUCTURE_TYPE_DEVICE_IMAGE_MEMORY_REQUIREMENTS};
    query.pCreateInfo = &info;
    VkMemoryRequirements2 answer{VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
    device.fn().vkGetDeviceImageMemoryRequirements(device.handle(), &query, &answer);
    return to_need(answer.memoryRequirements);
}

MemoryNeed buffer_need(Device& device, const ResourceDecl& decl, const Sharing& sharing) {
    VkBufferCreateInfo info = buffer_create_info(decl);
    share(info, sharing);
    VkDeviceBufferMemoryRequirements query{VK_STRUCTURE_TYPE_DEVICE_BUFFER_MEMORY_REQUIREMENTS};
    query.pCreateInfo = &info;
    VkMemoryRequirements2 answer{VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
    device.fn().vkGetDeviceBufferMemoryRequirements(device.handle(), &query, &answer);
    return to_need(answer.memoryRequirements);
}

// Returns memory requirements that suit both sharing modes of a resource, exclusive and concurrent. The plan
// decides later which resources several queue families share.
MemoryNeed any_need(Device& device, const ResourceDecl& decl) {
    const auto need = decl.kind == ResourceKind::image ? image_need : buffer_need;
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

Result<MemoryHandle> allocate_memory(Device& device, const HeapPlan& heap, const std::string& what) {
    uint32_t type = device.memory_type(heap.type_bits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    if (type == UINT32_MAX) type = device.memory_type(heap.type_bits, 0);
    if (type == UINT32_MAX)
        return failed_call("V411", what + " in any memory type of the device", VK_ERROR_FEATURE_NOT_PRESENT);
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = heap.size_bytes;
    info.memoryTypeIndex = type;
    VkDeviceMemory object = VK_NULL_HANDLE;
    const VkResult result = device.fn().vkAllocateMemory(device.handle(), &info, nullptr, &object);
    if (result != VK_SUCCESS) return failed_call("V411", what, result);
    return MemoryHandle(device, object);
}

// Creates an image and binds it to memory.
Result<ImageHandle> make_image(Device& device, const ResourceDecl& decl, const Sharing& sharing,
                               VkDeviceMemory memory, uint64_t offset_bytes) {
    VkImageCreateInfo info = image_create_info(decl);
    share(info, sharing);
    VkImage object = VK_NULL_HANDLE;
    VkResult result = device.fn().vkCreateImage(device.handle(), &info, nullptr, &object);
    if (result != VK_SUCCESS) return failed_call("V411", "creating image \"" + decl.name + "\"", result);
    ImageHandle image(device, object);
    device.name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(object), decl.name);
    result = device.fn().vkBindImageMemory(device.handle(), object, memory, offset_bytes);
    if (result != VK_SUCCESS)
        return failed_call("V411", "binding memory of image \"" + decl.name + "\"", result);
    return image;
}

// Creates a buffer and binds it to memory.
Result<BufferHandle> make_buffer(Device& device, const ResourceDecl& decl, const Sharing& sharing,
                                 VkDeviceMemory memory, uint64_t offset_bytes) {
    VkBufferCreateInfo info = buffer_create_info(decl);
    share(info, sharing);
    VkBuffer object = VK_NULL_HANDLE;
    VkResult result = device.fn().vkCreateBuffer(device.handle(), &info, nullptr, &object);
    if (result != VK_SUCCESS) return failed_call("V411", "creating buffer \"" + decl.name + "\"", result);
    BufferHandle buffer(device, object);
    device.name(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<uint64_t>(object), decl.name);
    result = device.fn().vkBindBufferMemory(device.handle(), object, memory, offset_bytes);
    if (result != VK_SUCCESS)
        return failed_call("V411", "binding memory of buffer \"" + decl.name + "\"", result);
    return buffer;
}

// Creates an image or a buffer with memory of its own. All queue families may use it, because the plans that
// share it may use it on different queues.
Result<SharedObject> make_shared_object(Device& device, const ResourceDecl& decl, const HeapPlan& heap) {
    Result<MemoryHandle> memory = allocate_memory(device, heap,
                                                  "allocating " + std::to_string(heap.size_bytes) +
                                                      " bytes for the shared resource \"" + decl.name + "\"");
    if (!memory) return memory.take_errors();
    SharedObject object;
    object.memory = std::move(*memory);
    const Sharing sharing = concurrent_sharing(device);
    if (decl.kind == ResourceKind::buffer) {
        Result<BufferHandle> buffer = make_buffer(device, decl, sharing, object.memory.get(), 0);
        if (!buffer) return buffer.take_errors();
        object.buffer = std::move(*buffer);
        return object;
    }
    Result<ImageHandle> image = make_image(device, decl, sharing, object.memory.get(), 0);
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

Status TransientHeap::allocate(Device& device, const MemoryPlan& memory) {
    for (size_t i = 0; i < memory.heaps.size(); ++i) {
        const HeapPlan& heap = memory.heaps[i];
        if (heap.shared) {
            memory_.emplace_back();
            continue;
        }
        const std::string what =
            "allocating heap " + std::to_string(i) + " of " + std::to_string(heap.size_bytes) + " bytes";
        Result<MemoryHandle> made = allocate_memory(device, heap, what);
        if (!made) return made.take_errors();
        memory_.push_back(std::move(*made));
        if (!heap.persistent) bytes_ += heap.size_bytes;
    }
    return Unit{};
}

Status TransientHeap::place(Device& device, const ResourceDecl& decl, const Placement& placement,
                            const Sharing& sharing) {
    const VkDeviceMemory memory = memory_[placement.heap].get();
    if (decl.kind == ResourceKind::buffer) {
        Result<BufferHandle> buffer = make_buffer(device, decl, sharing, memory, placement.offset_bytes);
        if (!buffer) return buffer.take_errors();
        buffers_[placement.resource] = std::move(*buffer);
        return Unit{};
    }
    Result<ImageHandle> image = make_image(device, decl, sharing, memory, placement.offset_bytes);
    if (!image) return image.take_errors();
    images_[placement.resource] = std::move(*image);
    return Unit{};
}

Status TransientHeap::lease(Device& device, const FramePlan& plan, const Placement& placement,
                            SharedStore& shared) {
    const ResourceDecl& decl = plan.graph.resources[placement.resource];
    Result<SharedLease> lease =
        shared.get(decl, [&] { return make_shared_object(device, decl, plan.memory.heaps[placement.heap]); });
    if (!lease) return lease.take_errors();
    shared_[placement.resource] = std::move(*lease);
    return Unit{};
}

Result<TransientHeap> TransientHeap::create(Device& device, const FramePlan& plan, SharedStore& shared) {
    TransientHeap heap;
    heap.images_.resize(plan.graph.resources.size());
    heap.buffers_.resize(plan.graph.resources.size());
    heap.shared_.resize(plan.graph.resources.size());
    if (Status status = heap.allocate(device, plan.memory); !status) return status.take_errors();
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
