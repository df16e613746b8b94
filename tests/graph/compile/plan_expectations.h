// Purpose: finds passes, resources and barriers of plans by name, for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/graph/samples/graph_builder.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {

// Compiles the graph with a memory alignment of 1 byte and expects that the checker finds no error in the
// plan.
inline FramePlan compiled(const GraphBuilder& builder) {
    const ResolvedGraph graph = builder.build();
    FramePlan plan = compile(graph, content_needs(graph, 1), {});
    const Diagnostics faults = check_plan(plan);
    EXPECT_TRUE(faults.empty()) << to_text(faults);
    return plan;
}

inline PassId pass_id(const FramePlan& plan, const std::string& name) {
    return find_pass(plan.graph, name);
}

inline ResourceId resource_id(const FramePlan& plan, const std::string& name) {
    return find_resource(plan.graph, name);
}

inline const PassStep& step_of(const FramePlan& plan, const std::string& pass) {
    return plan.barriers.steps[plan.schedule.position[pass_id(plan, pass)]];
}

inline std::vector<BarrierDecl> barriers_on(const FramePlan& plan, const std::vector<BarrierDecl>& barriers,
                                            const std::string& resource) {
    std::vector<BarrierDecl> found;
    for (const BarrierDecl& b : barriers)
        if (b.resource == resource_id(plan, resource)) found.push_back(b);
    return found;
}

// Returns the barriers on `resource` that the plan records before `pass`.
inline std::vector<BarrierDecl> barriers_before(const FramePlan& plan, const std::string& pass,
                                                const std::string& resource) {
    return barriers_on(plan, step_of(plan, pass).barriers, resource);
}

// Expects that the plan has exactly one barrier on `resource` before `pass`, and returns the barrier.
inline BarrierDecl barrier_before(const FramePlan& plan, const std::string& pass,
                                  const std::string& resource) {
    const std::vector<BarrierDecl> found = barriers_before(plan, pass, resource);
    EXPECT_EQ(found.size(), 1u) << "before " << pass << " on " << resource;
    return found.empty() ? BarrierDecl{} : found.front();
}

inline void expect_state(const AccessState& found, const AccessState& wanted) {
    EXPECT_EQ(stages_text(found.stages), stages_text(wanted.stages));
    EXPECT_EQ(access_text(found.access), access_text(wanted.access));
    EXPECT_EQ(layout_text(found.layout), layout_text(wanted.layout));
}

// Adds a readback pass that reads the resource. A readback pass has a side effect, so the writers of the
// resource are not culled.
inline PassDecl& read_back(GraphBuilder& builder, const std::string& name, ResourceId resource) {
    return builder.pass(name, PassKind::readback, {{"src", resource, Access::copy_read, {}, kNoId}});
}

}  // namespace weft::test
