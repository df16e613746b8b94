#include "graph/resolve/attach.h"

#include "tests/graph/resolve/stage_fixture.h"

namespace weft::test {
namespace {

class AttachTest : public StageTest {
 protected:
    AttachTest() {
        shaders["draw"] = fragment({"color", "normal"});
        draw = add_pass("draw", PassKind::fullscreen);
    }

    void add_color(size_t output, ResourceId resource) {
        const StageVariable& variable = shaders["draw"].interface.fragment_outputs[output];
        add_use(draw, variable.name, resource, Access::color_write);
        bound[draw].ports.back().color_output = &variable;
    }
    PassAttachments run() {
        return attach({input_, values, shapes, expansion}, versioned(), reporter).passes[draw];
    }

    PassId draw = kNoId;
    ResolveInput input_ = input();
};

TEST_F(AttachTest, ColoursComeInTheOrderOfTheirLocations) {
    add_color(1, add_image("a"));
    add_color(0, add_image("b"));
    const PassAttachments found = run();
    EXPECT_EQ(codes(), "");
    ASSERT_EQ(found.colors.size(), 2u);
    EXPECT_EQ(found.colors[0].location, 0u);
    EXPECT_EQ(found.colors[0].use, 1u);
    EXPECT_EQ(found.colors[1].use, 0u);
    EXPECT_EQ(found.render_extent, (Extent3D{16, 16, 1}));
}

TEST_F(AttachTest, TheExtentIsThatOfTheMip) {
    const ResourceId x = add_image("x");
    shapes.resources[x].mips = 3;
    add_color(0, x);
    bound[draw].uses[0].range.mip = 2;
    EXPECT_EQ(run().render_extent, (Extent3D{4, 4, 1}));
}

TEST_F(AttachTest, AttachmentsOfDifferentSizesAreAFaultUnlessOneIsSuspect) {
    const ResourceId x = add_image("x");
    const ResourceId y = add_image("y");
    shapes.resources[y].extent = {8, 8, 1};
    add_color(0, x);
    add_color(1, y);
    shapes.suspects.shapes[y] = 1;
    (void)run();
    EXPECT_EQ(codes(), "");
    shapes.suspects.shapes[y] = 0;
    (void)run();
    EXPECT_EQ(codes(), "W174");
}

TEST_F(AttachTest, AFreshWriteCoversUnlessThePassClears) {
    add_color(0, add_image("x"));
    EXPECT_TRUE(run().colors[0].covers);
    graph.passes["draw"].clear =
        ColorDesc{{expression("1"), expression("0.5"), expression("0"), expression("1")}};
    const PassAttachments found = run();
    EXPECT_FALSE(found.colors[0].covers);
    EXPECT_EQ(found.colors[0].clear, (std::array<float, 4>{1, 0.5, 0, 1}));
}

TEST_F(AttachTest, AClearValueMayUseTheIndexOfTheRepeat) {
    add_color(0, add_image("x"));
    graph.passes["draw"].clear =
        ColorDesc{{expression("i / 4"), expression("0"), expression("0"), expression("1")}};
    expansion.passes[draw].indices = {{"i", 3}};
    EXPECT_EQ(run().colors[0].clear, (std::array<float, 4>{0.75, 0, 0, 1}));
    EXPECT_EQ(codes(), "");
}

TEST_F(AttachTest, AnAttachmentIsOneMipOfOneLayer) {
    const ResourceId x = add_image("x");
    shapes.resources[x].layers = 6;
    add_color(0, x);
    bound[draw].uses[0].range.layers = 6;
    (void)run();
    EXPECT_EQ(codes(), "W169");
}

TEST_F(AttachTest, TheDepthPortIsTheDepthAttachment) {
    add_use(draw, "depth", add_image("x", "d32f"), Access::depth_write);
    bound[draw].ports.back().is_depth_port = true;
    const PassAttachments found = run();
    EXPECT_EQ(codes(), "");
    ASSERT_TRUE(found.depth.has_value());
    EXPECT_EQ(found.depth->use, 0u);
    EXPECT_TRUE(found.colors.empty());
}

TEST_F(AttachTest, APassWithoutAttachmentsIsAFault) {
    (void)run();
    EXPECT_EQ(codes(), "W181");
}

}  // namespace
}  // namespace weft::test
