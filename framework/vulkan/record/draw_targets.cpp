#include "vulkan/record/draw_targets.h"

#include <algorithm>

#include "vulkan/device/to_vk.h"
#include "vulkan/pipelines/graphics_state.h"

namespace weft::vk {

DrawTargets draw_targets(const ResolvedGraph& graph, const PassDecl& pass) {
    DrawTargets targets;
    targets.extent = {pass.render_extent.width, pass.render_extent.height};
    targets.view_mask = view_mask(pass);
    for (const AttachmentDecl& color : pass.colors) {
        if (color.location >= DrawTargets::kMost) continue;
        const ResourceDecl& image = graph.resources[pass.uses[color.use].resource];
        targets.colors[color.location] = to_vk(image.format);
        targets.color_count = std::max(targets.color_count, color.location + 1);
        targets.samples = samples_to_vk(image.samples);
    }
    if (!pass.depth) return targets;
    const ResourceDecl& image = graph.resources[pass.uses[pass.depth->use].resource];
    const FormatInfo& format = format_info(image.format);
    if (format.depth) targets.depth = to_vk(image.format);
    if (format.stencil) targets.stencil = to_vk(image.format);
    targets.samples = samples_to_vk(image.samples);
    return targets;
}

}  // namespace weft::vk
