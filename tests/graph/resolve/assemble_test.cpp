#include "graph/resolve/assemble.h"

#include "tests/graph/resolve/stage_fixture.h"

namespace weft::test {
namespace {

class AssembleTest : public StageTest {
 protected:
    AssembleTest() {
        x = add_image("x");
        draw = add_pass("draw", PassKind::raster);
        fill = add_pass("fill");
        add_use(draw, "color", x, Access::color_write);
        add_use(fill, "dst", x, Access::storage_write);
        attachments.passes.resize(2);
        dispatches.passes.resize(2);
        blocks.passes.resize(2);
    }
    ResolvedGraph run() {
        return assemble({input_, values, shapes, expansion}, versioned(), attachments, dispatches, blocks);
    }

    ResourceId x = kNoId;
    PassId draw = kNoId, fill = kNoId;
    Attachments attachments;
    Dispatches dispatches;
    Blocks blocks;
    ResolveInput input_ = input();
};

TEST_F(AssembleTest, EachPassHasTheResultsOfAllStages) {
    attachments.passes[draw].render_extent = {8, 4, 1};
    dispatches.passes[fill].groups = {3, 2, 1};
    blocks.passes[fill].bytes = 16;
    blocks.passes[fill].push_constants = true;
    const ResolvedGraph resolved = run();
    ASSERT_EQ(resolved.passes.size(), 2u);
    EXPECT_EQ(resolved.resources.size(), 1u);
    EXPECT_EQ(resolved.passes[draw].name, "draw");
    EXPECT_EQ(resolved.passes[draw].uses.size(), 1u);
    EXPECT_EQ(resolved.passes[draw].render_extent.width, 8u);
    EXPECT_EQ(resolved.passes[fill].groups, (std::array<uint32_t, 3>{3, 2, 1}));
    EXPECT_EQ(resolved.passes[fill].params_bytes, 16u);
    EXPECT_TRUE(resolved.passes[fill].params_push);
}

TEST_F(AssembleTest, TheRectangleOfAViewIsTheViewportOfItsPass) {
    attachments.passes[draw].rect = RectPx{1, 2, 3, 4};
    const ResolvedGraph resolved = run();
    EXPECT_TRUE(resolved.passes[draw].state.viewport.has_value());
    EXPECT_TRUE(resolved.passes[draw].state.scissor.has_value());
    EXPECT_FALSE(resolved.passes[fill].state.viewport.has_value());
}

// The program reads an observed import after the frame, so the pass must run even if no other pass needs it.
TEST_F(AssembleTest, APassThatWritesAnObservedImportHasASideEffect) {
    shapes.resources[x].lifetime = ResourceLifetime::imported;
    EXPECT_FALSE(run().passes[fill].side_effect);
    imports.imports["x"].observed = true;
    EXPECT_TRUE(run().passes[fill].side_effect);
}

TEST_F(AssembleTest, OnlyTrianglesOfDrawListsAreCulled) {
    graph.passes["draw"].frustum = true;
    EXPECT_FALSE(run().passes[draw].culls_draws);
    bound[draw].draw_lists = {"opaque"};
    EXPECT_TRUE(run().passes[draw].culls_draws);
    expansion.passes[draw].decl.state.topology = Topology::lines;
    EXPECT_FALSE(run().passes[draw].culls_draws);
}

}  // namespace
}  // namespace weft::test
