#include "graph/sync/submissions.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/graph/samples/hand_made.h"

namespace weft::test {
namespace {

Schedule on_queues(std::vector<QueueIndex> queue) {
    Schedule order;
    for (uint32_t p = 0; p < queue.size(); ++p) {
        order.order.push_back(PassId(p));
        order.position.push_back(Position(p));
    }
    order.queue = std::move(queue);
    order.queues = two_queues();
    return order;
}

// Returns one line for each batch, such as "q0: 2 3 after 1-1 end". In this example, the batch runs on queue
// 0 and has the passes at positions 2 and 3. It waits for batch 1 of the previous frame ("-1"; without "-1":
// of this frame), and it ends the frame.
std::string submissions_text(const SubmissionPlan& plan) {
    std::string text;
    for (const Batch& batch : plan.batches) {
        text += "q" + std::to_string(batch.queue) + ":";
        for (const Position position : batch.positions) text += " " + std::to_string(position);
        for (const QueueWait& wait : batch.waits)
            text += " after " + std::to_string(wait.batch) + (wait.previous_frame ? "-1" : "");
        text += batch.epilogue ? " end\n" : "\n";
    }
    return text;
}

TEST(Submissions, OneQueueIsOneBatch) {
    const SubmissionPlan plan = submissions(on_queues({0, 0, 0}), {});
    EXPECT_EQ(submissions_text(plan), "q0: 0 1 2 end\n");
    EXPECT_TRUE(plan.dependencies.empty());
}

TEST(Submissions, AnEmptyFrameStillEndsOnTheFirstQueue) {
    EXPECT_EQ(submissions_text(submissions(on_queues({}), {})), "q0: end\n");
}

TEST(Submissions, BatchesEndBehindWhatIsWaitedForAndBeginAtWhatWaits) {
    // Position 1 on queue 1 waits for position 0. Position 3 on queue 0 waits for position 1.
    const SubmissionPlan plan = submissions(on_queues({0, 1, 0, 0}), {{0, 1, false, 7}, {1, 3, false, 8}});
    EXPECT_EQ(submissions_text(plan), "q0: 0\nq1: 1 after 0\nq0: 2\nq0: 3 after 1 end\n");
    ASSERT_EQ(plan.dependencies.size(), 2u);
    EXPECT_EQ(plan.dependencies[plan.batches[1].waits[0].dependency], (QueueDependency{0, 1, false, 7}));
    EXPECT_EQ(plan.dependencies[plan.batches[3].waits[0].dependency], (QueueDependency{1, 3, false, 8}));
}

TEST(Submissions, AWaitThatAnotherImpliesIsLeftOut) {
    // Position 1 comes after position 0 on the same queue. So the wait for position 1 also covers the wait
    // for position 0.
    const SubmissionPlan plan = submissions(on_queues({0, 0, 1}), {{0, 2, false, 7}, {1, 2, false, 8}});
    EXPECT_EQ(submissions_text(plan), "q0: 0 1\nq1: 2 after 0\nq0: end\n");
    EXPECT_EQ(plan.dependencies, (std::vector<QueueDependency>{{1, 2, false, 8}}));
}

TEST(Submissions, AWaitForTheFrameBefore) {
    // Position 0 waits for position 1 of the previous frame.
    const SubmissionPlan plan = submissions(on_queues({0, 1}), {{1, 0, true, 7}});
    EXPECT_EQ(submissions_text(plan), "q0: 0 after 1-1 end\nq1: 1\n");
    EXPECT_EQ(plan.dependencies, (std::vector<QueueDependency>{{1, 0, true, 7}}));
}

TEST(Submissions, TheEndOfTheFrameWaitsToo) {
    // There are two passes, so position 2 means the end of the frame.
    EXPECT_EQ(submissions_text(submissions(on_queues({0, 1}), {{1, 2, false, 7}})),
              "q0: 0\nq1: 1\nq0: after 1 end\n");
}

}  // namespace
}  // namespace weft::test
