// Purpose: tests that a draw list of the program may bind a pipeline of its own, and that Weft's pipeline is
// bound again for the next list of the pass.
#include "tests/render/engine/engine_fixture.h"
#include "tests/render/engine/triangle_list.h"
#include "vulkan/device/handle.h"
#include "weft/shader/compile_shader.h"

namespace weft::test {
namespace {

// Fills the left quarter of the picture with red, with a pipeline for the attachments of the pass, whose
// viewport and scissor are static.
class FillList final : public render::DrawList {
 public:
    explicit FillList(vk::Device& device) : device_(device) {}

    uint32_t record(const vk::DrawContext& draw, const render::DrawView&) const override {
        if (!pipeline_) make(draw.targets);
        draw.fn->vkCmdBindPipeline(draw.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
        draw.fn->vkCmdDraw(draw.commands, 6, 1, 0, 0);
        return 0;
    }

 private:
    vk::ShaderModuleHandle module_of(const ShaderModule& code) const {
        VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
        info.codeSize = code.spirv.size() * sizeof(uint32_t);
        info.pCode = code.spirv.data();
        VkShaderModule module = VK_NULL_HANDLE;
        EXPECT_EQ(device_.fn().vkCreateShaderModule(device_.handle(), &info, nullptr, &module), VK_SUCCESS);
        return {device_, module};
    }

    void make(const vk::DrawTargets& targets) const {
        ShaderRoots roots;
        roots.roots = {WEFT_SOURCE_DIR "/tests/render/engine"};
        roots.include_root = WEFT_SOURCE_DIR "/shaders/include";
        const Result<ShaderProgram> program = compile_shader("fill", ProgramKind::raster, roots);
        ASSERT_TRUE(program) << to_text(program.errors());
        std::vector<vk::ShaderModuleHandle> modules;
        std::vector<VkPipelineShaderStageCreateInfo> stages;
        for (const ShaderModule& code : program->modules) {
            modules.push_back(module_of(code));
            VkPipelineShaderStageCreateInfo stage{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
            stage.stage =
                code.stage == ShaderStage::vertex ? VK_SHADER_STAGE_VERTEX_BIT : VK_SHADER_STAGE_FRAGMENT_BIT;
            stage.module = modules.back().get();
            stage.pName = "main";
            stages.push_back(stage);
        }
        VkPipelineLayoutCreateInfo layout_info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
        VkPipelineLayout layout = VK_NULL_HANDLE;
        EXPECT_EQ(device_.fn().vkCreatePipelineLayout(device_.handle(), &layout_info, nullptr, &layout),
                  VK_SUCCESS);
        layout_ = {device_, layout};
        create(targets, stages);
    }

    void create(const vk::DrawTargets& targets,
                const std::vector<VkPipelineShaderStageCreateInfo>& stages) const {
        VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
        rendering.viewMask = targets.view_mask;
        rendering.colorAttachmentCount = targets.color_count;
        rendering.pColorAttachmentFormats = targets.colors.data();
        rendering.depthAttachmentFormat = targets.depth;
        rendering.stencilAttachmentFormat = targets.stencil;
        VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
        VkPipelineInputAssemblyStateCreateInfo assembly{
            VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
        assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
        // Other than those of the pass: with this static state, the draws of other lists would be wrong.
        const VkRect2D scissor{{0, 0}, {targets.extent.width / 2, targets.extent.height}};
        const VkViewport viewport{
            0, 0, static_cast<float>(scissor.extent.width), static_cast<float>(scissor.extent.height), 0, 1};
        VkPipelineViewportStateCreateInfo view{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
        view.viewportCount = view.scissorCount = 1;
        view.pViewports = &viewport;
        view.pScissors = &scissor;
        VkPipelineRasterizationStateCreateInfo raster{
            VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
        raster.lineWidth = 1;
        VkPipelineMultisampleStateCreateInfo samples{
            VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
        samples.rasterizationSamples = targets.samples;
        VkPipelineDepthStencilStateCreateInfo depth{
            VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
        VkPipelineColorBlendAttachmentState attachment{};
        attachment.colorWriteMask = 0xF;
        VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
        blend.attachmentCount = 1;
        blend.pAttachments = &attachment;
        VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
        info.pNext = &rendering;
        info.stageCount = static_cast<uint32_t>(stages.size());
        info.pStages = stages.data();
        info.pVertexInputState = &input;
        info.pInputAssemblyState = &assembly;
        info.pViewportState = &view;
        info.pRasterizationState = &raster;
        info.pMultisampleState = &samples;
        info.pDepthStencilState = &depth;
        info.pColorBlendState = &blend;
        info.layout = layout_.get();
        VkPipeline pipeline = VK_NULL_HANDLE;
        EXPECT_EQ(device_.fn().vkCreateGraphicsPipelines(device_.handle(), VK_NULL_HANDLE, 1, &info, nullptr,
                                                         &pipeline),
                  VK_SUCCESS);
        pipeline_ = {device_, pipeline};
    }

    vk::Device& device_;
    mutable vk::PipelineLayoutHandle layout_;
    mutable vk::PipelineHandle pipeline_;
};

const std::string kTwoLists = WEFT_SOURCE_DIR "/tests/render/engine/two_lists.json";

class OwnPipeline : public EngineTest {
 protected:
    static void expect_fill_and_triangle(const EngineFrame& frame) {
        const std::vector<glm::vec4> drawn = render::decode_texels(Format::rgba8, frame.images.at("drawn"));
        const size_t middle = kEngineSize.height / 2 * kEngineSize.width;
        EXPECT_EQ(drawn[middle + 1], glm::vec4(1, 0, 0, 1));
        EXPECT_LT(glm::length(drawn[middle + kEngineSize.width / 2] - TriangleList::kTint), 0.01f);
        EXPECT_EQ(drawn[middle + kEngineSize.width - 2], glm::vec4(0));
    }
    render::SessionInput input_with(const std::string& graph, const FillList& fill,
                                    const TriangleList& triangle) {
        render::SessionInput input = input_for(graph, {"drawn"});
        const VertexFormat vertices{{16}, {{"corner", Format::rgba32f, 0, 0}}};
        input.draw_lists["fills"] = {&fill, vertices};
        input.draw_lists["triangles"] = {&triangle, vertices};
        const OfferedBinding paint{2,  0,    BindingKind::uniform_buffer, stage_bit(ShaderStage::fragment),
                                   16, false};
        input.draw_sets[2] = {triangle.layout(), {paint}};
        return input;
    }
};

TEST_F(OwnPipeline, TheNextListHasThePipelineOfThePassAgain) {
    const FillList fill(*device_);
    const TriangleList triangle(*device_, 0.5f);
    const auto session = open(scene::Scene{}, input_with(kTwoLists, fill, triangle));
    ASSERT_TRUE(session);
    frame_of(*session).camera.transform = moved(0, 0, 2);
    for (int i = 0; i < 3; ++i) expect_fill_and_triangle(render_one(*session));
}

// Between the two passes, no rendering scope ends and begins.
TEST_F(OwnPipeline, TheNextPassInTheScopeHasItsOwnState) {
    const FillList fill(*device_);
    const TriangleList triangle(*device_, 0.5f);
    render::SessionInput input = input_with(kTwoLists, fill, triangle);
    input.load.reader = [](const std::string& file) {
        return file != kTwoLists ? read_text(file) : std::optional(R"({ "version": 1, "name": "two passes",
  "imports": { "fills": "drawlist", "triangles": "drawlist" },
  "resources": { "drawn": "rgba8", "depth": "d32f" },
  "passes": {
    "a": { "type": "raster", "draws": ["fills"], "shader": "own", "out": { "color": "drawn" }, "depth": "depth" },
    "b": { "type": "raster", "draws": ["triangles"], "shader": "own", "out": { "color": "drawn" },
           "depth": "depth", "after": ["a"] } } })");
    };
    const auto session = open(scene::Scene{}, input);
    ASSERT_TRUE(session);
    EXPECT_TRUE(session->plan().barriers.steps.at(1).merges_render_pass);
    frame_of(*session).camera.transform = moved(0, 0, 2);
    for (int i = 0; i < 2; ++i) expect_fill_and_triangle(render_one(*session));
}

// One pass that draws all faces of a cube gives the same picture as six passes. With multiview, the lists
// learn which views their draws draw, and a pipeline of their own can draw all of them.
TEST_F(OwnPipeline, OnePassDrawsTheListsToAllViews) {
    const std::string path = WEFT_SOURCE_DIR "/tests/render/engine/views.json";
    const auto draw = [&](const std::string& lowering, const std::string& lists, uint32_t view_mask) {
        const FillList fill(*device_);
        const TriangleList triangle(*device_, 0.5f);
        render::SessionInput input = input_with(path, fill, triangle);
        input.load.reader = [&](const std::string& file) {
            return file != path ? read_text(file) : std::optional(R"({ "version": 1, "name": "views",
  "imports": { "fills": "drawlist", "triangles": "drawlist" },
  "views": { "probe": { "cube": { "at": [0, 0, 2], "near": 0.01 } } },
  "resources": { "drawn": { "format": "rgba8", "cube": 16 }, "depth": { "format": "d32f", "cube": 16 } },
  "passes": { "draw": { "type": "raster", "draws": [)" + lists + R"(], "shader": "own", "views": "probe",
    "lowering": ")" + lowering + R"(", "out": { "color": "drawn" }, "depth": "depth" } } })");
        };
        const auto session = open(scene::Scene{}, input);
        if (!session) return std::vector<std::byte>{};
        std::vector<std::byte> drawn = render_one(*session).images.at("drawn");
        EXPECT_TRUE(std::ranges::find(drawn, std::byte{191}) != drawn.end())
            << "no triangle, lowering " << lowering;
        EXPECT_EQ(triangle.targets.view_mask, view_mask) << lowering;
        EXPECT_EQ(triangle.views, view_mask == 0 ? 0u : 6u) << lowering;
        return drawn;
    };
    const std::string own = R"("triangles")", both = R"("fills", "triangles")";
    if (device_->profile().max_output_layers >= 6) {
        EXPECT_EQ(draw("layerOutput", own, 0), draw("passes", own, 0));
    }
    if (device_->profile().max_multiview_views < 6) return;
    EXPECT_EQ(draw("multiview", both, 0x3F), draw("passes", both, 0));
}

}  // namespace
}  // namespace weft::test
