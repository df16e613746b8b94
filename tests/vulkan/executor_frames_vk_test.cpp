// Purpose: tests several frames in flight, an imported image that the test reads between frames, and the
// validation messages when a barrier is missing.
#include <algorithm>

#include "tests/vulkan/executor_fixture.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

constexpr AccessState kRead{stage::kCopy, access::kTransferRead, Layout::transfer_src};

constexpr const char* kCount = R"(
layout(location = 0) out uint dst;
layout(push_constant) uniform Params { uint frame; } params;
void main() { dst = params.frame; })";

constexpr const char* kPassOn = R"(
uniform usampler2D src;
layout(location = 0) out uint dst;
void main() { dst = texelFetch(src, ivec2(gl_FragCoord.xy), 0).r + 1u; })";

class ImportedOutputVk : public ExecutorTest {
 protected:
    // Makes a plan with two passes. "count" draws the frame's number into a transient image. "pass_on" writes
    // this number plus one to the imported image "output".
    FramePlan make_plan() {
        write_shader("count.frag", kCount);
        write_shader("pass_on.frag", kPassOn);
        GraphBuilder builder;
        const ResourceId number = builder.image("number", Format::r32u, 4);
        const ResourceId output = builder.image("output", Format::r32u, 4);
        builder.import_as(output, {stage::kCopy, access::kTransferRead, Layout::undefined}, kRead);
        builder.set_output(output);
        PassDecl& count =
            builder.pass("count", PassKind::fullscreen, {{"dst", number, Access::color_write, {}, kNoId}});
        use_shader(count, "count.frag", ProgramKind::fullscreen);
        ParamWrite frame;
        frame.member = "frame";
        frame.scalar = ScalarType::u32;
        frame.builtin = Builtin::frame_index;
        count.params = {frame};
        use_shader(builder.pass("pass_on", PassKind::fullscreen,
                                {{"src", number, Access::sampled_read, {}, kNoId},
                                 {"dst", output, Access::color_write, {}, kNoId}}),
                   "pass_on.frag", ProgramKind::fullscreen);
        return compile_plan(builder);
    }

    static Image make_output(Device& device, const FramePlan& plan) {
        ResourceDecl decl = plan.graph.resources[find_resource(plan.graph, "output")];
        decl.usage |= usage::kTransferSrc;
        Result<Image> image = Image::create(device, decl);
        EXPECT_TRUE(image.ok());
        return std::move(*image);
    }
};

TEST_F(ImportedOutputVk, is_read_in_its_exit_state_after_any_number_of_frames) {
    FramePlan plan = make_plan();
    const Image output = make_output(device(), plan);
    ExecutorInput input = input_for(std::move(plan));
    input.bindings.images.emplace("output", &output);
    const auto executor = executor_for(std::move(input));
    ASSERT_NE(executor, nullptr);
    for (const uint32_t frames : {1u, 2u, 5u}) {
        FrameInput first;
        first.frame_index = 10 * frames;
        EXPECT_TRUE(run_frames(*executor, frames, first).empty());
        const Result<ReadbackData> image = executor->read_image(output);
        ASSERT_TRUE(image.ok()) << to_text(image.errors());
        EXPECT_EQ(values_of<uint32_t>(*image), std::vector<uint32_t>(16, 10 * frames + frames));
    }
}

// Without its barrier, "pass_on" samples an attachment in the wrong layout. The validation layer can detect
// this and must name the pass.
TEST_F(ImportedOutputVk, a_dropped_barrier_is_heard_and_names_its_pass) {
    {
        FramePlan plan = make_plan();
        const Image output = make_output(device(), plan);
        ExecutorInput input = input_for(std::move(plan));
        input.bindings.images.emplace("output", &output);
        input.timestamps = false;
        const std::vector<PassId>& order = input.plan.schedule.order;
        for (Position position(0); position < order.size(); ++position)
            if (input.plan.graph.passes[order[position]].name == "pass_on")
                input.hooks.drop_barriers_of_position = position;
        const auto executor = executor_for(std::move(input));
        ASSERT_NE(executor, nullptr);
        static_cast<void>(run_frames(*executor, 2));
        for (const FrameTiming& timing : executor->take_timings())
            for (const PassTiming& pass : timing.passes) EXPECT_LT(pass.gpu_ms, 0) << "timestamps are off";
    }
    const std::vector<Message> messages = destroy_device(take_device());
    ASSERT_FALSE(messages.empty());
    EXPECT_TRUE(std::any_of(messages.begin(), messages.end(),
                            [](const Message& message) { return message.pass == "pass_on"; }));
}

TEST_F(ImportedOutputVk, slots_alternate_and_every_frame_is_timed_once) {
    FramePlan plan = make_plan();
    const Image output = make_output(device(), plan);
    ExecutorInput input = input_for(std::move(plan));
    input.bindings.images.emplace("output", &output);
    const auto executor = executor_for(std::move(input));
    ASSERT_NE(executor, nullptr);
    for (uint32_t i = 0; i < 5; ++i) {
        const Result<uint32_t> slot = executor->begin_frame();
        ASSERT_TRUE(slot.ok());
        EXPECT_EQ(*slot, i % kFramesInFlight);
        ASSERT_TRUE(executor->run({}).ok());
    }
    EXPECT_EQ(executor->take_timings().size(), 5 - kFramesInFlight)
        << "begin_frame() completes a slot's frame";
    ASSERT_TRUE(executor->finish().ok());
    const std::vector<FrameTiming> timings = executor->take_timings();
    ASSERT_EQ(timings.size(), kFramesInFlight);
    for (const FrameTiming& timing : timings) {
        ASSERT_EQ(timing.passes.size(), 2u);
        EXPECT_EQ(timing.passes[0].pass, "count");
        EXPECT_EQ(timing.passes[1].pass, "pass_on");
        for (const PassTiming& pass : timing.passes) EXPECT_GE(pass.gpu_ms, 0);
        EXPECT_GT(timing.record_ms, 0);
    }
    EXPECT_TRUE(executor->take_timings().empty());
}

}  // namespace
}  // namespace weft::vk
