#include "graph/resolve/shape_resources.h"

#include "tests/graph/resolve/stage_fixture.h"

namespace weft::test {
namespace {

using ShapeResourcesTest = StageTest;

TEST_F(ShapeResourcesTest, AnImageHasTheSizeOfTheOutputUnlessItSaysMore) {
    describe_image("a");
    describe_image("b").size = expression("output / 4");
    const Shapes found = shape_resources(input(), values, reporter);
    ASSERT_EQ(found.resources.size(), 2u);
    EXPECT_EQ(found.resources[0].extent, (Extent3D{64, 32, 1}));
    EXPECT_EQ(found.resources[1].extent, (Extent3D{16, 8, 1}));
}

TEST_F(ShapeResourcesTest, MipsOfALaterImageAreKnown) {
    describe_image("a").layers = expression("mips(b)");
    describe_image("b").full_mips = true;
    const Shapes found = shape_resources(input(), values, reporter);
    EXPECT_EQ(codes(), "");
    EXPECT_EQ(found.mip_counts.at("b"), 7u);
    EXPECT_EQ(found.resources[0].layers, 7u);
}

TEST_F(ShapeResourcesTest, HistoryMakesARingOfRoles) {
    describe_image("a").history = expression("2");
    const Shapes found = shape_resources(input(), values, reporter);
    ASSERT_EQ(found.resources.size(), 3u);
    EXPECT_EQ(resource_id(found.resources, "a[-2]"), 2u);
    EXPECT_EQ(found.resources[2].age, 2u);
    EXPECT_EQ(found.resources[2].extent, found.resources[0].extent);
    EXPECT_FALSE(found.origins[0].has_content) << "this frame's role begins empty";
    EXPECT_TRUE(found.origins[2].has_content);
}

TEST_F(ShapeResourcesTest, AFaultMakesTheShapeSuspectAndItsMipsUnknown) {
    describe_image("a").layers = expression("mips(b)");
    describe_image("b").size = expression("0");
    const Shapes found = shape_resources(input(), values, reporter);
    EXPECT_EQ(codes(), "W109") << "one cause, one message";
    EXPECT_EQ(found.suspects.shapes, (std::vector<uint8_t>{1, 1}));
}

TEST_F(ShapeResourcesTest, AnImportTakesTheShapeThatTheProgramOffers) {
    graph.imports["noise"] = {.name = "noise", .kind = "image", .loc = {}};
    graph.imports["nothing"] = {.name = "nothing", .kind = "image", .loc = {}};
    const Shapes found = shape_resources(input(), values, reporter);
    EXPECT_EQ(codes(), "W118");
    EXPECT_EQ(found.resources[0].format, Format::rgba8);
    EXPECT_TRUE(found.origins[0].has_content);
    EXPECT_EQ(found.suspects.writers, (std::vector<uint8_t>{0, 1}));
}

}  // namespace
}  // namespace weft::test
