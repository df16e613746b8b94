// Tests plans for one to four queues, of one or several queue families. The checker must accept each plan. No
// semaphore wait and hardly any barrier may be unnecessary.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/graph/samples/random_graph.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

constexpr uint32_t kGraphs = 300;

std::vector<LogicalQueue> queues_of(uint32_t count, bool one_family) {
    DeviceProfile profile;
    if (!one_family)
        profile.queue_families = {
            {QueueKind::graphics, 1}, {QueueKind::compute, 2}, {QueueKind::transfer, 1}};
    return logical_queues(profile, count);
}

// Gives each pass a queue hint that follows from the pass id and the seed. About a third of the passes
// request each kind of queue. Also lets all queue families use the imports.
ResolvedGraph with_hints(ResolvedGraph graph, uint32_t seed) {
    for (PassId id(0); id < graph.passes.size(); ++id) {
        const uint32_t turn = (id * 2654435761u ^ seed * 40503u) >> 7;
        graph.passes[id].queue = static_cast<QueueKind>(turn % 3);
    }
    for (ResourceDecl& resource : graph.resources)
        if (resource.import) resource.import->concurrent = true;
    return graph;
}

TEST(QueuePlans, RandomFramesAreProvedOnOneToFourQueues) {
    uint32_t waits = 0, transfers = 0, shared = 0, several = 0, handed_over = 0;
    for (uint32_t seed = 0; seed < kGraphs; ++seed) {
        const uint32_t count = 1 + seed % 4;
        SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(count) + " queues");
        const ResolvedGraph graph = with_hints(random_graph(seed), seed);
        CompileOptions options;
        options.queues = queues_of(count, seed % 8 == 7);
        const FramePlan plan = compile(graph, content_needs(graph), options);
        const Diagnostics faults = check_plan(plan);
        EXPECT_TRUE(faults.empty()) << to_text(faults);
        bool waited = false;
        for (const Batch& batch : plan.submissions.batches)
            for (const QueueWait& wait : batch.waits) waited = waited || !wait.previous_frame;
        waits += waited;
        several += plan.submissions.batches.size() > 1;
        bool moved = false;
        for (const PassStep& step : plan.barriers.steps)
            for (const BarrierDecl& b : step.after) moved = moved || b.reason == BarrierReason::release_queue;
        transfers += moved;
        for (const uint8_t concurrent : plan.barriers.concurrent) shared += concurrent;
        bool reused = false;
        for (const AliasTransition& h : plan.memory.alias_transitions) reused = reused || h.from != h.to;
        handed_over += reused;
        if (HasFailure()) break;
    }
    std::cout << kGraphs << " graphs (seeds 0.." << kGraphs - 1 << "): " << several << " use several queues, "
              << waits << " wait across queues within a frame, " << transfers
              << " move images between families, " << shared << " resources are concurrent, " << handed_over
              << " hand memory over\n";
    EXPECT_GE(waits, kGraphs * 3 / 10);
    EXPECT_GE(transfers, kGraphs * 2 / 10);
    EXPECT_GE(handed_over, kGraphs / 2);
}

FramePlan planned(uint32_t seed) {
    const ResolvedGraph graph = with_hints(random_graph(seed, {5, 25}), seed);
    CompileOptions options;
    options.queues = queues_of(2 + seed % 3, false);
    return compile(graph, content_needs(graph), options);
}

// Removes each semaphore wait in turn and expects an error from the checker. This shows two things: the plan
// has no unnecessary wait, and the checker notices every missing wait.
TEST(QueuePlans, EveryWaitIsNeeded) {
    uint32_t dropped = 0;
    for (uint32_t seed = 0; seed < 40; ++seed) {
        const FramePlan plan = planned(seed);
        for (size_t b = 0; b < plan.submissions.batches.size(); ++b) {
            for (size_t i = 0; i < plan.submissions.batches[b].waits.size(); ++i) {
                FramePlan without = plan;
                std::vector<QueueWait>& waits = without.submissions.batches[b].waits;
                const QueueDependency& why = plan.submissions.dependencies[waits[i].dependency];
                waits.erase(waits.begin() + static_cast<std::ptrdiff_t>(i));
                ++dropped;
                EXPECT_FALSE(check_plan(without).empty())
                    << "seed " << seed << ": position " << why.to << " after " << why.from
                    << (why.previous_frame ? " of the frame before" : "") << " for "
                    << (why.resource == kNoId ? "-" : plan.graph.resources[why.resource].name);
            }
        }
    }
    std::cout << dropped << " waits dropped\n";
    EXPECT_GE(dropped, 100u);
}

// Removes one barrier at a time from a list of the step: the barriers before its pass, or those after it.
// Returns how many barriers are unnecessary: without them, the checker reports no error.
uint32_t count_redundant(const FramePlan& plan, size_t position, std::vector<BarrierDecl> PassStep::*list) {
    uint32_t redundant = 0;
    const PassStep& step = plan.barriers.steps[position];
    for (size_t i = 0; i < (step.*list).size(); ++i) {
        FramePlan without = plan;
        std::vector<BarrierDecl>& barriers = without.barriers.steps[position].*list;
        barriers.erase(barriers.begin() + static_cast<std::ptrdiff_t>(i));
        redundant += check_plan(without).empty() ? 1 : 0;
    }
    return redundant;
}

// A barrier is unnecessary only in one case: work went to another queue and back, and two semaphores already
// order the accesses. At most 1 % of the barriers may be unnecessary.
TEST(QueuePlans, HardlyABarrierIsInVain) {
    uint32_t emitted = 0, redundant = 0;
    for (uint32_t seed = 0; seed < 40; ++seed) {
        const FramePlan plan = planned(seed);
        for (Position p(0); p < plan.barriers.steps.size(); ++p) {
            emitted += static_cast<uint32_t>(plan.barriers.steps[p].barriers.size() +
                                             plan.barriers.steps[p].after.size());
            redundant += count_redundant(plan, p, &PassStep::barriers);
            redundant += count_redundant(plan, p, &PassStep::after);
        }
    }
    std::cout << emitted << " barriers dropped one by one, " << redundant << " not missed\n";
    EXPECT_GE(emitted, 500u);
    EXPECT_LE(redundant * 100, emitted);
}

}  // namespace
}  // namespace weft::test
