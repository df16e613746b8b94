// Tests plans that use content of earlier frames: rings, kept resources, and the prologue that initialises
// them.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "tests/graph/compile/plan_expectations.h"
#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/random_graph.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

constexpr uint32_t kRingGraphs = 300;

UseDecl use_of(const ResolvedGraph& graph, const char* port, ResourceId id, Access access) {
    UseDecl use;
    use.port = port;
    use.resource = id;
    use.range = graph.resources[id].whole();
    use.access = access;
    const bool image = graph.resources[id].kind == ResourceKind::image;
    use.state = access_state(access, stage_bit(ShaderStage::compute),
                             image ? graph.resources[id].aspects : aspect::kNone);
    if (reads(access)) use.sources = {{use.range, kNoId}};
    use.is_output = writes(access);
    return use;
}

// Changes a transient resource to a ring with `history` past frames, and adds a pass that reads all of the
// past frames.
void remember(ResolvedGraph& graph, ResourceId id, uint32_t history) {
    ResourceDecl& newest = graph.resources[id];
    newest.lifetime = ResourceLifetime::persistent;
    newest.history = history;
    newest.ring = id;
    PassDecl reader;
    reader.name = "z_recall_" + newest.name;
    reader.type = "compute";
    reader.queue = static_cast<QueueKind>(id % 3);
    reader.side_effect = true;
    const ResourceDecl role = newest;
    for (uint32_t age = 1; age <= history; ++age) {
        graph.resources.push_back(role);
        graph.resources.back().name += "[-" + std::to_string(age) + "]";
        graph.resources.back().age = age;
        const auto aged = static_cast<ResourceId>(graph.resources.size() - 1);
        const Access access = role.kind == ResourceKind::buffer ? Access::storage_read : Access::sampled_read;
        reader.uses.push_back(use_of(graph, "past", aged, access));
    }
    graph.passes.push_back(reader);
}

// Adds a kept buffer. One pass modifies the buffer in place in every frame, and another pass reads it.
void add_kept(ResolvedGraph& graph) {
    ResourceDecl kept;
    kept.name = "z_kept";
    kept.kind = ResourceKind::buffer;
    kept.lifetime = ResourceLifetime::persistent;
    kept.size_bytes = 256;
    kept.aspects = aspect::kNone;
    kept.ring = static_cast<ResourceId>(graph.resources.size());
    graph.resources.push_back(kept);
    PassDecl change, look;
    change.name = "z_change";
    look.name = "z_look";
    change.type = look.type = "compute";
    look.side_effect = true;
    change.queue = QueueKind::compute;
    change.uses = {use_of(graph, "kept", kept.ring, Access::storage_read_write)};
    look.uses = {use_of(graph, "kept", kept.ring, Access::storage_read)};
    const auto first = static_cast<PassId>(graph.passes.size());
    look.uses.front().sources.front().producer = first;
    graph.passes.push_back(change);
    graph.passes.push_back(look);
    graph.edges.push_back({first, PassId(first + 1), EdgeKind::raw, kept.ring, {}});
}

// Returns true if the resource is transient, has one mip and one layer, and a pass writes it. Only such
// resources become rings in these tests, because then no part of a ring stays unwritten.
bool wholly_written(const ResolvedGraph& graph, ResourceId id) {
    const ResourceDecl& resource = graph.resources[id];
    if (resource.lifetime != ResourceLifetime::transient || resource.mips * resource.layers != 1)
        return false;
    bool written = false;
    for (const PassDecl& pass : graph.passes)
        for (const UseDecl& use : pass.uses) written = written || (use.resource == id && writes(use.access));
    return written;
}

ResolvedGraph with_history(uint32_t seed) {
    ResolvedGraph graph = random_graph(seed);
    for (ResourceDecl& resource : graph.resources)
        if (resource.import) resource.import->concurrent = true;
    for (PassId id(0); id < graph.passes.size(); ++id)
        graph.passes[id].queue = static_cast<QueueKind>(((id * 2654435761u ^ seed * 40503u) >> 7) % 3);
    const size_t count = graph.resources.size();
    for (ResourceId id(0); id < count; ++id)
        if (id % 3 == seed % 3 && wholly_written(graph, id)) remember(graph, id, 1 + (seed + id) % 3);
    add_kept(graph);
    return graph;
}

CompileOptions on_queues(uint32_t count) {
    DeviceProfile profile;
    profile.queue_families = {{QueueKind::graphics, 1}, {QueueKind::compute, 2}, {QueueKind::transfer, 1}};
    CompileOptions options;
    options.queues = logical_queues(profile, count);
    return options;
}

TEST(RingPlans, RandomFramesWithHistoryAreProvedOnOneToFourQueues) {
    uint32_t remembering = 0;
    for (uint32_t seed = 0; seed < kRingGraphs; ++seed) {
        const uint32_t count = 1 + seed % 4;
        SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(count) + " queues");
        const ResolvedGraph graph = with_history(seed);
        const FramePlan plan = compile(graph, content_needs(graph), on_queues(count));
        const Diagnostics faults = check_plan(plan);
        EXPECT_TRUE(faults.empty()) << to_text(faults);
        remembering += std::any_of(graph.resources.begin(), graph.resources.end(),
                                   [](const ResourceDecl& r) { return r.age > 0; });
        if (HasFailure()) break;
    }
    std::cout << kRingGraphs << " graphs (seeds 0.." << kRingGraphs - 1 << "): " << remembering
              << " have a history\n";
    EXPECT_GE(remembering, kRingGraphs * 3 / 10);
}

TEST(RingPlans, AForgottenPrologueIsAFault) {
    const ResolvedGraph graph = with_history(1);
    FramePlan plan = compile(graph, content_needs(graph), on_queues(1));
    ASSERT_FALSE(plan.barriers.prologue.cleared.empty());
    plan.barriers.prologue.cleared.clear();
    EXPECT_NE(to_text(check_plan(plan)).find("C330"), std::string::npos);
    plan = compile(graph, content_needs(graph), on_queues(1));
    plan.barriers.prologue.after.clear();
    EXPECT_FALSE(check_plan(plan).empty());
}

// No pass writes the ring here. (In a graph file, this happens if the key "if" removes the writing pass.)
// Every frame must read the initial value that the prologue has written to the ring.
TEST(RingPlans, APastThatNobodyWritesStaysAsItWasAtFirst) {
    for (const uint32_t history : {1u, 2u}) {
        GraphBuilder builder;
        const ResourceId result = builder.image("result");
        const ResourceId past = builder.ring(builder.image("never"), history)[1];
        builder.compute("look", {{"a", past, Access::sampled_read}, {"dst", result, Access::storage_write}});
        builder.pass("read_back", PassKind::readback, {{"src", result, Access::copy_read}});
        const ResolvedGraph graph = builder.build();
        FramePlan plan = compile(graph, content_needs(graph), on_queues(1));
        const Diagnostics faults = check_plan(plan);
        EXPECT_TRUE(faults.empty()) << to_text(faults);
        plan.barriers.prologue.cleared.clear();
        EXPECT_NE(to_text(check_plan(plan)).find("C330"), std::string::npos);
    }
}

TEST(RingPlans, HistoryKeepsItsWritersAlive) {
    for (uint32_t seed = 0; seed < 10; ++seed) {
        const ResolvedGraph graph = with_history(seed);
        const FramePlan plan = compile(graph, content_needs(graph), on_queues(1));
        for (const PassId id : plan.schedule.order) ASSERT_TRUE(plan.live.live_passes[id]);
        for (PassId id(0); id < graph.passes.size(); ++id) {
            for (const UseDecl& use : graph.passes[id].uses) {
                const bool remembered = writes(use.access) && graph.resources[use.resource].history > 0;
                EXPECT_TRUE(!remembered || plan.live.live_passes[id]) << graph.passes[id].name;
            }
        }
    }
}

}  // namespace
}  // namespace weft::test
