// Purpose: tests frames that the program orders itself: frames in command buffers of the program with
// tickets, and semaphores of the program before and after a frame.
#include <algorithm>

#include "tests/vulkan/executor_fixture.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/handle.h"
#include "vulkan/device/immediate_submit.h"
#include "vulkan/execute/program_submit.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

constexpr uint32_t kSubmitFrames = 5;

uint32_t weft_submissions = 0;
PFN_vkQueueSubmit submit_of_vulkan = nullptr;

VKAPI_ATTR VkResult VKAPI_CALL counted_submit(VkQueue queue, uint32_t count, const VkSubmitInfo* infos,
                                              VkFence fence) {
    ++weft_submissions;
    return submit_of_vulkan(queue, count, infos, fence);
}

struct SeenSubmission {
    std::vector<VkSemaphore> waits, signals;
    uint32_t commands = 0;

    [[nodiscard]] bool waits_for(VkSemaphore semaphore) const {
        return std::ranges::find(waits, semaphore) != waits.end();
    }
};
std::vector<SeenSubmission> seen_submissions;

VKAPI_ATTR VkResult VKAPI_CALL seen_submit(VkQueue queue, uint32_t count, const VkSubmitInfo* infos,
                                           VkFence fence) {
    seen_submissions.push_back(
        {{infos->pWaitSemaphores, infos->pWaitSemaphores + infos->waitSemaphoreCount},
         {infos->pSignalSemaphores, infos->pSignalSemaphores + infos->signalSemaphoreCount},
         infos->commandBufferCount});
    return submit_of_vulkan(queue, count, infos, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL overdue(VkDevice, const VkSemaphoreWaitInfo*, uint64_t) {
    return VK_TIMEOUT;
}

bool text_has(const Diagnostic& diagnostic, const char* text) {
    return diagnostic.message.find(text) != std::string::npos;
}

class ProgramSubmitVk : public ExecutorTest {
 protected:
    void SetUp() override {
        ExecutorTest::SetUp();
        timeline_ = make_semaphore(VK_SEMAPHORE_TYPE_TIMELINE);
        VkCommandPoolCreateInfo info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
        info.queueFamilyIndex = device().queue().family;
        VkCommandPool pool = VK_NULL_HANDLE;
        ASSERT_EQ(device().fn().vkCreateCommandPool(device().handle(), &info, nullptr, &pool), VK_SUCCESS);
        pool_ = {device(), pool};
    }
    void TearDown() override {
        owns_.clear();
        pool_.reset();
        timeline_.reset();
        ExecutorTest::TearDown();
    }

    SemaphoreHandle make_semaphore(VkSemaphoreType kind) {
        VkSemaphoreTypeCreateInfo type{VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO};
        type.semaphoreType = kind;
        VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
        info.pNext = &type;
        VkSemaphore semaphore = VK_NULL_HANDLE;
        EXPECT_EQ(device().fn().vkCreateSemaphore(device().handle(), &info, nullptr, &semaphore), VK_SUCCESS);
        return {device(), semaphore};
    }

    // With one queue: one batch. With two queues: "fill" and "read" on the first queue, "twice" between them
    // on the second. The readback has twice the frame index plus the word of the import "own".
    FramePlan make_plan(uint32_t queues) {
        write_shader("fill.comp", R"(
            layout(local_size_x = 8, local_size_y = 8) in;
            layout(r32ui) uniform writeonly uimage2D dst;
            layout(push_constant) uniform Params { uint frame; } params;
            void main() { imageStore(dst, ivec2(gl_GlobalInvocationID.xy), uvec4(params.frame)); })");
        write_shader("twice.comp", R"(
            layout(local_size_x = 8, local_size_y = 8) in;
            uniform usampler2D src;
            layout(std430) readonly buffer Own { uint word; } own;
            layout(r32ui) uniform writeonly uimage2D dst;
            void main() {
                ivec2 at = ivec2(gl_GlobalInvocationID.xy);
                imageStore(dst, at, own.word + 2u * texelFetch(src, at, 0));
            })");
        GraphBuilder builder;
        const ResourceId a = builder.image("a", Format::r32u, 8);
        const ResourceId b = builder.image("b", Format::r32u, 8);
        const ResourceId own = builder.buffer("own", sizeof(uint32_t));
        const AccessState copied{stage::kCopy, access::kTransferWrite, Layout::undefined};
        builder.import_as(own, copied, copied);
        builder.make_concurrent(own);
        PassDecl& fill = builder.compute("fill", {{"dst", a, Access::storage_write, {}, kNoId}});
        use_shader(fill, "fill.comp", ProgramKind::compute);
        ParamWrite frame;
        frame.member = "frame";
        frame.scalar = ScalarType::u32;
        frame.builtin = Builtin::frame_index;
        fill.params = {frame};
        PassDecl& twice = builder.compute("twice", {{"src", a, Access::sampled_read, {}, kNoId},
                                                    {"own", own, Access::storage_read, {}, kNoId},
                                                    {"dst", b, Access::storage_write, {}, kNoId}});
        twice.queue = QueueKind::compute;
        use_shader(twice, "twice.comp", ProgramKind::compute);
        builder.pass("read", PassKind::readback, {{"src", b, Access::copy_read, {}, kNoId}});
        const ResolvedGraph graph = builder.build();
        CompileOptions options;
        options.queues = logical_queues(device().profile(), queues);
        return compile(graph, query_memory_needs(device(), graph), options);
    }

    std::unique_ptr<Executor> start(FramePlan plan) {
        Result<Buffer> made = Buffer::create(
            device(), sizeof(uint32_t), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
            Buffer::Memory::device, "own");
        EXPECT_TRUE(made.ok());
        owns_.push_back(std::move(*made));
        const std::array<std::byte, sizeof(uint32_t)> zero{};
        EXPECT_TRUE(upload_buffer(device(), owns_.back(), zero).ok());
        ExecutorInput input = input_for(std::move(plan));
        input.bindings.buffers.emplace("own", owns_.back().handle());
        return executor_for(std::move(input));
    }

    VkCommandBuffer begin_commands() {
        VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
        info.commandPool = pool_.get();
        info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        info.commandBufferCount = 1;
        VkCommandBuffer commands = VK_NULL_HANDLE;
        EXPECT_EQ(device().fn().vkAllocateCommandBuffers(device().handle(), &info, &commands), VK_SUCCESS);
        VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
        EXPECT_EQ(device().fn().vkBeginCommandBuffer(commands, &begin), VK_SUCCESS);
        return commands;
    }

    // Ends and submits commands of the program. Waits for and signals semaphores that are not null.
    void end_and_submit(VkCommandBuffer commands, VkSemaphore signal, uint64_t value) {
        ASSERT_EQ(device().fn().vkEndCommandBuffer(commands), VK_SUCCESS);
        VkTimelineSemaphoreSubmitInfo values{VK_STRUCTURE_TYPE_TIMELINE_SEMAPHORE_SUBMIT_INFO};
        values.signalSemaphoreValueCount = 1;
        values.pSignalSemaphoreValues = &value;
        VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
        submit.pNext = &values;
        submit.commandBufferCount = 1;
        submit.pCommandBuffers = &commands;
        submit.signalSemaphoreCount = 1;
        submit.pSignalSemaphores = &signal;
        const PFN_vkQueueSubmit call =
            submit_of_vulkan != nullptr ? submit_of_vulkan : device().fn().vkQueueSubmit;
        ASSERT_EQ(call(device().queue().handle, 1, &submit, VK_NULL_HANDLE), VK_SUCCESS);
    }

    // Lets the program write the word of "own", and then signals a semaphore.
    void write_own(uint32_t word, VkSemaphore signal, uint64_t value) {
        const VkCommandBuffer commands = begin_commands();
        device().fn().vkCmdFillBuffer(commands, owns_.back().handle(), 0, sizeof word, word);
        end_and_submit(commands, signal, value);
    }

    void count_submissions() {
        weft_submissions = 0;
        submit_of_vulkan = std::exchange(device().fn().vkQueueSubmit, counted_submit);
    }
    void stop_counting() {
        device().fn().vkQueueSubmit = submit_of_vulkan;
        submit_of_vulkan = nullptr;
    }

    // Gives the timeline semaphore a value from the CPU.
    void signal_timeline(uint64_t value) {
        VkSemaphoreSignalInfo signal{VK_STRUCTURE_TYPE_SEMAPHORE_SIGNAL_INFO};
        signal.semaphore = timeline_.get();
        signal.value = value;
        const auto signal_semaphore = reinterpret_cast<PFN_vkSignalSemaphore>(
            device().instance_fn().vkGetDeviceProcAddr(device().handle(), "vkSignalSemaphore"));
        ASSERT_EQ(signal_semaphore(device().handle(), &signal), VK_SUCCESS);
    }

    uint64_t value_of(const SemaphoreHandle& semaphore) {
        uint64_t value = 0;
        EXPECT_EQ(device().fn().vkGetSemaphoreCounterValue(device().handle(), semaphore.get(), &value),
                  VK_SUCCESS);
        return value;
    }

    SemaphoreHandle timeline_;
    CommandPoolHandle pool_;
    std::vector<Buffer> owns_;  // The buffer "own" of each executor.
};

void expect_frames(const std::vector<ReadbackData>& read, uint32_t frames, uint32_t word_step = 0) {
    ASSERT_EQ(read.size(), frames);
    for (uint32_t i = 0; i < frames; ++i)
        EXPECT_EQ(values_of<uint32_t>(read[i]), std::vector<uint32_t>(64, 2 * i + word_step * i))
            << "frame " << i;
}

TEST_F(ProgramSubmitVk, frames_go_into_command_buffers_of_the_program) {
    const auto executor = start(make_plan(1));
    ASSERT_NE(executor, nullptr);
    count_submissions();
    for (uint32_t i = 0; i < kSubmitFrames; ++i) {
        ASSERT_TRUE(executor->begin_frame().ok());
        FrameInput frame;
        frame.frame_index = i;
        frame.submit.commands = begin_commands();
        frame.submit.ticket = {timeline_.get(), i + 1};
        const Status ran = executor->run(frame);
        ASSERT_TRUE(ran.ok()) << to_text(ran.errors());
        end_and_submit(frame.submit.commands, timeline_.get(), i + 1);
    }
    EXPECT_EQ(weft_submissions, 0u) << "Weft only records";
    ASSERT_TRUE(executor->finish().ok());
    stop_counting();
    expect_frames(executor->take_readbacks(), kSubmitFrames);
    EXPECT_EQ(executor->take_timings().size(), kSubmitFrames);
}

TEST_F(ProgramSubmitVk, frames_of_both_kinds_may_alternate) {
    const auto executor = start(make_plan(1));
    ASSERT_NE(executor, nullptr);
    for (uint32_t i = 0; i < 2 * kSubmitFrames; ++i) {
        ASSERT_TRUE(executor->begin_frame().ok());
        FrameInput frame;
        frame.frame_index = i;
        const bool own = i % 3 != 1;
        if (own) frame.submit.commands = begin_commands();
        if (own) frame.submit.ticket = {timeline_.get(), i + 1};
        ASSERT_TRUE(executor->run(frame).ok());
        if (own) end_and_submit(frame.submit.commands, timeline_.get(), i + 1);
    }
    ASSERT_TRUE(executor->finish().ok());
    expect_frames(executor->take_readbacks(), 2 * kSubmitFrames);
}

TEST_F(ProgramSubmitVk, an_overdue_ticket_is_a_time_out_that_names_it) {
    auto executor = start(make_plan(1));
    ASSERT_NE(executor, nullptr);
    ASSERT_TRUE(executor->begin_frame().ok());
    FrameInput frame;
    frame.frame_index = 7;
    frame.submit.commands = begin_commands();
    frame.submit.ticket = {timeline_.get(), 40};
    ASSERT_TRUE(executor->run(frame).ok());
    const auto wait = std::exchange(device().fn().vkWaitSemaphores, overdue);
    const Status finished = executor->finish();
    device().fn().vkWaitSemaphores = wait;
    ASSERT_FALSE(finished.ok());
    EXPECT_EQ(finished.errors()[0].code, "V407");
    EXPECT_TRUE(text_has(finished.errors()[0], "frame 7") && text_has(finished.errors()[0], "ticket 40"))
        << finished.errors()[0].message;
    EXPECT_NE(finished.errors()[0].help.front().find("timeline semaphore"), std::string::npos);
    // The ticket is reached at last, so that the executor can be destroyed without leaks.
    end_and_submit(frame.submit.commands, timeline_.get(), 40);
    ASSERT_TRUE(immediate_submit(device(), "waiting", [](VkCommandBuffer) {}).ok());
    executor.reset();
    EXPECT_FALSE(device().abandoned());
}

TEST_F(ProgramSubmitVk, contradictory_wishes_are_errors_and_the_next_frame_runs) {
    const auto executor = start(make_plan(1));
    const auto several = start(make_plan(2));
    ASSERT_TRUE(executor != nullptr && several != nullptr);
    const VkCommandBuffer commands = begin_commands();
    const FrameTicket ticket{timeline_.get(), 1};
    const auto fault_of = [](Executor& with, const FrameSubmit& submit) {
        EXPECT_TRUE(with.begin_frame().ok());
        FrameInput frame;
        frame.submit = submit;
        const Status ran = with.run(frame);
        return ran.ok() ? Diagnostic{} : ran.errors()[0];
    };
    const Diagnostic batches = fault_of(*several, {commands, ticket});
    EXPECT_EQ(batches.code, "V422");
    EXPECT_TRUE(text_has(batches, "3 batches")) << batches.message;
    EXPECT_NE(batches.help.at(0).find("SessionInput::queues = 1"), std::string::npos);
    EXPECT_EQ(fault_of(*executor, {commands, {}}).code, "V423");
    EXPECT_EQ(fault_of(*executor, {VK_NULL_HANDLE, ticket}).code, "V423");
    EXPECT_EQ(fault_of(*executor, {commands, ticket, {}, {{timeline_.get(), 1}}}).code, "V423");
    ASSERT_EQ(device().fn().vkEndCommandBuffer(commands), VK_SUCCESS);
    expect_frames(run_frames(*executor, 2), 2);
    expect_frames(run_frames(*several, 2), 2);
}

class SemaphoresVk : public ProgramSubmitVk, public testing::WithParamInterface<uint32_t> {};

TEST_P(SemaphoresVk, a_frame_waits_for_a_value_and_signals_another) {
    const auto executor = start(make_plan(GetParam()));
    ASSERT_NE(executor, nullptr);
    const SemaphoreHandle done = make_semaphore(VK_SEMAPHORE_TYPE_TIMELINE);
    for (uint32_t i = 0; i < kSubmitFrames; ++i) {
        ASSERT_TRUE(executor->begin_frame().ok());
        FrameInput frame;
        frame.frame_index = i;
        frame.submit.waits = {{timeline_.get(), i + 1}};
        frame.submit.signals = {{done.get(), i + 1}};
        ASSERT_TRUE(executor->run(frame).ok());
        // The frame cannot have finished, because nothing has signalled the value yet.
        EXPECT_EQ(value_of(done), i);
        signal_timeline(i + 1);
        const VkSemaphore semaphore = done.get();
        const uint64_t value = i + 1;
        VkSemaphoreWaitInfo wait{VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO};
        wait.semaphoreCount = 1;
        wait.pSemaphores = &semaphore;
        wait.pValues = &value;
        ASSERT_EQ(device().fn().vkWaitSemaphores(device().handle(), &wait, device().timeout_ns()),
                  VK_SUCCESS);
    }
    ASSERT_TRUE(executor->finish().ok());
    expect_frames(executor->take_readbacks(), kSubmitFrames);
}

// The program writes the import before each frame, and signals a binary semaphore, for which the frame waits
// from the first use of the import on. The frame signals another binary semaphore, for which the next write
// waits.
TEST_P(SemaphoresVk, binary_semaphores_order_the_frame_and_the_program) {
    const auto executor = start(make_plan(GetParam()));
    ASSERT_NE(executor, nullptr);
    const SemaphoreHandle written = make_semaphore(VK_SEMAPHORE_TYPE_BINARY);
    for (uint32_t i = 0; i < kSubmitFrames; ++i) {
        write_own(10 * i, written.get(), 0);
        ASSERT_TRUE(executor->begin_frame().ok());
        FrameInput frame;
        frame.frame_index = i;
        frame.submit.waits = {
            {written.get(), 0, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, i % 2 == 0 ? "own" : ""}};
        ASSERT_TRUE(executor->run(frame).ok());
        ASSERT_TRUE(executor->finish().ok());
    }
    expect_frames(executor->take_readbacks(), kSubmitFrames, 10);
}

INSTANTIATE_TEST_SUITE_P(OneAndSeveralBatches, SemaphoresVk, testing::Values(1u, 2u),
                         [](const auto& queues) { return queues.param == 1 ? "one" : "several"; });

// The queues of a CPU driver run one after another, so only the submissions show what each queue waits for.
TEST_F(ProgramSubmitVk, the_first_batch_of_each_queue_waits_and_the_end_of_all_signals) {
    const auto executor = start(make_plan(2));
    ASSERT_NE(executor, nullptr);
    const SemaphoreHandle done = make_semaphore(VK_SEMAPHORE_TYPE_TIMELINE);
    (void)run_frames(*executor, 1);
    seen_submissions.clear();
    submit_of_vulkan = std::exchange(device().fn().vkQueueSubmit, seen_submit);
    ASSERT_TRUE(executor->begin_frame().ok());
    FrameInput frame;
    frame.submit.waits = {{timeline_.get(), 1}};
    frame.submit.signals = {{done.get(), 1}};
    ASSERT_TRUE(executor->run(frame).ok());
    stop_counting();
    signal_timeline(1);
    ASSERT_TRUE(executor->finish().ok());
    ASSERT_EQ(seen_submissions.size(), 5u) << "before the batches, three batches, after the batches";
    const SeenSubmission &gate = seen_submissions[0], &close = seen_submissions[4];
    EXPECT_EQ(gate.commands, 0u);
    EXPECT_EQ(gate.waits, std::vector<VkSemaphore>{timeline_.get()});
    ASSERT_EQ(gate.signals.size(), 1u);
    EXPECT_TRUE(seen_submissions[1].waits_for(gate.signals[0])) << "\"fill\" on the first queue";
    EXPECT_TRUE(seen_submissions[2].waits_for(gate.signals[0])) << "\"twice\" on the second queue";
    EXPECT_FALSE(seen_submissions[3].waits_for(gate.signals[0])) << "\"read\" comes after \"fill\"";
    EXPECT_EQ(close.commands, 0u);
    EXPECT_EQ(close.signals, std::vector<VkSemaphore>{done.get()});
    EXPECT_EQ(close.waits.size(), 2u) << "the ends of both queues";
}

TEST_F(ProgramSubmitVk, the_batch_that_first_uses_an_import_waits_for_its_semaphore) {
    const FramePlan plan = make_plan(2);
    ASSERT_EQ(plan.submissions.batches.size(), 3u);
    const std::vector<SemaphoreWait> waits{{timeline_.get(), 1, 0, "own"},
                                           {timeline_.get(), 2, 0, ""},
                                           {timeline_.get(), 3, 0, "no such import"}};
    EXPECT_EQ(waiting_batches(plan, waits, {}), (std::vector<uint32_t>{1, kNoId, kNoId}));
    // If the only batch with the import is left out, the whole frame waits.
    EXPECT_EQ(waiting_batches(plan, waits, {0, 1, 0}), (std::vector<uint32_t>{kNoId, kNoId, kNoId}));
}

}  // namespace
}  // namespace weft::vk
