// Purpose: tests plans with three queue families. The layer in mock_families/ simulates them on a driver with
// one family. The validation layer checks every ownership transfer, every shared resource and the
// capabilities of each queue.
#include <algorithm>
#include <set>

#include "tests/graph/compile/naive_plan.h"
#include "tests/graph/samples/random_graph.h"
#include "tests/vulkan/executor_fixture.h"
#include "tests/vulkan/plan_runner.h"
#include "tests/vulkan/scoped_environment.h"
#include "weft/check/check_plan.h"

namespace weft::vk {
namespace {

// All features except multiview, which llvmpipe draws wrongly.
test::RandomGraphOptions all_but_views() {
    test::RandomGraphOptions options = test::all_features();
    options.views = false;
    return options;
}

// Returns the folders in which the environment lets the loader search for layers, each with a colon behind
// it.
std::string set_path() {
    const char* path = std::getenv("VK_LAYER_PATH");
    return path != nullptr && *path != 0 ? path + std::string(":") : "";
}

class QueueFamiliesVk : public ExecutorTest {
 protected:
    [[nodiscard]] DeviceOptions device_options() const override {
        DeviceOptions options = ExecutorTest::device_options();
        options.queues = 4;
        return options;
    }

    // Makes a plan of a random frame for four logical queues. The frame may use all features of the graph
    // generator, so that all kinds of queue family ownership transfers can occur.
    FramePlan plan_of(uint32_t seed) {
        const ResolvedGraph graph = test::random_graph(seed, all_but_views());
        CompileOptions options;
        options.queues = logical_queues(device().profile(), 4);
        return compile(graph, query_memory_needs(device(), graph), options);
    }

 private:
    // The loader orders layers by the search path. The validation layer must come first, so that it sees the
    // simulated families.
    ScopedEnvironment path_{"VK_LAYER_PATH",
                            set_path() +
                                "/usr/local/share/vulkan/explicit_layer.d:/etc/vulkan/explicit_layer.d:"
                                "/usr/share/vulkan/explicit_layer.d:" WEFT_MOCK_FAMILIES_DIR};
    ScopedEnvironment layers_{"VK_INSTANCE_LAYERS",
                              "VK_LAYER_KHRONOS_validation:VK_LAYER_WEFT_mock_families"};
};

bool has_release(const PassStep& step) {
    return std::any_of(step.after.begin(), step.after.end(),
                       [](const BarrierDecl& b) { return b.reason == BarrierReason::release_queue; });
}

TEST_F(QueueFamiliesVk, a_queue_of_each_is_made_and_shared_among) {
    const std::vector<QueueFamilyProfile>& families = device().profile().queue_families;
    ASSERT_EQ(families.size(), 3u);
    EXPECT_EQ(families[0].kind, QueueKind::graphics);
    EXPECT_EQ(families[1].kind, QueueKind::compute);
    EXPECT_EQ(families[2].kind, QueueKind::transfer);
    EXPECT_EQ(device().sharing_families(), (std::vector<uint32_t>{0, 1, 2}));
    std::set<VkQueue> handles;
    for (const QueueFamily& family : device().families())
        handles.insert(family.queues.begin(), family.queues.end());
    EXPECT_EQ(handles.size(), 3u) << "the second compute queue shares that family's only one";
}

TEST_F(QueueFamiliesVk, frames_move_between_families_without_a_message) {
    constexpr uint32_t kFirstSeed = 300, kSeeds = 12;
    TestShaders shaders;
    uint32_t transfers = 0, concurrent = 0, waits = 0;
    for (uint32_t seed = kFirstSeed; seed < kFirstSeed + kSeeds; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const FramePlan plan = plan_of(seed);
        const Diagnostics faults = check_plan(plan);
        ASSERT_TRUE(faults.empty()) << to_text(faults);
        for (const PassStep& step : plan.barriers.steps) transfers += has_release(step) ? 1 : 0;
        for (const uint8_t shared : plan.barriers.concurrent) concurrent += shared;
        for (const Batch& batch : plan.submissions.batches)
            waits += static_cast<uint32_t>(batch.waits.size());
        const RunOptions run{3, {}, true};
        const PlanResult result = run_plan(device(), plan, shaders, run);
        const PlanResult naive = run_plan(
            device(), test::naive_plan(plan.graph, query_memory_needs(device(), plan.graph)), shaders, run);
        ASSERT_EQ(result.readbacks.size(), naive.readbacks.size());
        for (size_t i = 0; i < naive.readbacks.size(); ++i)
            EXPECT_TRUE(result.readbacks[i].bytes == naive.readbacks[i].bytes) << "frame " << i;
        ASSERT_EQ(device().messages().count(), 0u);
    }
    std::printf("%u frames: %u passes release images to other families, %u resources are shared, %u waits\n",
                kSeeds, transfers, concurrent, waits);
    EXPECT_GE(transfers, kSeeds);
    EXPECT_GE(concurrent, kSeeds);
}

TEST_F(QueueFamiliesVk, a_transfer_without_its_first_half_is_heard) {
    FramePlan plan;
    bool dropped = false;
    for (uint32_t seed = 300; seed < 400 && !dropped; ++seed) {
        plan = plan_of(seed);
        for (PassStep& step : plan.barriers.steps) {
            if (dropped || !has_release(step)) continue;
            step.after.clear();
            dropped = true;
        }
    }
    ASSERT_TRUE(dropped);
    TestShaders shaders;
    static_cast<void>(run_plan(device(), plan, shaders));
    const std::vector<Message> messages = destroy_device(take_device());
    EXPECT_TRUE(std::any_of(messages.begin(), messages.end(), [](const Message& message) {
        return message.text.find("no matching release") != std::string::npos;
    })) << (messages.empty() ? "nothing was heard" : messages[0].text);
}

// Plants a fault: adds the fragment shader stage to a barrier on a transfer queue. A transfer queue does not
// support this stage. Returns false if the plan has no barrier on a transfer queue.
bool plant_fragment_stage(FramePlan& plan) {
    const Schedule& schedule = plan.schedule;
    for (Position position(0); position < schedule.queue.size(); ++position) {
        std::vector<BarrierDecl>& barriers = plan.barriers.steps[position].barriers;
        if (schedule.queues[schedule.queue[position]].kind != QueueKind::transfer || barriers.empty())
            continue;
        barriers.front().dst.stages |= stage::kFragmentShader;
        return true;
    }
    return false;
}

TEST_F(QueueFamiliesVk, a_stage_that_the_queue_lacks_is_heard) {
    FramePlan plan;
    bool planted = false;
    for (uint32_t seed = 300; seed < 400 && !planted; ++seed) {
        plan = plan_of(seed);
        planted = plant_fragment_stage(plan);
    }
    ASSERT_TRUE(planted);
    TestShaders shaders;
    static_cast<void>(run_plan(device(), plan, shaders));
    const std::vector<Message> messages = destroy_device(take_device());
    EXPECT_TRUE(std::any_of(messages.begin(), messages.end(), [](const Message& message) {
        return message.id.find("StageMask") != std::string::npos;
    })) << (messages.empty() ? "nothing was heard" : messages[0].id);
}

TEST_F(QueueFamiliesVk, a_plan_for_fewer_queues_runs_as_well) {
    TestShaders shaders;
    for (const uint32_t queues : {1u, 2u, 3u}) {
        const ResolvedGraph graph = test::random_graph(301, all_but_views());
        CompileOptions options;
        options.queues = logical_queues(device().profile(), queues);
        const FramePlan plan = compile(graph, query_memory_needs(device(), graph), options);
        EXPECT_FALSE(run_plan(device(), plan, shaders).readbacks.empty());
    }
}

}  // namespace
}  // namespace weft::vk
