#include "graph/resolve/bind.h"

#include "tests/graph/resolve/stage_fixture.h"

namespace weft::test {
namespace {

class BindTest : public StageTest {
 protected:
    BindTest() {
        shaders["make"] = compute({image_out("dst")});
        shaders["mix"] = compute({sampled("src"), image_out("dst")});
        x = add_image("x");
        y = add_image("y");
    }

    // Adds a compute pass with these ports. The shader has the same name as the pass.
    PassId add(const std::string& name, const std::vector<PortDesc>& in, const std::vector<PortDesc>& out) {
        PassDesc& desc = describe_pass(name);
        desc.in = in;
        desc.out = out;
        return add_pass(name);
    }
    BoundPasses run() {
        expansion.suspects = suspects();
        return bind({input_, values, shapes, expansion}, reporter);
    }

    ResourceId x = kNoId, y = kNoId;
    ResolveInput input_ = input();
};

TEST_F(BindTest, TheShaderSaysHowAPortIsAccessed) {
    const PassId make = add("make", {}, {port("dst", "x")});
    const PassId mix = add("mix", {port("src", "x")}, {port("dst", "y")});
    const BoundPasses found = run();
    EXPECT_EQ(codes(), "");
    EXPECT_EQ(found.passes[make].uses[0].access, Access::storage_write);
    ASSERT_EQ(found.passes[mix].uses.size(), 2u);
    EXPECT_EQ(found.passes[mix].uses[0].access, Access::sampled_read);
    EXPECT_EQ(found.passes[mix].uses[0].resource, x);
    EXPECT_EQ(found.passes[mix].uses[1].binding, 1u);
    EXPECT_EQ(found.passes[mix].ports[1].rank, WriteRank::fresh);
}

TEST_F(BindTest, PortsAndBindingsMustHaveEachOther) {
    add("make", {}, {port("dst", "x"), port("extra", "y")});
    add("mix", {}, {port("dst", "y")});
    const BoundPasses found = run();
    EXPECT_EQ(codes(), "W170 W171");
    EXPECT_EQ(found.suspects.passes, (std::vector<uint8_t>{1, 1}));
}

TEST_F(BindTest, APinMeansThePassOfThatName) {
    const PassId make = add("make", {}, {port("dst", "x")});
    const PassId mix = add("mix", {port("src", "x@make")}, {port("dst", "y")});
    const BoundPasses found = run();
    EXPECT_EQ(found.passes[mix].ports[0].pins, std::vector<PassId>{make});
    EXPECT_TRUE(found.passes[make].ports[0].pins.empty());
}

TEST_F(BindTest, AMisspeltOutputMakesTheWritersOfItsNeighbourSuspect) {
    const ResourceId shadow = add_image("zshadow");
    add("make", {}, {port("dst", "zshadwo")});
    EXPECT_EQ(run().suspects.writers[shadow], 1);
    EXPECT_EQ(codes(), "W103");
}

TEST_F(BindTest, WhereItsWriterIsLeftOutAnInputTakesItsElse) {
    PassDesc gone;
    gone.name = "gone";
    gone.out.push_back(port("dst", "x"));
    expansion.dropped["gone"] = &gone;
    add("make", {}, {port("dst", "y")});
    PortDesc either = port("src", "x");
    either.otherwise = reference("y");
    const PassId mix = add("mix", {either}, {port("dst", "y.mip(0)")});
    const BoundPasses found = run();
    EXPECT_EQ(codes(), "");
    EXPECT_EQ(found.passes[mix].uses[0].resource, y);
}

TEST_F(BindTest, AnOptionalInputMayBeAbsent) {
    PassDesc gone;
    gone.name = "gone";
    gone.out.push_back(port("dst", "x"));
    expansion.dropped["gone"] = &gone;
    shaders["mix"] = with_constants(std::move(shaders["mix"]), {{"HAS_src", ScalarType::boolean}});
    PortDesc optional = port("src", "x");
    optional.optional = true;
    const PassId mix = add("mix", {optional}, {port("dst", "y")});
    const BoundPasses found = run();
    EXPECT_EQ(codes(), "");
    EXPECT_EQ(found.passes[mix].absent, std::vector<std::string>{"src"});
    ASSERT_EQ(found.passes[mix].spec_values.size(), 1u);
    EXPECT_EQ(found.passes[mix].spec_values[0].bits, 0u);
}

TEST_F(BindTest, ARangeBeyondTheMipsIsAFault) {
    add("make", {}, {port("dst", "x.mip(1)")});
    EXPECT_TRUE(run().passes[0].uses.empty());
    EXPECT_EQ(codes(), "W105");
}

}  // namespace
}  // namespace weft::test
