// Purpose: tests passes in C++ that record Vulkan commands of their own: the objects of their ports,
// rendering to their attachments, and that the passes after them do not depend on the state that they leave
// behind.
#include "tests/vulkan/executor_fixture.h"
#include "tests/vulkan/raw_pass_objects.h"
#include "vulkan/device/functions.h"
#include "weft/vulkan/raw_pass.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

constexpr uint32_t kRawFrames = 5;
constexpr uint32_t kSide_px = 8;
constexpr uint32_t kRawWords = 64;

void bind_words(OwnObjects& own, const RawPort& words) {
    const VkDescriptorBufferInfo buffer{words.buffer, words.offset_bytes, words.size_bytes};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = own.set;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    write.pBufferInfo = &buffer;
    own.device.fn().vkUpdateDescriptorSets(own.device.handle(), 1, &write, 0, nullptr);
}

// Copies an image, writes a storage buffer with a pipeline of its own, and clears a colour attachment. At the
// end, it sets dynamic state that would spoil the next pass.
struct MixPass {
    static constexpr std::string_view kType = "mix";
    static constexpr std::array<PortDecl, 4> kPorts{
        In{"src", Access::copy_read}, Out{"dst", Access::copy_write},
        Out{"words", Access::storage_write, stage_bit(ShaderStage::compute)},
        Out{"color", Access::color_write}};
    static constexpr std::array<ParamDecl, 0> kParams{};
    static Status check(const PassDecl&, const ResolvedGraph&) { return Unit{}; }
    static void prepare(const PassContext&, const HostInputs&, Uploads&) {}
    static void record(const PassContext&, Recorder& recorder) {
        const RawCommands& raw = raw_commands(recorder);
        OwnObjects& own = **raw.host->get<OwnObjects*>("own");
        const DeviceFunctions& fn = own.device.fn();
        const RawPort &src = raw.in("src"), &dst = raw.out("dst"), &words = raw.out("words");
        EXPECT_TRUE(src.image != VK_NULL_HANDLE && src.view == VK_NULL_HANDLE &&
                    src.buffer == VK_NULL_HANDLE);
        EXPECT_EQ(src.format, VK_FORMAT_R32_UINT);
        EXPECT_EQ(src.extent.width, kSide_px);
        EXPECT_EQ(words.size_bytes, kRawWords * sizeof(uint32_t));
        EXPECT_EQ(raw.ports.size(), 4u);
        EXPECT_EQ(raw.frame_slot, raw.frame_index % kFramesInFlight);
        VkImageCopy copy{};
        copy.srcSubresource = {src.range.aspectMask, src.range.baseMipLevel, 0, 1};
        copy.dstSubresource = {dst.range.aspectMask, dst.range.baseMipLevel, 0, 1};
        copy.extent = src.extent;
        fn.vkCmdCopyImage(raw.commands, src.image, src.layout, dst.image, dst.layout, 1, &copy);
        fn.vkCmdBindPipeline(raw.commands, VK_PIPELINE_BIND_POINT_COMPUTE, own.pipeline.get());
        fn.vkCmdBindDescriptorSets(raw.commands, VK_PIPELINE_BIND_POINT_COMPUTE, own.layout.get(), 1, 1,
                                   &own.set, 0, nullptr);
        fn.vkCmdDispatch(raw.commands, 1, 1, 1);
        RawClear clear{"color", {}};
        clear.value.color = {{1, 0, 1, 0}};
        raw.begin_rendering({&clear, 1});
        raw.end_rendering();
        const VkViewport viewport{0, 0, 1, 1, 0, 1};
        const VkRect2D scissor{{0, 0}, {1, 1}};
        fn.vkCmdSetViewport(raw.commands, 0, 1, &viewport);
        fn.vkCmdSetScissor(raw.commands, 0, 1, &scissor);
        fn.vkCmdSetCullMode(raw.commands, VK_CULL_MODE_FRONT_AND_BACK);
    }
};

// Draws with a VkRenderPass of its own, and fills depth by dynamic rendering.
struct OwnRenderPass {
    static constexpr std::string_view kType = "own_render_pass";
    static constexpr std::array<PortDecl, 1> kPorts{Out{"color", Access::color_write}};
    static constexpr std::array<ParamDecl, 0> kParams{};
    static Status check(const PassDecl&, const ResolvedGraph&) { return Unit{}; }
    static void prepare(const PassContext&, const HostInputs&, Uploads&) {}
    static void record(const PassContext&, Recorder& recorder) {
        const RawCommands& raw = raw_commands(recorder);
        OwnObjects& own = **raw.host->get<OwnObjects*>("own");
        const RawPort& color = raw.out("color");
        // The last frame in this slot has finished, so its framebuffer is free.
        VkFramebuffer& framebuffer = own.framebuffers[raw.frame_slot];
        if (framebuffer != VK_NULL_HANDLE) own.destroy_framebuffer(raw.device, framebuffer, nullptr);
        VkFramebufferCreateInfo info{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
        info.renderPass = own.render_pass;
        info.attachmentCount = 1;
        info.pAttachments = &color.view;
        info.width = color.extent.width;
        info.height = color.extent.height;
        info.layers = 1;
        ASSERT_EQ(own.create_framebuffer(raw.device, &info, nullptr, &framebuffer), VK_SUCCESS);
        VkClearValue clear{};
        clear.color = {{0, 1, 0, 1}};
        VkRenderPassBeginInfo begin{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
        begin.renderPass = own.render_pass;
        begin.framebuffer = framebuffer;
        begin.renderArea.extent = {color.extent.width, color.extent.height};
        begin.clearValueCount = 1;
        begin.pClearValues = &clear;
        own.begin_render_pass(raw.commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
        own.end_render_pass(raw.commands);
    }
};

// Clears depth to a value, and keeps the content of a colour attachment.
struct DepthPass {
    static constexpr std::string_view kType = "depth";
    static constexpr std::array<PortDecl, 2> kPorts{Out{"color", Access::color_read_write},
                                                    Out{"depth", Access::depth_write}};
    static constexpr std::array<ParamDecl, 0> kParams{};
    static Status check(const PassDecl&, const ResolvedGraph&) { return Unit{}; }
    static void prepare(const PassContext&, const HostInputs&, Uploads&) {}
    static void record(const PassContext&, Recorder& recorder) {
        const RawCommands& raw = raw_commands(recorder);
        RawClear clear{"depth", {}};
        clear.value.depthStencil = {0.25F, 0};
        raw.begin_rendering({&clear, 1});
        raw.end_rendering();
    }
};

class RawPassVk : public ExecutorTest {
 protected:
    // Adds a pass in C++. The ports get the shader stages of the pass type, as in a graph of a file.
    static void add_custom(GraphBuilder& builder, const char* name, const PassType& type,
                           const std::vector<test::BuilderUse>& uses) {
        PassDecl& pass = builder.pass(name, PassKind::custom, uses);
        pass.type = type.name;
        pass.colors.clear();
        pass.depth.reset();
        for (UseDecl& use : pass.uses)
            for (const PortDecl& port : type.ports)
                if (port.name == use.port && use.access == Access::storage_write)
                    use.state = access_state(use.access, port.stages, aspect::kNone);
    }

    // "fill" writes the frame index, the raw pass copies it, and "after" doubles what the raw pass has
    // copied.
    FramePlan make_mix_plan() {
        write_shader("fill.comp", R"(
            layout(local_size_x = 8, local_size_y = 8) in;
            layout(r32ui) uniform writeonly uimage2D dst;
            layout(push_constant) uniform Params { uint frame; } params;
            void main() { imageStore(dst, ivec2(gl_GlobalInvocationID.xy), uvec4(params.frame)); })");
        write_shader("twice.frag", R"(
            uniform usampler2D src;
            layout(location = 0) out uint dst;
            void main() { dst = 2u * texelFetch(src, ivec2(gl_FragCoord.xy), 0).r; })");
        GraphBuilder builder;
        const ResourceId a = builder.image("a", Format::r32u, kSide_px);
        const ResourceId b = builder.image("b", Format::r32u, kSide_px);
        const ResourceId c = builder.image("c", Format::r32u, kSide_px);
        const ResourceId color = builder.image("color", Format::rgba8, kSide_px);
        const ResourceId words = builder.buffer("words", kRawWords * sizeof(uint32_t));
        PassDecl& fill = builder.compute("fill", {{"dst", a, Access::storage_write, {}, kNoId}});
        use_shader(fill, "fill.comp", ProgramKind::compute);
        ParamWrite frame;
        frame.member = "frame";
        frame.scalar = ScalarType::u32;
        frame.builtin = Builtin::frame_index;
        fill.params = {frame};
        add_custom(builder, "raw", pass_type<MixPass>(),
                   {{"src", a, Access::copy_read, {}, kNoId},
                    {"color", color, Access::color_write, {}, kNoId},
                    {"dst", b, Access::copy_write, {}, kNoId},
                    {"words", words, Access::storage_write, {}, kNoId}});
        use_shader(builder.pass("after", PassKind::fullscreen,
                                {{"src", b, Access::sampled_read, {}, kNoId},
                                 {"dst", c, Access::color_write, {}, kNoId}}),
                   "twice.frag", ProgramKind::fullscreen);
        builder.pass("read_c", PassKind::readback, {{"src", c, Access::copy_read, {}, kNoId}});
        builder.pass("read_color", PassKind::readback, {{"src", color, Access::copy_read, {}, kNoId}});
        builder.pass("read_words", PassKind::readback, {{"src", words, Access::copy_read, {}, kNoId}});
        return compile_plan(builder);
    }

    std::unique_ptr<OwnObjects> make_own() {
        auto own = std::make_unique<OwnObjects>(device());
        own->load("vkCreateRenderPass", own->create_render_pass);
        own->load("vkDestroyRenderPass", own->destroy_render_pass);
        own->load("vkCreateFramebuffer", own->create_framebuffer);
        own->load("vkDestroyFramebuffer", own->destroy_framebuffer);
        own->load("vkCmdBeginRenderPass", own->begin_render_pass);
        own->load("vkCmdEndRenderPass", own->end_render_pass);
        write_shader("own.comp", R"(
            layout(local_size_x = 64) in;
            layout(std430) writeonly buffer Words { uint words[]; } dst;
            void main() { dst.words[gl_GlobalInvocationID.x] = 7u * gl_GlobalInvocationID.x; })");
        GraphBuilder unused;
        use_shader(unused.compute("own", {}), "own.comp", ProgramKind::compute);
        const std::vector<uint32_t>& code = shaders_.at("own.comp").modules.front().spirv;
        VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
        info.codeSize = code.size() * sizeof(uint32_t);
        info.pCode = code.data();
        VkShaderModule module = VK_NULL_HANDLE;
        EXPECT_EQ(device().fn().vkCreateShaderModule(device().handle(), &info, nullptr, &module), VK_SUCCESS);
        make_compute_objects(*own, {device(), module});
        return own;
    }

    std::vector<ReadbackData> run_raw(Executor& executor, OwnObjects& own) {
        HostInputs host;
        OwnObjects* pointer = &own;
        host.set("own", pointer);
        FrameInput first;
        first.host = &host;
        // Binds the words once. The buffer is the same in every frame.
        const ResourceId words = find_resource(executor.plan().graph, "words");
        if (words != kNoId) {
            RawPort port;
            port.buffer = executor.native(words).buffer;
            port.size_bytes = kRawWords * sizeof(uint32_t);
            bind_words(own, port);
        }
        return run_frames(executor, kRawFrames, first);
    }
};

TEST_F(RawPassVk, commands_run_between_the_barriers_of_the_plan) {
    const std::unique_ptr<OwnObjects> own = make_own();
    const PassCatalog passes{{"mix", pass_type<MixPass>()}};
    ExecutorInput input = input_for(make_mix_plan());
    input.passes = &passes;
    const auto executor = executor_for(std::move(input));
    ASSERT_NE(executor, nullptr);
    uint32_t seen = 0;
    for (const ReadbackData& data : run_raw(*executor, *own)) {
        ++seen;
        const auto values = values_of<uint32_t>(data);
        if (data.pass == "read_words") {
            for (uint32_t i = 0; i < kRawWords; ++i) EXPECT_EQ(values[i], 7 * i);
        } else if (data.pass == "read_color") {
            EXPECT_EQ(values, std::vector<uint32_t>(kSide_px * kSide_px, 0x00FF00FF));
        } else {
            // "after" draws to all texels, although the raw pass has left a scissor of one texel.
            EXPECT_EQ(values, std::vector<uint32_t>(kSide_px * kSide_px,
                                                    2 * static_cast<uint32_t>(data.frame_index)));
        }
    }
    EXPECT_EQ(seen, 3 * kRawFrames);
}

TEST_F(RawPassVk, without_its_barriers_the_validation_layer_reports_the_pass) {
    {
        const std::unique_ptr<OwnObjects> own = make_own();
        const PassCatalog passes{{"mix", pass_type<MixPass>()}};
        ExecutorInput input = input_for(make_mix_plan());
        input.passes = &passes;
        const FramePlan& plan = input.plan;
        for (Position p(0); p < plan.schedule.order.size(); ++p)
            if (plan.graph.passes[plan.schedule.order[p]].name == "raw")
                input.hooks.drop_barriers_of_position = p;
        const auto executor = executor_for(std::move(input));
        ASSERT_NE(executor, nullptr);
        run_raw(*executor, *own);
    }
    const std::vector<Message> messages = destroy_device(take_device());
    EXPECT_TRUE(std::ranges::any_of(messages, [](const Message& m) { return m.pass == "raw"; }));
}

TEST_F(RawPassVk, a_render_pass_of_the_program_and_depth_attachments) {
    const std::unique_ptr<OwnObjects> own = make_own();
    own->render_pass = make_render_pass(*own);
    GraphBuilder builder;
    const ResourceId color = builder.image("color", Format::rgba8, kSide_px);
    const ResourceId depth = builder.image("depth", Format::d32f, kSide_px);
    add_custom(builder, "own", pass_type<OwnRenderPass>(),
               {{"color", color, Access::color_write, {}, kNoId}});
    add_custom(builder, "depth", pass_type<DepthPass>(),
               {{"color", color, Access::color_read_write, {}, kNoId},
                {"depth", depth, Access::depth_write, {}, kNoId}});
    builder.pass("read_color", PassKind::readback, {{"src", color, Access::copy_read, {}, kNoId}});
    builder.pass("read_depth", PassKind::readback, {{"src", depth, Access::copy_read, {}, kNoId}});
    const PassCatalog passes{{"own_render_pass", pass_type<OwnRenderPass>()},
                             {"depth", pass_type<DepthPass>()}};
    ExecutorInput input = input_for(compile_plan(builder));
    input.passes = &passes;
    const auto executor = executor_for(std::move(input));
    ASSERT_NE(executor, nullptr);
    const std::vector<ReadbackData> read = run_raw(*executor, *own);
    ASSERT_EQ(read.size(), 2 * kRawFrames);
    for (const ReadbackData& data : read) {
        const uint32_t wanted = data.pass == "read_color" ? 0xFF00FF00 : 0x3E800000;  // 0.25 as a float
        EXPECT_EQ(values_of<uint32_t>(data), std::vector<uint32_t>(kSide_px * kSide_px, wanted)) << data.pass;
    }
}

TEST_F(RawPassVk, an_attachment_of_several_mips_is_an_error) {
    GraphBuilder builder;
    const ResourceId color = builder.image("color", Format::rgba8, kSide_px, 2);
    add_custom(builder, "own", pass_type<OwnRenderPass>(),
               {{"color", color, Access::color_write, {}, kNoId}});
    builder.pass("read", PassKind::readback, {{"src", color, Access::copy_read, {}, kNoId}});
    const PassCatalog passes{{"own_render_pass", pass_type<OwnRenderPass>()}};
    ExecutorInput input = input_for(compile_plan(builder));
    input.passes = &passes;
    const Result<std::unique_ptr<Executor>> made = Executor::create(device(), std::move(input));
    ASSERT_FALSE(made.ok());
    ASSERT_EQ(made.errors().size(), 1u);
    EXPECT_EQ(made.errors()[0].code, "V417");
    EXPECT_NE(made.errors()[0].message.find("\"color\""), std::string::npos) << made.errors()[0].message;
    ASSERT_FALSE(made.errors()[0].help.empty());
    EXPECT_NE(made.errors()[0].help[0].find("color.mip(0)"), std::string::npos);
}

}  // namespace
}  // namespace weft::vk
