// Purpose: the attachments of a pass and what happens to them, as one dynamic rendering scope, which several
// passes may share: the first begins it, the last ends it.
// Errors: V411.
#pragma once

#include <vector>

#include "vulkan/memory/views.h"

namespace weft::vk {

struct RenderingScope {
    std::vector<VkRenderingAttachmentInfo> colors;  // by location; gaps have no view
    VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    VkRenderingAttachmentInfo stencil{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    VkRect2D area{};
    uint32_t layers = 1;
    bool begins = true;  // false: the pass goes on in the scope of the one before it
    bool ends = true;    // false: the next pass on the queue goes on
};

[[nodiscard]] Result<RenderingScope> make_rendering_scope(const FramePlan& plan, const PassStep& step,
                                                          ViewCache& views, uint64_t frame);

// Begins the scope unless the pass before did, and sets the dynamic state from the pass: viewport, scissor,
// cull mode, front face.
void begin_rendering(const Device& device, VkCommandBuffer commands, const RenderingScope& scope,
                     const RasterState& state);
// Ends the scope unless the next pass goes on in it.
void end_rendering(const Device& device, VkCommandBuffer commands, const RenderingScope& scope);

// A clear value for a colour format: integers for integer formats.
[[nodiscard]] VkClearColorValue clear_color(Format format, const std::array<float, 4>& value);

}  // namespace weft::vk
