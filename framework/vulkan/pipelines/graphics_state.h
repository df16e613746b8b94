// Purpose: converts the fixed-function state of a pass to the structures of VkGraphicsPipelineCreateInfo,
// which point to each other. Viewport, scissor, cull mode and front face are dynamic state.
#pragma once

#include <vector>

#include "vulkan/device/functions.h"
#include "weft/declaration.h"
#include "weft/imports.h"
#include "weft/result.h"
#include "weft/shader_interface.h"

namespace weft::vk {

// Returns the mask of the views that one draw of the pass draws, with one bit for each view; 0 without
// multiview.
[[nodiscard]] uint32_t view_mask(const PassDecl& pass);

// GraphicsState cannot be moved, because its structures contain pointers to its own members.
class GraphicsState {
 public:
    // `vertices` is the vertex format of the draw list; it may be null if the shader has no vertex inputs.
    GraphicsState(const ResolvedGraph& graph, const PassDecl& pass, const ShaderInterface& interface,
                  const VertexFormat* vertices);
    GraphicsState(const GraphicsState&) = delete;
    GraphicsState& operator=(const GraphicsState&) = delete;

    // Returns the create info with all members filled in, except the shader stages and the pipeline layout.
    [[nodiscard]] VkGraphicsPipelineCreateInfo info() const;
    // Returns the names of the shader's vertex inputs that the vertex format lacks. If there are any, do not
    // create a pipeline from this state.
    [[nodiscard]] const std::vector<std::string>& missing_inputs() const { return missing_inputs_; }

 private:
    void set_vertex_input(const ShaderInterface& interface, const VertexFormat* vertices);
    void set_rasterization(const RasterState& state);
    void set_depth_stencil(const RasterState& state);
    void set_attachments(const ResolvedGraph& graph, const PassDecl& pass);

    std::vector<std::string> missing_inputs_;
    std::vector<VkVertexInputBindingDescription> streams_;
    std::vector<VkVertexInputAttributeDescription> attributes_;
    std::vector<VkPipelineColorBlendAttachmentState> blends_;
    std::vector<VkFormat> color_formats_;
    VkPipelineVertexInputStateCreateInfo vertex_input_{
        VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    VkPipelineInputAssemblyStateCreateInfo assembly_{
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    VkPipelineViewportStateCreateInfo viewport_{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    VkPipelineRasterizationStateCreateInfo raster_{
        VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    VkPipelineMultisampleStateCreateInfo samples_{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    VkPipelineDepthStencilStateCreateInfo depth_{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    VkPipelineColorBlendStateCreateInfo blend_{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    VkPipelineDynamicStateCreateInfo dynamic_{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
    VkPipelineRenderingCreateInfo rendering_{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
};

}  // namespace weft::vk
