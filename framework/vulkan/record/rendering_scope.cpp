#include "vulkan/record/rendering_scope.h"

#include <algorithm>

#include "graph/diagnostics/whole_number.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"
#include "vulkan/pipelines/graphics_state.h"

namespace weft::vk {
namespace {

// Returns the plan's load and store operations of one attachment. An attachment that the plan does not list
// keeps its content: it is loaded and stored.
AttachmentOps ops_of(const PassStep& step, uint32_t use) {
    for (const AttachmentOps& ops : step.attachments)
        if (ops.use == use) return ops;
    return {use, LoadOp::load, StoreOp::store};
}

// Adds the resolve of a multisampled attachment to `info`: float formats resolve to the mean of the samples,
// integer formats to sample 0.
Status add_resolve(const FramePlan& plan, const UseDecl& target, ViewCache& views, uint64_t frame,
                   VkRenderingAttachmentInfo& info) {
    Result<VkImageView> view = views.attachment_view(target, frame);
    if (!view) return view.take_errors();
    const Format format = plan.graph.resources[target.resource].format;
    info.resolveMode = format_info(format).numeric == NumericClass::float_like
                           ? VK_RESOLVE_MODE_AVERAGE_BIT
                           : VK_RESOLVE_MODE_SAMPLE_ZERO_BIT;
    info.resolveImageView = *view;
    info.resolveImageLayout = to_vk(target.state.layout);
    return Unit{};
}

Result<VkRenderingAttachmentInfo> attachment(const PassDecl& pass, const AttachmentDecl& decl,
                                             const PassStep& step, ViewCache& views, uint64_t frame) {
    const UseDecl& use = pass.uses[decl.use];
    Result<VkImageView> view = views.attachment_view(use, frame);
    if (!view) return view.take_errors();
    const AttachmentOps ops = ops_of(step, decl.use);
    VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    info.imageView = *view;
    info.imageLayout = to_vk(use.state.layout);
    info.loadOp = to_vk(ops.load);
    info.storeOp = to_vk(ops.store);
    return info;
}

// Returns the part of a scissor rectangle inside the area. Vulkan requires that a pass draws only there.
RectPx inside(const RectPx& scissor, const VkExtent2D& area) {
    const auto x = std::min(static_cast<uint32_t>(scissor.x), area.width);
    const auto y = std::min(static_cast<uint32_t>(scissor.y), area.height);
    return {static_cast<int32_t>(x), static_cast<int32_t>(y), std::min(scissor.width, area.width - x),
            std::min(scissor.height, area.height - y)};
}

}  // namespace

VkClearColorValue clear_color(Format format, const std::array<float, 4>& value) {
    VkClearColorValue out{};
    for (size_t i = 0; i < value.size(); ++i) {
        switch (format_info(format).numeric) {
            case NumericClass::sint:
                out.int32[i] = saturated<int32_t>(value[i]);
                break;
            case NumericClass::uint:
                out.uint32[i] = saturated<uint32_t>(value[i]);
                break;
            case NumericClass::float_like:
            case NumericClass::depth:
                out.float32[i] = value[i];
                break;
        }
    }
    return out;
}

Result<RenderingScope> make_rendering_scope(const FramePlan& plan, const PassStep& step, ViewCache& views,
                                            uint64_t frame) {
    const PassDecl& pass = plan.graph.passes[step.pass];
    RenderingScope scope;
    scope.area.extent = {pass.render_extent.width, pass.render_extent.height};
    scope.view_mask = view_mask(pass);
    for (const AttachmentDecl& color : pass.colors) {
        const UseDecl& use = pass.uses[color.use];
        Result<VkRenderingAttachmentInfo> info = attachment(pass, color, step, views, frame);
        if (!info) return info.take_errors();
        info->clearValue.color = clear_color(plan.graph.resources[use.resource].format, color.clear);
        if (color.resolve_use != kNoId) {
            Status added = add_resolve(plan, pass.uses[color.resolve_use], views, frame, *info);
            if (!added) return added.take_errors();
        }
        if (scope.colors.size() <= color.location)
            scope.colors.resize(color.location + 1, {VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO});
        scope.colors[color.location] = *info;
        scope.layers = use.range.layers;
    }
    if (!pass.depth) return scope;
    const UseDecl& use = pass.uses[pass.depth->use];
    Result<VkRenderingAttachmentInfo> info = attachment(pass, *pass.depth, step, views, frame);
    if (!info) return info.take_errors();
    info->clearValue.depthStencil = {pass.depth->clear[0], saturated<uint32_t>(pass.depth->clear[1])};
    const FormatInfo& format = format_info(plan.graph.resources[use.resource].format);
    if (format.depth) scope.depth = *info;
    if (format.stencil) scope.stencil = *info;
    scope.layers = use.range.layers;
    return scope;
}

void begin_rendering(const Device& device, VkCommandBuffer commands, const RenderingScope& scope,
                     const VkExtent2D& area, const RasterState& state) {
    VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
    info.renderArea.extent = area;
    info.layerCount = scope.layers;
    info.viewMask = scope.view_mask;
    info.colorAttachmentCount = static_cast<uint32_t>(scope.colors.size());
    info.pColorAttachments = scope.colors.data();
    if (scope.depth.imageView != VK_NULL_HANDLE) info.pDepthAttachment = &scope.depth;
    if (scope.stencil.imageView != VK_NULL_HANDLE) info.pStencilAttachment = &scope.stencil;
    if (scope.begins) device.fn().vkCmdBeginRendering(commands, &info);
    set_draw_state(device, commands, area, state);
}

void set_draw_state(const Device& device, VkCommandBuffer commands, const VkExtent2D& area,
                    const RasterState& state) {
    const DeviceFunctions& fn = device.fn();
    const RectPx whole{0, 0, area.width, area.height};
    const RectPx view = state.viewport.value_or(whole);
    const VkViewport viewport{static_cast<float>(view.x),
                              static_cast<float>(view.y),
                              static_cast<float>(view.width),
                              static_cast<float>(view.height),
                              0,
                              1};
    fn.vkCmdSetViewport(commands, 0, 1, &viewport);
    const RectPx cut = inside(state.scissor.value_or(whole), area);
    const VkRect2D scissor{{cut.x, cut.y}, {cut.width, cut.height}};
    fn.vkCmdSetScissor(commands, 0, 1, &scissor);
    fn.vkCmdSetCullMode(commands, to_vk(state.cull));
    fn.vkCmdSetFrontFace(commands, to_vk(state.front_face));
}

void end_rendering(const Device& device, VkCommandBuffer commands, const RenderingScope& scope) {
    if (scope.ends) device.fn().vkCmdEndRendering(commands);
}

}  // namespace weft::vk
