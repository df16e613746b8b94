#include "graph/resolve/choose_formats.h"

#include "tests/graph/resolve/stage_fixture.h"

namespace weft::test {
namespace {

class ChooseFormatsTest : public StageTest {
 protected:
    FormattedGraph run() {
        Suspects all = suspects();
        return choose_formats({input_, values, shapes, expansion}, {bound, std::move(all)}, reporter);
    }

    ResolveInput input_ = input();
};

TEST_F(ChooseFormatsTest, TakesTheFirstFormatThatCanDoAllThatPassesAskFor) {
    const ResourceId x = add_image("x");
    graph.resources["x"].formats = {"rgba16f", "rgba8"};
    profile.formats[Format::rgba16f] &= ~format_feature::kStorage;
    add_use(add_pass("write"), "dst", x, Access::storage_write);
    const FormattedGraph found = run();
    EXPECT_EQ(codes(), "");
    EXPECT_EQ(found.resources[x].format, Format::rgba8);
    EXPECT_EQ(found.resources[x].usage, usage::kStorage);
}

TEST_F(ChooseFormatsTest, AnImageThatNoPassWritesKeepsItsFirstFormat) {
    const ResourceId x = add_image("x");
    graph.resources["x"].formats = {"rgba16f", "rgba8"};
    profile.formats[Format::rgba16f] &= ~format_feature::kStorage;
    EXPECT_EQ(run().resources[x].format, Format::rgba16f);
}

TEST_F(ChooseFormatsTest, WithoutASupportedFormatTheShapeIsSuspect) {
    const ResourceId x = add_image("x", "d32f");
    add_use(add_pass("write"), "dst", x, Access::storage_write);
    EXPECT_EQ(run().suspects.shapes[x], 1);
    ASSERT_EQ(codes(), "W117");
    ASSERT_FALSE(errors.front().help.empty());
    EXPECT_EQ(errors.front().help.front(), "\"d32f\" does not support storage images");
}

TEST_F(ChooseFormatsTest, AspectsFollowFromTheFormat) {
    const ResourceId x = add_image("x", "d32f_s8");
    const PassId draw = add_pass("draw");
    add_use(draw, "read", x, Access::sampled_read).range.aspects = aspect::kNone;
    add_use(draw, "depth", x, Access::depth_write).range.aspects = aspect::kNone;
    const FormattedGraph found = run();
    EXPECT_EQ(found.resources[x].aspects, aspect::kDepth | aspect::kStencil);
    EXPECT_EQ(found.passes[draw].uses[0].range.aspects, aspect::kDepth) << "a sampled view shows one aspect";
    EXPECT_EQ(found.passes[draw].uses[1].range.aspects, aspect::kDepth | aspect::kStencil);
}

TEST_F(ChooseFormatsTest, TheDefaultSamplerOfIntegersIsNearest) {
    const ResourceId x = add_image("x", "r32u");
    const PassId read = add_pass("read");
    add_use(read, "src", x, Access::sampled_read);
    const FormattedGraph found = run();
    EXPECT_EQ(codes(), "");
    EXPECT_EQ(found.passes[read].uses[0].sampler.filter, SamplerFilter::nearest);
}

TEST_F(ChooseFormatsTest, AnImageBeyondTheMemoryLimitIsSuspect) {
    const ResourceId x = add_image("x");
    shapes.resources[x].extent = {4096, 4096, 1};
    limits.transient_bytes = 1 << 20;
    input_.limits = limits;
    EXPECT_EQ(run().suspects.shapes[x], 1);
    EXPECT_EQ(codes(), "W125");
}

}  // namespace
}  // namespace weft::test
