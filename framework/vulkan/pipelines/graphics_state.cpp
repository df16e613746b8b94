#include "vulkan/pipelines/graphics_state.h"

#include <algorithm>
#include <array>

#include "vulkan/device/to_vk.h"

namespace weft::vk {
namespace {

constexpr std::array kDynamicStates{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                    VK_DYNAMIC_STATE_CULL_MODE, VK_DYNAMIC_STATE_FRONT_FACE};

VkPipelineColorBlendAttachmentState blend_attachment(const BlendState& blend) {
    VkPipelineColorBlendAttachmentState out{};
    out.blendEnable = blend.enabled ? VK_TRUE : VK_FALSE;
    out.srcColorBlendFactor = to_vk(blend.src_color);
    out.dstColorBlendFactor = to_vk(blend.dst_color);
    out.colorBlendOp = to_vk(blend.color_op);
    out.srcAlphaBlendFactor = to_vk(blend.src_alpha);
    out.dstAlphaBlendFactor = to_vk(blend.dst_alpha);
    out.alphaBlendOp = to_vk(blend.alpha_op);
    out.colorWriteMask = write_mask_to_vk(blend.write_mask);
    return out;
}

VkStencilOpState stencil_face(const StencilFaceState& face) {
    return {to_vk(face.fail), to_vk(face.pass), to_vk(face.depth_fail), to_vk(face.compare),
            face.read_mask,   face.write_mask,  face.reference};
}

VkBool32 flag(bool value) {
    return value ? VK_TRUE : VK_FALSE;
}

}  // namespace

uint32_t view_mask(const PassDecl& pass) {
    if (pass.lowering != ViewLowering::multiview) return 0;
    return static_cast<uint32_t>((uint64_t{1} << pass.views.size()) - 1);
}

GraphicsState::GraphicsState(const ResolvedGraph& graph, const PassDecl& pass,
                             const ShaderInterface& interface, const VertexFormat* vertices) {
    set_vertex_input(interface, vertices);
    assembly_.topology = to_vk(pass.state.topology);
    viewport_.viewportCount = 1;
    viewport_.scissorCount = 1;
    set_rasterization(pass.state);
    set_depth_stencil(pass.state);
    set_attachments(graph, pass);
    samples_.alphaToCoverageEnable = flag(pass.state.alpha_to_coverage);
    dynamic_.dynamicStateCount = static_cast<uint32_t>(kDynamicStates.size());
    dynamic_.pDynamicStates = kDynamicStates.data();
}

void GraphicsState::set_vertex_input(const ShaderInterface& interface, const VertexFormat* vertices) {
    for (const StageVariable& input : interface.vertex_inputs) {
        const VertexAttribute* found = nullptr;
        if (vertices != nullptr)
            for (const VertexAttribute& attribute : vertices->attributes)
                if (attribute.name == input.name) found = &attribute;
        if (found == nullptr) {
            missing_inputs_.push_back(input.name);
            continue;
        }
        attributes_.push_back({input.location, found->stream, to_vk(found->format), found->offset_bytes});
        const auto same_stream = [&](const auto& stream) { return stream.binding == found->stream; };
        if (std::none_of(streams_.begin(), streams_.end(), same_stream))
            streams_.push_back(
                {found->stream, vertices->stride_bytes[found->stream], VK_VERTEX_INPUT_RATE_VERTEX});
    }
    vertex_input_.vertexBindingDescriptionCount = static_cast<uint32_t>(streams_.size());
    vertex_input_.pVertexBindingDescriptions = streams_.data();
    vertex_input_.vertexAttributeDescriptionCount = static_cast<uint32_t>(attributes_.size());
    vertex_input_.pVertexAttributeDescriptions = attributes_.data();
}

void GraphicsState::set_rasterization(const RasterState& state) {
    raster_.depthClampEnable = flag(state.depth_clamp);
    raster_.polygonMode = to_vk(state.fill);
    raster_.depthBiasEnable =
        flag(state.depth_bias_constant != 0 || state.depth_bias_slope != 0 || state.depth_bias_clamp != 0);
    raster_.depthBiasConstantFactor = state.depth_bias_constant;
    raster_.depthBiasSlopeFactor = state.depth_bias_slope;
    raster_.depthBiasClamp = state.depth_bias_clamp;
    raster_.lineWidth = 1;
}

void GraphicsState::set_depth_stencil(const RasterState& state) {
    depth_.depthTestEnable = flag(state.depth_test);
    depth_.depthWriteEnable = flag(state.depth_write);
    depth_.depthCompareOp = to_vk(state.depth_compare);
    depth_.stencilTestEnable = flag(state.stencil_test);
    depth_.front = stencil_face(state.stencil_front);
    depth_.back = stencil_face(state.stencil_back);
}

void GraphicsState::set_attachments(const ResolvedGraph& graph, const PassDecl& pass) {
    uint32_t samples = 1;
    for (const AttachmentDecl& color : pass.colors) {
        const ResourceDecl& target = graph.resources[pass.uses[color.use].resource];
        if (color_formats_.size() <= color.location) {
            color_formats_.resize(color.location + 1, VK_FORMAT_UNDEFINED);
            blends_.resize(color.location + 1);
        }
        color_formats_[color.location] = to_vk(target.format);
        blends_[color.location] = blend_attachment(color.blend);
        samples = target.samples;
    }
    if (pass.depth) {
        const ResourceDecl& target = graph.resources[pass.uses[pass.depth->use].resource];
        const FormatInfo& format = format_info(target.format);
        if (format.depth) rendering_.depthAttachmentFormat = to_vk(target.format);
        if (format.stencil) rendering_.stencilAttachmentFormat = to_vk(target.format);
        samples = target.samples;
    }
    rendering_.viewMask = view_mask(pass);
    rendering_.colorAttachmentCount = static_cast<uint32_t>(color_formats_.size());
    rendering_.pColorAttachmentFormats = color_formats_.data();
    blend_.attachmentCount = static_cast<uint32_t>(blends_.size());
    blend_.pAttachments = blends_.data();
    samples_.rasterizationSamples = samples_to_vk(samples);
}

VkGraphicsPipelineCreateInfo GraphicsState::info() const {
    VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
    info.pNext = &rendering_;
    info.pVertexInputState = &vertex_input_;
    info.pInputAssemblyState = &assembly_;
    info.pViewportState = &viewport_;
    info.pRasterizationState = &raster_;
    info.pMultisampleState = &samples_;
    info.pDepthStencilState = &depth_;
    info.pColorBlendState = &blend_;
    info.pDynamicState = &dynamic_;
    return info;
}

}  // namespace weft::vk
