// Each test breaks a correct plan with a table of textures in one way. The checker must report the error.
#include <gtest/gtest.h>

#include <algorithm>

#include "null/null_executor.h"
#include "tests/graph/samples/graph_builder.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"
#include "weft/imports.h"

namespace weft::test {
namespace {

// Pass "a" samples the table "pictures" and writes "x", which pass "r" reads back.
class TableFault : public ::testing::Test {
 protected:
    TableFault() {
        GraphBuilder builder;
        const ResourceId table = builder.image("pictures", Format::rgba8, 1);
        builder.import_as(table, texture_table_state(), texture_table_state());
        builder.make_concurrent(table);
        builder.edit(table).textures = 7;
        const ResourceId x = builder.image("x", Format::r32u);
        builder.compute(
            "a", {{"pictures", table, Access::sampled_read, {}, 0}, {"x", x, Access::storage_write, {}, 1}});
        builder.pass("r", PassKind::readback, {{"src", x, Access::copy_read, {}, kNoId}});
        const ResolvedGraph graph = builder.build();
        plan = compile(graph, content_needs(graph), {});
    }

    UseDecl& use() { return plan.graph.passes[find_pass(plan.graph, "a")].uses.front(); }
    ResourceId id() { return find_resource(plan.graph, "pictures"); }
    ResourceDecl& table() { return plan.graph.resources[id()]; }
    bool has_fault() {
        const Diagnostics faults = check_plan(plan);
        return std::ranges::any_of(faults, [](const Diagnostic& d) { return d.code == "C348"; });
    }

    FramePlan plan;
};

TEST_F(TableFault, the_sound_plan) {
    EXPECT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
    const NullRun wanted = run_reference(plan.graph, plan.live, 3);
    EXPECT_TRUE(differences(plan.graph, wanted, run_null(plan, {3, 1, NullOrder::delayed})).empty());
}

TEST_F(TableFault, another_access) {
    use().access = Access::storage_read;
    EXPECT_TRUE(has_fault());
}

TEST_F(TableFault, another_layout) {
    use().state.layout = Layout::general;
    EXPECT_TRUE(has_fault());
}

TEST_F(TableFault, a_port_without_a_binding) {
    use().binding = kNoId;
    EXPECT_TRUE(has_fault());
}

TEST_F(TableFault, an_output) {
    use().is_output = true;
    EXPECT_TRUE(has_fault());
}

TEST_F(TableFault, a_pass_without_a_shader) {
    plan.graph.passes[find_pass(plan.graph, "a")].kind = PassKind::copy;
    EXPECT_TRUE(has_fault());
}

TEST_F(TableFault, a_table_that_the_program_writes) {
    table().import->entry.access = access::kColorWrite;
    EXPECT_TRUE(has_fault());
}

TEST_F(TableFault, a_table_in_another_layout_after_the_frame) {
    table().import->exit.layout = Layout::general;
    EXPECT_TRUE(has_fault());
}

TEST_F(TableFault, a_table_that_is_no_import) {
    table().lifetime = ResourceLifetime::transient;
    EXPECT_TRUE(has_fault());
}

TEST_F(TableFault, fewer_files_than_textures) {
    table().texture_files.resize(3);
    EXPECT_TRUE(has_fault());
}

TEST_F(TableFault, a_barrier) {
    for (std::vector<BarrierDecl>* barriers :
         {&plan.barriers.steps[0].barriers, &plan.barriers.steps[0].after, &plan.barriers.epilogue}) {
        BarrierDecl& barrier = barriers->emplace_back();
        barrier.resource = id();
        barrier.range = table().whole();
        barrier.src = barrier.dst = texture_table_state();
        EXPECT_TRUE(has_fault());
        barriers->pop_back();
    }
    EXPECT_FALSE(has_fault());
}

}  // namespace
}  // namespace weft::test
