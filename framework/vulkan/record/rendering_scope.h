// Purpose: one dynamic rendering scope with the attachments of a pass and their operations. Several passes
// may share it: the first begins it, the last ends it. Errors: V411.
#pragma once

#include <vector>

#include "vulkan/memory/views.h"

namespace weft::vk {

struct RenderingScope {
    std::vector<VkRenderingAttachmentInfo> colors;  // indexed by location; an unused location has no view
    VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    VkRenderingAttachmentInfo stencil{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    VkRect2D area{};
    uint32_t layers = 1;
    bool begins = true;  // false: the pass continues the scope of the previous pass
    bool ends = true;    // false: the next pass on the queue continues the scope
};

[[nodiscard]] Result<RenderingScope> make_rendering_scope(const FramePlan& plan, const PassStep& step,
                                                          ViewCache& views, uint64_t frame);

// Begins the scope unless the previous pass did, and sets the pass's dynamic state: viewport, scissor, cull
// mode, front face.
void begin_rendering(const Device& device, VkCommandBuffer commands, const RenderingScope& scope,
                     const RasterState& state);
// Ends the scope unless the next pass continues it.
void end_rendering(const Device& device, VkCommandBuffer commands, const RenderingScope& scope);

// The clear value for a colour format; integer formats get integers.
[[nodiscard]] VkClearColorValue clear_color(Format format, const std::array<float, 4>& value);

}  // namespace weft::vk
