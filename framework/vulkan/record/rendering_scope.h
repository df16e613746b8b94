// Purpose: one dynamic rendering scope (vkCmdBeginRendering to vkCmdEndRendering) with the attachments of a
// pass and their load and store operations. Several passes may share a scope: the first of them begins it,
// the last ends it. Errors: V411 (an image view could not be created).
#pragma once

#include <vector>

#include "vulkan/memory/views.h"

namespace weft::vk {

struct RenderingScope {
    // Colour attachments, indexed by the shader's output location. An unused location has no view.
    std::vector<VkRenderingAttachmentInfo> colors;
    VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    VkRenderingAttachmentInfo stencil{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    VkRect2D area{};
    uint32_t layers = 1;
    uint32_t view_mask = 0;  // The views that each draw draws; 0 without multiview.
    // False if the pass continues the rendering scope of the previous pass on the queue.
    bool begins = true;
    // False if the next pass on the queue continues the rendering scope.
    bool ends = true;
};

[[nodiscard]] Result<RenderingScope> make_rendering_scope(const FramePlan& plan, const PassStep& step,
                                                          ViewCache& views, uint64_t frame);

// Begins the rendering scope, unless a previous pass has begun it, and calls set_draw_state(). `area`: the
// part of the attachments at the top left to which the pass draws.
void begin_rendering(const Device& device, VkCommandBuffer commands, const RenderingScope& scope,
                     const VkExtent2D& area, const RasterState& state);
// Sets the dynamic state of a pass that draws to this area: viewport, scissor, cull mode, front face.
void set_draw_state(const Device& device, VkCommandBuffer commands, const VkExtent2D& area,
                    const RasterState& state);
// Ends the rendering scope, unless the next pass continues it.
void end_rendering(const Device& device, VkCommandBuffer commands, const RenderingScope& scope);

// Returns the clear value in the type of a colour format: integers for integer formats, else floats.
[[nodiscard]] VkClearColorValue clear_color(Format format, const std::array<float, 4>& value);

}  // namespace weft::vk
