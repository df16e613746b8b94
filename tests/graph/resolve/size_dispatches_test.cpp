#include "graph/resolve/size_dispatches.h"

#include "tests/graph/resolve/stage_fixture.h"

namespace weft::test {
namespace {

using Groups = std::array<uint32_t, 3>;

class SizeDispatchesTest : public StageTest {
 protected:
    SizeDispatchesTest() {
        // The shader's local size is 8x8x1 invocations.
        shaders["fill"] = compute({image_out("dst")});
        x = add_image("x");
        fill = add_pass("fill");
        add_use(fill, "dst", x, Access::storage_write);
    }

    PassDispatch run() {
        return size_dispatches({input_, values, shapes, expansion}, versioned(), suspects(), reporter)
            .passes[fill];
    }

    ResourceId x = kNoId;
    PassId fill = kNoId;
    ResolveInput input_ = input();
};

TEST_F(SizeDispatchesTest, TheOutputIsCoveredByWholeGroups) {
    shapes.resources[x].extent = {17, 8, 1};
    EXPECT_EQ(run().groups, (Groups{3, 1, 1}));
}

TEST_F(SizeDispatchesTest, ThreadsAreRoundedUpToGroups) {
    graph.passes["fill"].threads = {expression("output")};
    EXPECT_EQ(run().groups, (Groups{8, 4, 1}));
}

TEST_F(SizeDispatchesTest, GroupsMayDependOnTheIndexOfARepeat) {
    graph.passes["fill"].groups = {expression("2 * i"), expression("1"), expression("i")};
    expansion.passes[fill].indices = {{"i", 3}};
    EXPECT_EQ(run().groups, (Groups{6, 1, 3}));
}

TEST_F(SizeDispatchesTest, OutputsOfDifferentSizesLeaveItUnknown) {
    const ResourceId y = add_image("y");
    shapes.resources[y].extent = {8, 8, 1};
    add_use(fill, "other", y, Access::storage_write);
    (void)run();
    EXPECT_EQ(codes(), "W114");
}

TEST_F(SizeDispatchesTest, ACopyHasEndsOfOneShape) {
    const ResourceId y = add_image("y");
    const PassId copy = add_pass("move", PassKind::copy);
    add_use(copy, "src", x, Access::copy_read);
    add_use(copy, "dst", y, Access::copy_write);
    (void)run();
    EXPECT_EQ(codes(), "");
    shapes.resources[y].extent = {8, 8, 1};
    (void)run();
    EXPECT_EQ(codes(), "W183");
}

}  // namespace
}  // namespace weft::test
