// Tests BatchOrder: if the batches of resting units are left out, all other batches must be ordered as if the
// left-out batches were submitted with no commands in them. A batch that waits for the end of the previous
// frame must also wait for what the program has submitted to queue 0 since then.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <random>
#include <set>

#include "graph/rest/batch_order.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_rest.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

using BatchRun = std::pair<uint64_t, uint32_t>;  // Frame and index of a batch.
// Stands for the work that the program submits before a frame.
constexpr uint32_t kProgram = UINT32_MAX;

// Follows the rules of Vulkan: the end of a batch comes after the ends of all earlier batches of its queue,
// and a wait also holds for all later batches of its queue.
class HappensBefore {
 public:
    explicit HappensBefore(size_t queue_count) : queue_starts_(queue_count), queue_ends_(queue_count) {}

    void add(const BatchRun& batch, QueueIndex queue, const std::vector<BatchRun>& waits) {
        std::set<BatchRun>& start = queue_starts_[queue];
        for (const BatchRun& wait : waits) start.insert(ends_[wait].begin(), ends_[wait].end());
        starts[batch] = start;
        std::set<BatchRun>& end = queue_ends_[queue];
        end.insert(start.begin(), start.end());
        end.insert(batch);
        ends_[batch] = end;
    }

    std::map<BatchRun, std::set<BatchRun>> starts;  // The batches that have ended when this batch starts.

 private:
    std::vector<std::set<BatchRun>> queue_starts_, queue_ends_;
    std::map<BatchRun, std::set<BatchRun>> ends_;
};

class BatchOrderRule : public ResolveTest {
 protected:
    BatchOrderRule() {
        shaders = rest_shaders();
        imports.imports["noise"].resource.format = Format::rgba16f;
    }

    // Runs 6 frames in which random units rest. Returns the number of batches that were left out.
    static uint32_t compare(const FramePlan& plan, uint32_t seed) {
        std::mt19937 random(seed);
        BatchOrder order(plan);
        const std::vector<Batch>& batches = plan.submissions.batches;
        // The program counts as one more queue, because only the waits for it are compared.
        const size_t queues = plan.schedule.queues.size() + 1;
        HappensBefore wanted(queues), found(queues);
        std::map<std::pair<QueueIndex, uint64_t>, BatchRun> by_point;
        std::set<BatchRun> left_out;
        const QueueIndex program(static_cast<uint32_t>(plan.schedule.queues.size()));
        const auto awaits_program = [&](const QueueWait& wait) {
            return wait.previous_frame &&
                   plan.submissions.dependencies.at(wait.dependency).from == plan.schedule.order.size();
        };
        for (uint64_t frame = 0; frame < 6; ++frame) {
            const BatchRun between{frame, kProgram};
            wanted.add(between, program, {});
            found.add(between, program, {});
            by_point[{program, frame}] = between;
            std::vector<uint8_t> resting(plan.graph.rest_unit_count);
            for (uint8_t& rests : resting) rests = frame > 0 && random() % 3 != 0 ? 1 : 0;
            order.begin_frame();
            for (uint32_t i = 0; i < batches.size(); ++i) {
                const BatchRun run{frame, i};
                std::vector<BatchRun> waits;
                for (const QueueWait& wait : batches[i].waits)
                    if (!wait.previous_frame || frame > 0) {
                        waits.push_back({wait.previous_frame ? frame - 1 : frame, wait.batch});
                        if (awaits_program(wait)) waits.push_back(between);
                    }
                wanted.add(run, batches[i].queue, waits);
                if (is_empty_batch(plan, batches[i], resting)) {
                    order.skip(i);
                    left_out.insert(run);
                    continue;
                }
                waits.clear();
                for (const QueuePoint& point : order.submit(i, frame))
                    waits.push_back(by_point.at({point.queue, point.value}));
                const QueuePoint end = order.end_of(i, frame);
                by_point[{end.queue, end.value}] = run;
                found.add(run, batches[i].queue, waits);
            }
        }
        for (const auto& [run, before] : found.starts) {
            std::set<BatchRun> all = wanted.starts[run];
            for (const BatchRun& out : left_out) all.erase(out);
            EXPECT_EQ(before, all) << "frame " << run.first << ", batch " << run.second;
        }
        return static_cast<uint32_t>(left_out.size());
    }
};

TEST_F(BatchOrderRule, LeftOutBatchesOrderTheOthersAsIfTheyWereEmpty) {
    uint32_t left_out = 0, batches = 0, for_program = 0;
    for (uint32_t seed = 1; seed <= 300; ++seed) {
        const RandomRest made = random_rest(seed + 40000);
        SCOPED_TRACE("seed " + std::to_string(seed + 40000) + "\n" + made.text);
        exports.clear();
        ResolvedGraph graph = good(made.text);
        for (const ResourceDecl& decl : graph.resources)
            if (decl.ring != kNoId) exports[decl.name] = {Access::copy_read};
        if (seed % 2 == 0) graph = good(made.text);
        CompileOptions options;
        options.queues = logical_queues({}, 2 + seed % 2);
        const FramePlan plan = compile(graph, content_needs(graph), options);
        for_program += BatchOrder(plan).awaits_program() ? 1 : 0;
        left_out += compare(plan, seed);
        batches += static_cast<uint32_t>(plan.submissions.batches.size()) * 6;
        if (HasFailure()) return;
    }
    std::cout << "seeds 40001..40300: " << left_out << " of " << batches << " batches left out; in "
              << for_program << " graphs, batches wait for the program\n";
    EXPECT_GE(left_out, 100u);
    EXPECT_GE(for_program, 20u);
}

}  // namespace
}  // namespace weft::test
