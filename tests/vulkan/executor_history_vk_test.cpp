// Purpose: tests persistent resources: histories of several lengths with several kinds of access, resources
// that are kept from frame to frame, and values for the first frame.
#include <string>

#include "tests/vulkan/executor_fixture.h"
#include "tests/vulkan/make_ring.h"
#include "weft/check/check_plan.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

constexpr uint32_t kHistoryFrames = 9;
constexpr uint32_t kFirst = 7;
constexpr std::array<float, 4> kFirstFrame{kFirst, 0, 0, 0};

// GLSL code that computes the value of a frame: 3 × the value of an earlier frame, plus 1. Before such a
// frame exists, it is 3 × kFirst, without the 1. with_at() replaces AT by the coordinates of the texel.
constexpr const char* kNext = "texelFetch(src, ivec2(AT), 0).r * 3u + params.srcValid";

uint32_t next(uint32_t before, bool valid) {
    return before * 3 + (valid ? 1 : 0);
}

std::string with_at(std::string text, const std::string& at) {
    return text.replace(text.find("AT"), 2, at);
}

class ExecutorHistoryVk : public ExecutorTest, public testing::WithParamInterface<uint32_t> {
 protected:
    void SetUp() override {
        ExecutorTest::SetUp();
        write_shader("next.comp", R"(
            layout(local_size_x = 4, local_size_y = 4) in;
            layout(push_constant) uniform Params { uint srcValid; } params;
            uniform usampler2D src;
            layout(r32ui) uniform writeonly uimage2D dst;
            void main() { imageStore(dst, ivec2(gl_GlobalInvocationID.xy), uvec4()" +
                                      with_at(kNext, "gl_GlobalInvocationID.xy") + ")); }");
        write_shader("next.frag", R"(
            uniform Params { uint srcValid; } params;
            uniform usampler2D src;
            layout(location = 0) out uint dst;
            void main() { dst = )" + with_at(kNext, "gl_FragCoord.xy") +
                                      "; }");
    }

    // Adds the pass "next", which computes the image "state" from "state[-N]" for a history of N frames. No
    // pass reads the versions between them.
    void add_next(GraphBuilder& builder, PassKind kind, uint32_t history) {
        ResourceId state = builder.image("state", Format::r32u, 4);
        ResourceId oldest = state;
        for (uint32_t age = 1; age <= history; ++age)
            oldest = builder.image("state[-" + std::to_string(age) + "]", Format::r32u, 4);
        const bool compute = kind == PassKind::compute;
        PassDecl& pass =
            builder.pass("next", kind,
                         {{"src", oldest, Access::sampled_read, {}, kNoId},
                          {"dst", state, compute ? Access::storage_write : Access::color_write, {}, kNoId}});
        use_shader(pass, compute ? "next.comp" : "next.frag",
                   compute ? ProgramKind::compute : ProgramKind::fullscreen);
        if (compute) pass.groups = {1, 1, 1};
        ParamWrite valid;
        valid.member = "srcValid";
        valid.scalar = ScalarType::u32;
        valid.builtin = Builtin::valid;
        pass.params = {valid};
        builder.pass("read", PassKind::readback, {{"src", state, Access::copy_read, {}, kNoId}});
    }

    FramePlan plan_of(ResolvedGraph graph) {
        for (PassDecl& pass : graph.passes)
            for (ParamWrite& write : pass.params)
                if (write.builtin == Builtin::valid) write.resource = pass.uses[0].resource;
        FramePlan plan = compile(graph, query_memory_needs(device(), graph), {});
        const Diagnostics faults = check_plan(plan);
        EXPECT_TRUE(faults.empty()) << to_text(faults);
        return plan;
    }

    void expect_numbers(FramePlan plan, uint32_t history) {
        const auto executor = executor_for(input_for(std::move(plan)));
        ASSERT_NE(executor, nullptr);
        // The number of the first frame may be any number. The validity of a history depends only on how many
        // frames have run.
        FrameInput first;
        first.frame_index = 100;
        const std::vector<ReadbackData> read = run_frames(*executor, kHistoryFrames, first);
        ASSERT_EQ(read.size(), kHistoryFrames);
        std::vector<uint32_t> expected;
        for (uint32_t frame = 0; frame < kHistoryFrames; ++frame) {
            const bool valid = frame >= history;
            expected.push_back(next(valid ? expected[frame - history] : kFirst, valid));
            EXPECT_EQ(values_of<uint32_t>(read[frame]), std::vector<uint32_t>(16, expected[frame]))
                << "frame " << frame;
        }
    }
};

TEST_P(ExecutorHistoryVk, images_of_earlier_frames_are_sampled_by_compute) {
    GraphBuilder builder;
    add_next(builder, PassKind::compute, GetParam());
    ResolvedGraph graph = builder.build();
    test::make_ring(graph, "state", GetParam(), kFirstFrame);
    expect_numbers(plan_of(std::move(graph)), GetParam());
}

TEST_P(ExecutorHistoryVk, attachments_of_earlier_frames_are_sampled_by_fragments) {
    GraphBuilder builder;
    add_next(builder, PassKind::fullscreen, GetParam());
    ResolvedGraph graph = builder.build();
    test::make_ring(graph, "state", GetParam(), kFirstFrame);
    expect_numbers(plan_of(std::move(graph)), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Lengths, ExecutorHistoryVk, testing::Values(1u, 2u, 3u),
                         [](const auto& length) { return "history_" + std::to_string(length.param); });

using ExecutorKeptVk = ExecutorHistoryVk;

// Copy, clear and readback passes must also use the element of the ring that belongs to the current frame.
// The initial values of the rings are 9 (words) and 0.25 (depth).
TEST_F(ExecutorKeptVk, copies_and_clears_follow_the_ring) {
    GraphBuilder builder;
    const ResourceId words = builder.buffer("words", 16);
    const ResourceId old_words = builder.buffer("words[-1]", 16);
    const ResourceId older_words = builder.buffer("words[-2]", 16);
    const ResourceId depth = builder.image("depth", Format::d32f, 2);
    const ResourceId old_depth = builder.image("depth[-1]", Format::d32f, 2);
    builder.pass(
        "copy_words", PassKind::copy,
        {{"src", older_words, Access::copy_read, {}, kNoId}, {"dst", words, Access::copy_write, {}, kNoId}});
    builder.pass("clear_depth", PassKind::clear, {{"dst", depth, Access::clear_write, {}, kNoId}}).clear = {
        0.75f, 0, 0, 0};
    builder.pass("read_depth", PassKind::readback, {{"src", old_depth, Access::copy_read, {}, kNoId}});
    builder.pass("read_words", PassKind::readback, {{"src", words, Access::copy_read, {}, kNoId}});
    builder.pass("read_words_before", PassKind::readback, {{"src", old_words, Access::copy_read, {}, kNoId}});
    ResolvedGraph graph = builder.build();
    test::make_ring(graph, "words", 2, {9, 0, 0, 0});
    test::make_ring(graph, "depth", 1, {0.25f, 0, 0, 0});
    const auto executor = executor_for(input_for(plan_of(std::move(graph))));
    ASSERT_NE(executor, nullptr);
    const std::vector<ReadbackData> read = run_frames(*executor, kHistoryFrames);
    ASSERT_EQ(read.size(), size_t{3} * kHistoryFrames);
    for (const ReadbackData& data : read) {
        if (data.pass == "read_depth")
            EXPECT_EQ(values_of<float>(data), std::vector<float>(4, data.frame_index == 0 ? 0.25f : 0.75f));
        else
            EXPECT_EQ(values_of<uint32_t>(data), std::vector<uint32_t>(4, 9)) << data.pass;
    }
}

TEST_F(ExecutorKeptVk, a_kept_buffer_is_counted_up_in_place) {
    write_shader("count.comp", R"(
        layout(local_size_x = 4) in;
        buffer Words { uint word[]; } words;
        void main() { words.word[gl_GlobalInvocationID.x] += 2u; })");
    GraphBuilder builder;
    const ResourceId words = builder.buffer("words", 16);
    PassDecl& count = builder.compute("count", {{"words", words, Access::storage_read_write, {}, kNoId}});
    use_shader(count, "count.comp", ProgramKind::compute);
    count.groups = {1, 1, 1};
    builder.pass("read", PassKind::readback, {{"src", words, Access::copy_read, {}, kNoId}});
    ResolvedGraph graph = builder.build();
    test::make_ring(graph, "words", 0, {5, 0, 0, 0});
    const FramePlan plan = plan_of(std::move(graph));
    for (uint32_t life = 0; life < 2; ++life) {
        const auto executor = executor_for(input_for(plan));
        ASSERT_NE(executor, nullptr);
        EXPECT_EQ(executor->transient_bytes(), 0u);
        const std::vector<ReadbackData> read = run_frames(*executor, kHistoryFrames);
        ASSERT_EQ(read.size(), kHistoryFrames);
        for (uint32_t frame = 0; frame < kHistoryFrames; ++frame)
            EXPECT_EQ(values_of<uint32_t>(read[frame]), std::vector<uint32_t>(4, 5 + 2 * (frame + 1)));
    }
}

}  // namespace
}  // namespace weft::vk
