// Purpose: provides the draws of raster passes. weft_render implements it for scenes; the executor calls it
// for the layouts of sets 0, 2 and 3 when it creates pipelines, and for the draws when it records.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weft/imports.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

struct DrawContext {
    const DeviceFunctions* fn = nullptr;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    std::string_view list;               // "opaque"
    uint32_t variant = 0;                // index into the list's variants; its pipeline is bound
    CullMode cull = CullMode::material;  // `material`: the source sets cull mode and front face for each draw
    uint32_t frame_slot = 0;
    // A packed VkDrawIndexedIndirectCommand for each draw of the list, in its order, to use instead of the
    // list's own; null: the list's own.
    VkBuffer draw_commands = VK_NULL_HANDLE;
    bool uses_materials = false;  // the pipeline layout has set 2
    bool uses_instances = false;  // the pipeline layout has set 3
};

class DrawSource {
 public:
    virtual ~DrawSource() = default;
    // VK_NULL_HANDLE for a set that the source does not provide. Set 0: frame and view; 2: material; 3: draw.
    [[nodiscard]] virtual VkDescriptorSetLayout set_layout(uint32_t set) const = 0;
    // Set 0 of this frame for `view`.
    [[nodiscard]] virtual VkDescriptorSet frame_set(uint32_t frame_slot, std::string_view view) const = 0;
    // Records every draw of `context.list` with `context.variant`. The executor has bound sets 0 and 1; the
    // source binds sets 2 and 3 if the layout has them. Streams are bound in the order of the import's vertex
    // format.
    virtual void record(const DrawContext& context) const = 0;
    // Number of objects in the list, for messages about slow frames.
    [[nodiscard]] virtual uint64_t draw_count(std::string_view /*list*/) const { return 0; }
};

}  // namespace weft::vk
