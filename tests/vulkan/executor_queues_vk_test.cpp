// Purpose: tests batches on several logical queues: their waits and signals, and failures.
#include <algorithm>

#include "tests/vulkan/executor_fixture.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/immediate_submit.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

// State of watched_submit(), which replaces vkQueueSubmit. `seen` contains the recorded calls in order. The
// call with the index `fail_at` (from 0) and all later calls fail and are not recorded.
struct Submissions {
    struct One {
        // Values of timeline semaphores that the submission waits for and signals.
        std::vector<uint64_t> waits;
        std::vector<uint64_t> signals;
        uint32_t commands = 0;
        bool fenced = false;
    };
    std::vector<One> seen;
    uint32_t fail_at = UINT32_MAX;
    PFN_vkQueueSubmit real = nullptr;
};
Submissions submissions;

VKAPI_ATTR VkResult VKAPI_CALL watched_submit(VkQueue queue, uint32_t count, const VkSubmitInfo* infos,
                                              VkFence fence) {
    if (submissions.seen.size() == submissions.fail_at) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    Submissions::One one;
    one.commands = infos->commandBufferCount;
    one.fenced = fence != VK_NULL_HANDLE;
    if (const auto* timeline = static_cast<const VkTimelineSemaphoreSubmitInfo*>(infos->pNext)) {
        const uint64_t* waits = timeline->pWaitSemaphoreValues;
        one.waits.assign(waits, waits + timeline->waitSemaphoreValueCount);
        one.signals.assign(timeline->pSignalSemaphoreValues,
                           timeline->pSignalSemaphoreValues + timeline->signalSemaphoreValueCount);
    }
    submissions.seen.push_back(one);
    return submissions.real(queue, count, infos, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL never_reached(VkDevice, const VkSemaphoreWaitInfo*, uint64_t) {
    return VK_TIMEOUT;
}

class ExecutorQueuesVk : public ExecutorTest {
 protected:
    // Makes a plan for one or two queues. With two queues, the passes "fill" and "read" are on the first
    // queue, and the pass "twice" between them is on the second queue.
    FramePlan make_plan(uint32_t queues) {
        write_shader("fill.comp", R"(
            layout(local_size_x = 8, local_size_y = 8) in;
            layout(r32ui) uniform writeonly uimage2D dst;
            layout(push_constant) uniform Params { uint frame; } params;
            void main() { imageStore(dst, ivec2(gl_GlobalInvocationID.xy), uvec4(params.frame)); })");
        write_shader("twice.comp", R"(
            layout(local_size_x = 8, local_size_y = 8) in;
            uniform usampler2D src;
            layout(r32ui) uniform writeonly uimage2D dst;
            void main() {
                ivec2 at = ivec2(gl_GlobalInvocationID.xy);
                imageStore(dst, at, 2u * texelFetch(src, at, 0));
            })");
        GraphBuilder builder;
        const ResourceId a = builder.image("a", Format::r32u, 8);
        const ResourceId b = builder.image("b", Format::r32u, 8);
        PassDecl& fill = builder.compute("fill", {{"dst", a, Access::storage_write, {}, kNoId}});
        fill.groups = {1, 1, 1};
        use_shader(fill, "fill.comp", ProgramKind::compute);
        ParamWrite frame;
        frame.member = "frame";
        frame.scalar = ScalarType::u32;
        frame.builtin = Builtin::frame_index;
        fill.params = {frame};
        PassDecl& twice = builder.compute("twice", {{"src", a, Access::sampled_read, {}, kNoId},
                                                    {"dst", b, Access::storage_write, {}, kNoId}});
        twice.groups = {1, 1, 1};
        twice.queue = QueueKind::compute;
        use_shader(twice, "twice.comp", ProgramKind::compute);
        builder.pass("read", PassKind::readback, {{"src", b, Access::copy_read, {}, kNoId}});
        const ResolvedGraph graph = builder.build();
        CompileOptions options;
        options.queues = logical_queues(device().profile(), queues);
        return compile(graph, query_memory_needs(device(), graph), options);
    }

    void watch_submissions() {
        submissions = {};
        submissions.real = std::exchange(device().fn().vkQueueSubmit, watched_submit);
    }
    void unwatch_submissions() { device().fn().vkQueueSubmit = submissions.real; }
};

void expect_twice_the_frame(const std::vector<ReadbackData>& read, uint32_t frames) {
    ASSERT_EQ(read.size(), frames);
    for (uint32_t i = 0; i < frames; ++i)
        EXPECT_EQ(values_of<uint32_t>(read[i]), std::vector<uint32_t>(64, 2 * i)) << "frame " << i;
}

TEST_F(ExecutorQueuesVk, one_queue_is_one_submission_with_a_fence) {
    const auto executor = executor_for(input_for(make_plan(1)));
    ASSERT_NE(executor, nullptr);
    watch_submissions();
    const std::vector<ReadbackData> read = run_frames(*executor, 3);
    unwatch_submissions();
    expect_twice_the_frame(read, 3);
    ASSERT_EQ(submissions.seen.size(), 3u);
    for (const Submissions::One& one : submissions.seen)
        EXPECT_TRUE(one.fenced && one.waits.empty() && one.signals.empty());
    EXPECT_EQ(submissions.seen[0].commands, 2u) << "the first frame comes with what precedes it";
    EXPECT_EQ(submissions.seen[1].commands, 1u);
}

TEST_F(ExecutorQueuesVk, batches_signal_and_await_the_values_that_plans_document) {
    const FramePlan plan = make_plan(2);
    const std::vector<Batch>& batches = plan.submissions.batches;
    ASSERT_EQ(batches.size(), 3u);
    const auto executor = executor_for(input_for(plan));
    ASSERT_NE(executor, nullptr);
    constexpr uint32_t kFrames = 5;
    watch_submissions();
    const std::vector<ReadbackData> read = run_frames(*executor, kFrames);
    unwatch_submissions();
    expect_twice_the_frame(read, kFrames);

    std::vector<uint64_t> rank, count(plan.schedule.queues.size(), 0);
    for (const Batch& batch : batches) rank.push_back(count[batch.queue]++);
    const auto value = [&](uint32_t batch, uint64_t frame) {
        return frame * count[batches[batch].queue] + 1 + rank[batch];
    };
    ASSERT_EQ(submissions.seen.size(), 1 + kFrames * batches.size());
    EXPECT_EQ(submissions.seen[0].signals, std::vector<uint64_t>{1}) << "before the first frame";
    for (uint32_t i = 0; i < kFrames * batches.size(); ++i) {
        const uint32_t batch = i % 3;
        const uint64_t frame = i / 3;
        const Submissions::One& one = submissions.seen[1 + i];
        EXPECT_EQ(one.signals, std::vector<uint64_t>{value(batch, frame)});
        EXPECT_FALSE(one.fenced);
        std::vector<uint64_t> waits;
        for (const QueueWait& wait : batches[batch].waits)
            if (frame > 0 || !wait.previous_frame)
                waits.push_back(value(wait.batch, wait.previous_frame ? frame - 1 : frame));
        // In the first frame, each batch also waits for the value 1 of a separate semaphore. The first queue
        // signals this value at the end of the work before the first frame.
        if (frame == 0) waits.push_back(1);
        EXPECT_EQ(one.waits, waits) << "frame " << frame << ", batch " << batch;
    }
}

TEST_F(ExecutorQueuesVk, a_frame_that_never_ends_on_any_queue_is_a_time_out) {
    auto executor = executor_for(input_for(make_plan(2)));
    ASSERT_NE(executor, nullptr);
    ASSERT_TRUE(executor->begin_frame().ok());
    ASSERT_TRUE(executor->run({}).ok());
    const auto wait = std::exchange(device().fn().vkWaitSemaphores, never_reached);
    const Status finished = executor->finish();
    device().fn().vkWaitSemaphores = wait;
    ASSERT_FALSE(finished.ok());
    EXPECT_EQ(finished.errors()[0].code, "V407");
    ASSERT_TRUE(immediate_submit(device(), "waiting", [](VkCommandBuffer) {}).ok());
}

TEST_F(ExecutorQueuesVk, half_a_frame_is_the_last_one_and_leaves_nothing_behind) {
    for (uint32_t fail_at = 0; fail_at < 4; ++fail_at) {
        auto executor = executor_for(input_for(make_plan(2)));
        ASSERT_NE(executor, nullptr);
        watch_submissions();
        submissions.fail_at = fail_at;
        ASSERT_TRUE(executor->begin_frame().ok());
        const Status ran = executor->run({});
        unwatch_submissions();
        ASSERT_FALSE(ran.ok());
        EXPECT_EQ(ran.errors()[0].code, "V410");
        const bool nothing_happened = fail_at == 0;
        EXPECT_EQ(executor->begin_frame().ok(), nothing_happened);
    }
}

TEST_F(ExecutorQueuesVk, passes_of_all_queues_are_timed) {
    const auto executor = executor_for(input_for(make_plan(2)));
    ASSERT_NE(executor, nullptr);
    expect_twice_the_frame(run_frames(*executor, 4), 4);
    const std::vector<FrameTiming> timings = executor->take_timings();
    ASSERT_EQ(timings.size(), 4u);
    for (const FrameTiming& timing : timings) {
        ASSERT_EQ(timing.passes.size(), 3u);
        for (const PassTiming& pass : timing.passes) EXPECT_GE(pass.gpu_ms, 0) << pass.pass;
    }
}

}  // namespace
}  // namespace weft::vk
