// Purpose: the attachments of a pass and what happens to them, as one dynamic rendering scope.
// Errors: V411.
#pragma once

#include <vector>

#include "vulkan/views.h"

namespace weft::vk {

struct RenderingScope {
    std::vector<VkRenderingAttachmentInfo> colors;  // by location; gaps have no view
    VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    VkRenderingAttachmentInfo stencil{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    VkRect2D area{};
    uint32_t layers = 1;
};

[[nodiscard]] Result<RenderingScope> make_rendering_scope(const FramePlan& plan, const PassStep& step,
                                                          ViewCache& views, uint64_t frame);

// Begins the scope and sets the dynamic state from the pass: viewport, scissor, cull mode, front face.
void begin_rendering(const Device& device, VkCommandBuffer commands, const RenderingScope& scope,
                     const RasterState& state);

// A clear value for a colour format: integers for integer formats.
[[nodiscard]] VkClearColorValue clear_color(Format format, const std::array<float, 4>& value);

}  // namespace weft::vk
