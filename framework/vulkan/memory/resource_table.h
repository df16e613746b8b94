// Purpose: maps each resource that a plan uses to a Vulkan object. Transient and persistent resources come
// from the heaps of the plan, imports from the program. Error V414: an import is missing; the format, size,
// mip levels, layers or samples of an imported image differ from those in the resolved graph; or a table of
// textures has more or fewer textures than in the resolved graph.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "vulkan/memory/rings.h"
#include "vulkan/memory/transient_heap.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

struct ResourceTable {
    // One image for each ResourceId; null for buffers and for resources that the plan does not use.
    std::vector<VkImage> images;
    // One buffer for each ResourceId; null for images and for resources that the plan does not use.
    std::vector<VkBuffer> buffers;
    // The buffers of the imports that have one buffer for each frame slot.
    std::map<ResourceId, std::array<VkBuffer, kFramesInFlight>> slot_buffers = {};
    // The image views of each table of textures, a list of textures that a shader indexes.
    std::map<ResourceId, std::vector<VkImageView>> textures = {};
    Rings rings = {};
};

// The resource table as one frame uses it. A resource with history has several copies in memory, whose roles
// (content of this frame, of the previous frame, and so on) rotate. This class finds the copy for its frame,
// and the buffers of its frame slot.
class FrameResources {
 public:
    FrameResources(const ResourceTable& table, uint64_t frame, uint32_t slot = 0)
        : table_(&table), frame_(frame), slot_(slot) {}

    [[nodiscard]] VkImage image(ResourceId id) const {
        return table_->images[table_->rings.copy(id, frame_)];
    }
    [[nodiscard]] VkBuffer buffer(ResourceId id) const {
        if (has_slot_buffers(id)) return table_->slot_buffers.at(id)[slot_];
        return table_->buffers[table_->rings.copy(id, frame_)];
    }
    [[nodiscard]] bool has_slot_buffers(ResourceId id) const {
        return !table_->slot_buffers.empty() && table_->slot_buffers.contains(id);
    }
    // Returns the views of a table of textures; null if the resource is no table.
    [[nodiscard]] const std::vector<VkImageView>* textures(ResourceId id) const {
        const auto table = table_->textures.find(id);
        return table == table_->textures.end() ? nullptr : &table->second;
    }
    [[nodiscard]] FrameResources in_slot(uint32_t slot) const { return {*table_, frame_, slot}; }
    [[nodiscard]] const Rings& rings() const { return table_->rings; }
    [[nodiscard]] uint64_t frame() const { return frame_; }

 private:
    const ResourceTable* table_;
    uint64_t frame_;
    uint32_t slot_;
};

[[nodiscard]] Result<ResourceTable> bind_resources(const FramePlan& plan, const TransientHeap& heap,
                                                   const ImportBindings& bindings);

}  // namespace weft::vk
