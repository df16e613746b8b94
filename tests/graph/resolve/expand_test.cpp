#include "graph/resolve/expand.h"

#include "tests/graph/resolve/stage_fixture.h"

namespace weft::test {
namespace {

class ExpandTest : public StageTest {
 protected:
    PassDesc& describe_repeat(const std::string& name, const std::string& first, const std::string& last) {
        PassDesc& desc = describe_pass(name, "clear");
        RepeatDesc& repeat = desc.repeat.emplace_back();
        repeat.index = "i";
        repeat.first = expression(first);
        repeat.last = expression(last);
        return desc;
    }
    Expansion run() { return expand(input(), values, shapes, reporter); }
};

TEST_F(ExpandTest, ARepeatIsOnePassForEachIndex) {
    describe_pass("after", "clear");
    describe_repeat("blur", "1", "3");
    const Expansion found = run();
    ASSERT_EQ(found.passes.size(), 4u);
    EXPECT_EQ(found.passes[2].decl.name, "blur#2");
    EXPECT_EQ(found.passes[2].indices.at("i"), 2);
    EXPECT_EQ(found.passes[2].instance, 1u);
    EXPECT_EQ(found.instances.at("blur"), (std::vector<PassId>{1, 2, 3}));
}

TEST_F(ExpandTest, AFalseConditionLeavesThePassOut) {
    describe_pass("gone", "clear").condition = expression("1 - 1");
    describe_pass("here", "clear").condition = expression("1");
    const Expansion found = run();
    ASSERT_EQ(found.passes.size(), 1u);
    EXPECT_EQ(found.passes[0].decl.name, "here");
    EXPECT_TRUE(found.dropped.contains("gone"));
    EXPECT_TRUE(found.instances.at("gone").empty());
}

TEST_F(ExpandTest, AFaultOfARepeatIsReportedOnce) {
    describe_repeat("blur", "0", "9").flops = expression("i * nothing");
    EXPECT_EQ(run().passes.size(), 10u);
    EXPECT_EQ(codes(), "W107");
}

TEST_F(ExpandTest, AFaultyConditionMakesTheWritersOfItsOutputsSuspect) {
    const ResourceId x = add_image("x");
    PassDesc& desc = describe_pass("maybe", "clear");
    desc.condition = expression("nothing");
    desc.out.push_back(port("out", "x"));
    const Expansion found = run();
    EXPECT_EQ(codes(), "W107");
    EXPECT_TRUE(found.faulty.contains("maybe"));
    EXPECT_EQ(found.suspects.writers[x], 1);
}

TEST_F(ExpandTest, TooManyPassesAreOneFault) {
    limits.passes = 5;
    describe_repeat("a", "1", "4");
    describe_repeat("b", "1", "4");
    describe_repeat("c", "1", "4");
    EXPECT_TRUE(run().too_large);
    EXPECT_EQ(codes(), "W125");
}

TEST_F(ExpandTest, PassesGetTheirKindAndShader) {
    shaders["fill"] = compute({});
    shaders["draw"] = fragment({});
    describe_pass("a").shader = "fill";
    describe_pass("b").shader = "draw";
    describe_pass("c", "dance");
    const Expansion found = run();
    EXPECT_EQ(codes(), "W177 W115");
    EXPECT_EQ(found.passes[0].shader, &shaders["fill"].interface);
    EXPECT_EQ(found.passes[1].shader, nullptr);
    EXPECT_EQ(found.suspects.passes, (std::vector<uint8_t>{0, 1, 1}));
}

TEST_F(ExpandTest, AnObservedReferenceIsAReadback) {
    observed = {"x.mip(1)"};
    const Expansion found = run();
    ASSERT_EQ(found.passes.size(), 1u);
    EXPECT_EQ(found.passes[0].decl.kind, PassKind::readback);
    EXPECT_TRUE(found.passes[0].decl.side_effect);
    EXPECT_TRUE(found.passes[0].is_observer);
}

TEST_F(ExpandTest, PassesOfARepeatAreSlicedOverFrames) {
    describe_repeat("probe", "0", "4").per_frame = expression("2");
    const Expansion found = run();
    EXPECT_EQ(found.passes[4].decl.frame_slice, 2u);
    EXPECT_EQ(found.passes[4].decl.frame_slices, 3u);
}

}  // namespace
}  // namespace weft::test
