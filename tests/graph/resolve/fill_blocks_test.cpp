#include "graph/resolve/fill_blocks.h"

#include "tests/graph/resolve/stage_fixture.h"

namespace weft::test {
namespace {

class FillBlocksTest : public StageTest {
 protected:
    // Adds a compute pass whose shader has these members in its block `Params`.
    PassId add(std::initializer_list<BlockMember> members) {
        shaders["fill"] = with_params(compute({image_out("dst")}), members);
        return add_pass("fill");
    }
    PassBlock run() {
        return fill_blocks({input_, values, shapes, expansion}, versioned(), suspects(), reporter).passes[0];
    }

    ResolveInput input_ = input();
};

TEST_F(FillBlocksTest, ThePassComesBeforeTheGraph) {
    add({member("a"), member("b")});
    graph.consts = {{"a", expression("1")}, {"b", expression("2")}};
    values.by_name = {{"a", number_value(1)}, {"b", number_value(2)}};
    ParamValueDesc& given = graph.passes["fill"].params.emplace_back();
    given.name = "b";
    given.components = {expression("a + 6")};
    const PassBlock found = run();
    EXPECT_EQ(codes(), "");
    ASSERT_EQ(found.params.size(), 2u);
    EXPECT_EQ(found.params[0].value[0], 1);
    EXPECT_EQ(found.params[1].value[0], 7);
    EXPECT_EQ(found.params[1].offset_bytes, 4u);
    EXPECT_EQ(found.bytes, 8u);
}

TEST_F(FillBlocksTest, APortHasItsSize) {
    const PassId fill = add({member("dstSize", 2)});
    add_use(fill, "dst", add_image("x"), Access::storage_write);
    shapes.resources[0].extent = {12, 34, 1};
    const PassBlock found = run();
    ASSERT_EQ(found.params.size(), 1u);
    EXPECT_EQ(found.params[0].value[0], 12);
    EXPECT_EQ(found.params[0].value[1], 34);
}

TEST_F(FillBlocksTest, ABuiltInIsLeftToTheExecutor) {
    add({member("time")});
    EXPECT_EQ(run().params.at(0).builtin, Builtin::time_s);
}

TEST_F(FillBlocksTest, AMemberWithoutAValueIsAFault) {
    add({member("nothing")});
    EXPECT_TRUE(run().params.empty());
    EXPECT_EQ(codes(), "W113");
}

TEST_F(FillBlocksTest, AMissingPortOfAFaultyPassIsNotReportedAgain) {
    add({member("dstSize", 2)});
    Suspects all = suspects();
    all.passes[0] = 1;
    (void)fill_blocks({input_, values, shapes, expansion}, versioned(), all, reporter);
    EXPECT_EQ(codes(), "");
}

}  // namespace
}  // namespace weft::test
