// Each test breaks a correct plan with ranges of buffers in one way. The checker must report the error.
#include <gtest/gtest.h>

#include <algorithm>

#include "null/null_executor.h"
#include "tests/graph/samples/graph_builder.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

constexpr SubresourceRange pieces(uint32_t first, uint32_t count) {
    return {0, 1, first, count, aspect::kColor};
}

// The passes "a", "b" and "c" write one third of the buffer "x" each, in any order. "s" reads the second
// third. Then "d" modifies the first two thirds, and "r" reads the whole buffer.
class PieceFault : public ::testing::Test {
 protected:
    PieceFault() {
        GraphBuilder builder;
        const ResourceId x = builder.buffer("x", 768);
        builder.cut(x, {256, 512});
        for (uint32_t piece = 0; piece < 3; ++piece)
            builder.compute(std::string(1, static_cast<char>('a' + piece)),
                            {{"dst", x, Access::storage_write, pieces(piece, 1), kNoId}});
        builder.pass("s", PassKind::readback, {{"src", x, Access::copy_read, pieces(1, 1), kNoId}});
        builder.compute("d", {{"dst", x, Access::storage_read_write, pieces(0, 2), kNoId}});
        builder.pass("r", PassKind::readback, {{"src", x, Access::copy_read, {}, kNoId}});
        const ResolvedGraph graph = builder.build();
        plan = compile(graph, content_needs(graph), {});
    }

    UseDecl& use(const char* pass) { return plan.graph.passes[find_pass(plan.graph, pass)].uses.front(); }
    ResourceDecl& x() { return plan.graph.resources[find_resource(plan.graph, "x")]; }
    std::vector<BarrierDecl>& barriers(const char* pass) {
        return plan.barriers.steps[plan.schedule.position[find_pass(plan.graph, pass)]].barriers;
    }
    bool has_fault(const char* code) {
        const Diagnostics faults = check_plan(plan);
        return std::ranges::any_of(faults, [&](const Diagnostic& d) { return d.code == code; });
    }
    bool has_fault() { return !check_plan(plan).empty(); }
    // Returns true if the null executor gets the values that the original graph defines.
    bool is_right(const ResolvedGraph& graph) {
        const NullRun wanted = run_reference(graph, plan.live, 3);
        for (const NullOrder order : {NullOrder::delayed, NullOrder::shuffled})
            if (!differences(graph, wanted, run_null(plan, {3, 1, order})).empty()) return false;
        return true;
    }

    FramePlan plan;
};

TEST_F(PieceFault, the_sound_plan_has_no_barrier_between_disjoint_ranges) {
    EXPECT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
    EXPECT_TRUE(is_right(plan.graph));
    uint32_t between = 0;
    for (const char* pass : {"a", "b", "c"})
        for (const BarrierDecl& barrier : barriers(pass)) between += barrier.from_previous_frame ? 0 : 1;
    EXPECT_EQ(between, 0u);
    ASSERT_EQ(barriers("d").size(), 2u);
    EXPECT_EQ(barriers("d").front().range, pieces(0, 1));
    EXPECT_EQ(barriers("d").back().range, pieces(1, 1));
}

TEST_F(PieceFault, one_piece_without_a_barrier) {
    barriers("d").pop_back();
    EXPECT_TRUE(has_fault());
    EXPECT_FALSE(is_right(plan.graph));
}

TEST_F(PieceFault, a_barrier_on_other_pieces) {
    barriers("d").back().range = pieces(2, 1);
    EXPECT_TRUE(has_fault());
    EXPECT_FALSE(is_right(plan.graph));
}

// If the compiler takes overlapping ranges for disjoint ones, the pieces of a use do not fit its bytes.
TEST_F(PieceFault, a_use_of_other_pieces_than_its_bytes) {
    for (const SubresourceRange& wrong : {pieces(0, 1), pieces(1, 2), pieces(0, 3), pieces(2, 1)}) {
        use("d").range = wrong;
        EXPECT_TRUE(has_fault("C344")) << wrong.layer << " " << wrong.layers;
    }
    use("d").range = pieces(0, 2);
    EXPECT_FALSE(has_fault());
    use("d").bytes = ByteRange{0, 511};
    EXPECT_TRUE(has_fault("C344"));
    use("d").bytes = ByteRange{0, 1024};
    EXPECT_TRUE(has_fault("C344"));
}

// The whole plan is compiled from a graph in which "d" seems to use only one piece. So no barrier waits for
// "b". The null executor finds the real pieces from the bytes.
TEST_F(PieceFault, the_null_executor_finds_pieces_that_the_compiler_overlooked) {
    const ResolvedGraph right = plan.graph;
    ResolvedGraph wrong = plan.graph;
    UseDecl& d = wrong.passes[find_pass(wrong, "d")].uses.front();
    d.range = pieces(0, 1);
    d.sources = {{pieces(0, 1), find_pass(wrong, "a")}};
    const PassId a = find_pass(wrong, "a"), id = find_pass(wrong, "d");
    std::erase_if(wrong.edges, [&](const EdgeDecl& e) { return e.from != a && e.to == id; });
    plan = compile(wrong, content_needs(wrong), {});
    EXPECT_TRUE(has_fault("C344"));
    plan.graph.passes[id].uses.front() = right.passes[id].uses.front();
    EXPECT_TRUE(has_fault());
    EXPECT_FALSE(is_right(right));
}

TEST_F(PieceFault, cuts_that_do_not_divide_the_buffer) {
    const std::vector<std::vector<uint64_t>> wrong{{512, 256}, {256, 256}, {0, 256}, {256, 768}};
    for (const std::vector<uint64_t>& cuts : wrong) {
        x().cuts_bytes = cuts;
        EXPECT_TRUE(has_fault("C344"));
    }
}

}  // namespace
}  // namespace weft::test
