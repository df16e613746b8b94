#include "graph/resolve/evaluate.h"

#include "tests/graph/resolve/stage_fixture.h"

namespace weft::test {
namespace {

class EvaluateTest : public StageTest {
 protected:
    void add_param(const std::string& name, double default_value) {
        ParamDesc& param = graph.params[name];
        param.name = name;
        param.default_value = default_value;
        param.range = {0, 10};
    }
};

TEST_F(EvaluateTest, ConstantsAndSizesMayNameLaterOnes) {
    graph.consts["a"] = expression("2 * b");
    graph.consts["b"] = expression("3");
    graph.sizes["half"] = expression("output / (a - 4)");
    const Values found = evaluate(input(), reporter);
    EXPECT_EQ(codes(), "");
    EXPECT_EQ(found.by_name.at("a"), number_value(6));
    EXPECT_EQ(found.by_name.at("half"), size_value(32, 16));
}

TEST_F(EvaluateTest, AnOverrideReplacesTheDefault) {
    add_param("light", 1);
    add_param("fog", 2);
    params = {{"light", 5}};
    const Values found = evaluate(input(), reporter);
    ASSERT_EQ(found.params.size(), 2u);
    EXPECT_EQ(found.params[0].value, 2);
    EXPECT_EQ(found.params[1].value, 5);
    EXPECT_EQ(found.by_name.at("light"), number_value(5));
}

TEST_F(EvaluateTest, NamesOfAFaultyParameterAreFaultyWithoutAMessageOfTheirOwn) {
    add_param("light", 11);
    graph.consts["twice"] = expression("2 * light");
    const Values found = evaluate(input(), reporter);
    EXPECT_EQ(codes(), "W120");
    EXPECT_TRUE(found.faulty.contains("light"));
    EXPECT_TRUE(found.faulty.contains("twice"));
}

TEST_F(EvaluateTest, SizesThatDependOnEachOtherAreOneFault) {
    graph.sizes["a"] = expression("b");
    graph.sizes["b"] = expression("c");
    graph.sizes["c"] = expression("a");
    const Values found = evaluate(input(), reporter);
    ASSERT_EQ(codes(), "W106");
    EXPECT_EQ(errors.front().message, "sizes depend on each other: a -> b -> c -> a");
    EXPECT_EQ(found.faulty.size(), 3u);
}

TEST_F(EvaluateTest, TheDrawsOfAnImportedListAreANumber) {
    graph.imports["opaque"] = {.name = "opaque", .kind = "drawlist", .loc = {}};
    imports.imports["opaque"].draws = 7;
    EXPECT_EQ(evaluate(input(), reporter).by_name.at("opaqueDraws"), number_value(7));
}

TEST_F(EvaluateTest, FramesAreAWholeNumber) {
    graph.frames = expression("2 + 2");
    EXPECT_EQ(evaluate(input(), reporter).frames, 4u);
    graph.frames = expression("5 / 2");
    EXPECT_EQ(evaluate(input(), reporter).frames, 1u);
    EXPECT_EQ(codes(), "W109");
}

}  // namespace
}  // namespace weft::test
