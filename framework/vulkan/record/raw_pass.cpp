#include "vulkan/record/raw_pass.h"

#include <algorithm>
#include <cassert>
#include <optional>

#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"
#include "vulkan/memory/raw_recorder.h"

namespace weft::vk {
namespace {

bool is_color_attachment(Access access) {
    return access == Access::color_write || access == Access::color_read_write;
}

bool is_depth_attachment(Access access) {
    return access == Access::depth_write || access == Access::depth_read_write ||
           access == Access::depth_read;
}

VkAttachmentLoadOp load_op_of(Access access, bool has_clear) {
    if (access == Access::depth_write) return VK_ATTACHMENT_LOAD_OP_CLEAR;
    if (access != Access::color_write) return VK_ATTACHMENT_LOAD_OP_LOAD;
    return has_clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_DONT_CARE;
}

VkRenderingAttachmentInfo attachment_of(const RawPort& port, std::span<const RawClear> clears) {
    const auto clear = std::ranges::find(clears, port.name, &RawClear::port);
    VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    info.imageView = port.view;
    info.imageLayout = port.layout;
    info.loadOp = load_op_of(port.access, clear != clears.end());
    info.storeOp =
        port.access == Access::depth_read ? VK_ATTACHMENT_STORE_OP_NONE : VK_ATTACHMENT_STORE_OP_STORE;
    if (clear != clears.end()) info.clearValue = clear->value;
    return info;
}

RawPort port_of(const RecordContext& context, const UseDecl& use, VkImageView view) {
    const ResourceDecl& decl = context.objects.plan.graph.resources[use.resource];
    RawPort port;
    port.name = use.port;
    port.is_output = use.is_output;
    port.access = use.access;
    if (decl.kind == ResourceKind::buffer) {
        const ByteRange bytes = used_bytes(decl, use);
        port.buffer = context.resources.buffer(use.resource);
        port.offset_bytes = bytes.offset_bytes;
        port.size_bytes = bytes.size_bytes;
        return port;
    }
    port.image = context.resources.image(use.resource);
    port.view = view;
    port.format = to_vk(decl.format);
    port.extent = to_vk(mip_extent(decl.extent, use.range.mip));
    port.samples = samples_to_vk(decl.samples);
    port.layout = to_vk(use.state.layout);
    port.range = to_vk(use.range);
    return port;
}

std::optional<size_t> find_use(const PassDecl& pass, const PortDecl& port) {
    for (size_t i = 0; i < pass.uses.size(); ++i)
        if (pass.uses[i].port == port.name && pass.uses[i].is_output == port.is_output) return i;
    return std::nullopt;
}

const RawPort& find_port(std::span<const RawPort> ports, std::string_view name, bool is_output) {
    static const RawPort none;
    const auto found = std::ranges::find_if(
        ports, [&](const RawPort& port) { return port.name == name && port.is_output == is_output; });
    assert(found != ports.end() && "the pass type declares no such port");
    return found == ports.end() ? none : *found;
}

}  // namespace

const RawPort& RawCommands::in(std::string_view port) const {
    return find_port(ports, port, false);
}

const RawPort& RawCommands::out(std::string_view port) const {
    return find_port(ports, port, true);
}

void RawCommands::begin_rendering(std::span<const RawClear> clears) const {
    std::vector<VkRenderingAttachmentInfo> colors;
    std::optional<VkRenderingAttachmentInfo> depth;
    VkImageAspectFlags aspects = 0;
    VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
    for (const RawPort& port : ports) {
        if (is_color_attachment(port.access)) colors.push_back(attachment_of(port, clears));
        if (is_depth_attachment(port.access)) depth = attachment_of(port, clears);
        if (is_depth_attachment(port.access)) aspects = port.range.aspectMask;
        if (!is_color_attachment(port.access) && !is_depth_attachment(port.access)) continue;
        info.renderArea.extent = {port.extent.width, port.extent.height};
        info.layerCount = port.range.layerCount;
    }
    assert(info.layerCount > 0 && "the pass has no attachment");
    info.colorAttachmentCount = static_cast<uint32_t>(colors.size());
    info.pColorAttachments = colors.data();
    if (depth && (aspects & VK_IMAGE_ASPECT_DEPTH_BIT) != 0) info.pDepthAttachment = &*depth;
    if (depth && (aspects & VK_IMAGE_ASPECT_STENCIL_BIT) != 0) info.pStencilAttachment = &*depth;
    fn->vkCmdBeginRendering(commands, &info);
}

void RawCommands::end_rendering() const {
    fn->vkCmdEndRendering(commands);
}

const RawCommands& raw_commands(Recorder& recorder) {
    return dynamic_cast<RawRecorder&>(recorder).raw();
}

Result<std::vector<VkImageView>> make_port_views(const PassDecl& pass, ViewCache& views, uint64_t frame) {
    std::vector<VkImageView> made;
    for (const UseDecl& use : pass.uses) {
        Result<VkImageView> view = views.port_view(use, frame);
        if (!view) return view.take_errors();
        made.push_back(*view);
    }
    return made;
}

std::string port_fault(const FramePlan& plan, const UseDecl& use) {
    const ResourceDecl& decl = plan.graph.resources[use.resource];
    if (!is_color_attachment(use.access) && !is_depth_attachment(use.access)) return {};
    if (decl.kind == ResourceKind::image && decl.image_kind != ImageKind::d3 && use.range.mips == 1)
        return {};
    return "the attachment \"" + use.port + "\" must be one mip of an image that is not 3D, but \"" +
           decl.name + "\" is another kind of resource or has several mips";
}

void record_custom(const RecordContext& context, Position position, const PassDecl& pass,
                   const PreparedPass& prepared) {
    static const HostInputs none;
    const std::vector<VkImageView>& views = prepared.port_view_set(context.resources.frame());
    std::vector<RawPort> ports;
    for (const PortDecl& declared : prepared.type->ports)
        if (const std::optional<size_t> use = find_use(pass, declared))
            ports.push_back(port_of(context, pass.uses[*use], views[*use]));
    RawCommands raw;
    raw.commands = context.commands;
    raw.physical = context.device.physical();
    raw.device = context.device.handle();
    raw.queue_family = context.family;
    raw.frame_slot = context.slot;
    raw.frame_index = context.frame.frame_index;
    raw.host = context.frame.host != nullptr ? context.frame.host : &none;
    raw.ports = ports;
    raw.fn = &context.device.fn();
    context.objects.uploads.record(raw, {context.device, position, *prepared.type, pass, context.slot},
                                   context.resources);
}

}  // namespace weft::vk
