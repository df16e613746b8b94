// Tests passes that `if` removes, the ports that read from such passes, and specialisation constants.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveConditions : public ResolveTest {
 protected:
    ResolveConditions() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["copy.comp"] = compute({sampled("src"), image_out("dst")});
        shaders["update.comp"] = compute({image_in_out("x")});
        shaders["maybe.comp"] =
            with_constants(compute({sampled("src"), image_out("dst")}), {{"HAS_src", ScalarType::boolean}});
        shaders["add.frag"] = fragment({"color"});
    }

    // Returns a graph in which pass "maker" writes x if parameter "on" is true. `src` is the JSON text of the
    // input of pass "reader", and `more` contains further passes.
    std::string graph(const std::string& src, const std::string& more = "",
                      const std::string& shader = "copy.comp") {
        return R"j("params": {"on": false},
"resources": {"x": "rgba16f", "y": "rgba16f", "z": "rgba16f"}, "passes": {
"maker": {"type": "compute", "shader": "make.comp", "if": "on", "out": {"dst": "x"}},)j" +
               more + R"j(
"other": {"type": "compute", "shader": "make.comp", "out": {"dst": "z"}},
"reader": {"type": "compute", "shader": ")j" +
               shader + R"j(", "in": {"src": )j" + src + R"j(}, "out": {"dst": "y"}}})j";
    }
    static uint32_t constant(const ResolvedGraph& g, const char* pass, uint32_t id) {
        for (const SpecValue& value : pass_in(g, pass).spec_values) {
            if (value.id == id) return value.bits;
        }
        ADD_FAILURE() << "no constant " << id;
        return 0;
    }
};

TEST_F(ResolveConditions, AFalseConditionLeavesThePassOut) {
    observed = {"y"};
    EXPECT_EQ(find_pass(good(graph(R"j("z")j")), "maker"), kNoId);
    EXPECT_TRUE(warnings.empty()) << "its resources are not unused for good";
    params["on"] = 1;
    EXPECT_NE(find_pass(good(graph(R"j("z")j")), "maker"), kNoId);
}

TEST_F(ResolveConditions, ConditionsAreNumbers) {
    const auto with = [](const std::string& condition) {
        return R"j("resources": {"x": "rgba16f"}, "passes": {
"a": {"type": "clear", "out": ["x"], "if": )j" +
               condition + "}}";
    };
    EXPECT_NE(find_pass(good(with("true")), "a"), kNoId);
    EXPECT_EQ(find_pass(good(with("0")), "a"), kNoId);
    EXPECT_EQ(find_pass(good(with("\"max(0, output.x - 640)\"")), "a"), kNoId);
    const Diagnostic size = bad(with("\"output\""));
    EXPECT_EQ(size.code, "W106");
    expect_help(size, ".x or .y");
    const Diagnostic unknown = bad(with("\"outptu.x\""));
    EXPECT_EQ(unknown.code, "W107");
    EXPECT_EQ(unknown.line, 2u);
}

TEST_F(ResolveConditions, AReaderOfNothingIsAnError) {
    const Diagnostic d = bad(graph(R"j("x")j"));
    EXPECT_EQ(d.code, "W123");
    EXPECT_EQ(d.line, 5u);
    EXPECT_NE(d.message.find("only \"maker\" writes"), std::string::npos) << d.message;
    ASSERT_EQ(d.notes.size(), 1u);
    EXPECT_EQ(d.notes[0].line, 3u);
    expect_help(d, R"j("else")j");
    expect_help(d, "HAS_src");
    expect_help(d, R"j("if": "on")j");
    params["on"] = 1;
    good(graph(R"j("x")j"));
}

TEST_F(ResolveConditions, ElseIsReadInstead) {
    const std::string body = graph(R"j({"ref": "x", "else": "z"})j");
    EXPECT_EQ(seen(good(body), "reader", "src"), "other");
    EXPECT_EQ(good(body).resources[use(good(body), "reader", "src").resource].name, "z");
    params["on"] = 1;
    EXPECT_EQ(seen(good(body), "reader", "src"), "maker");
}

TEST_F(ResolveConditions, ElseMustBeThere) {
    const Diagnostic d = bad(graph(R"j({"ref": "x", "else": "zz"})j"));
    EXPECT_EQ(d.code, "W103");
    expect_help(d, "did you mean");
}

TEST_F(ResolveConditions, OptionalPortsAreLeftOut) {
    const std::string body = graph(R"j({"ref": "x", "optional": true})j", "", "maybe.comp");
    const ResolvedGraph off = good(body);
    EXPECT_EQ(pass_in(off, "reader").uses.size(), 1u);
    EXPECT_EQ(constant(off, "reader", 0), 0u);
    params["on"] = 1;
    const ResolvedGraph on = good(body);
    EXPECT_EQ(pass_in(on, "reader").uses.size(), 2u);
    EXPECT_EQ(constant(on, "reader", 0), 1u);
}

TEST_F(ResolveConditions, OptionalTakesASwitch) {
    const Diagnostic d = bad(graph(R"j({"ref": "z", "optional": true})j"));
    EXPECT_EQ(d.code, "W168");
    expect_help(d, "const bool HAS_src");
    // The shader "maybe.comp" has the constant HAS_src and could run without the port "src". But the port is
    // optional only if the graph contains "optional": true.
    EXPECT_EQ(bad(graph(R"j("x")j", "", "maybe.comp")).code, "W123");
    const Diagnostic copy = bad(R"j("resources": {"x": "rgba16f", "y": "rgba16f"}, "passes": {
      "c": {"type": "clear", "out": ["x"]},
      "d": {"type": "copy", "in": {"src": {"ref": "x", "optional": true}}, "out": ["y"]}})j");
    EXPECT_EQ(copy.code, "W168");
}

TEST_F(ResolveConditions, MembersOfAnAbsentPort) {
    shaders["maybe.comp"] =
        with_params(std::move(shaders["maybe.comp"]), {member("srcSize", 2), member("srcValid")});
    const ResolvedGraph g = good(graph(R"j({"ref": "x", "optional": true})j", "", "maybe.comp"));
    ASSERT_EQ(pass_in(g, "reader").params.size(), 2u);
    EXPECT_EQ(pass_in(g, "reader").params[0].value[0], 0.0);
    EXPECT_EQ(pass_in(g, "reader").params[1].value[0], 0.0);
    EXPECT_EQ(pass_in(g, "reader").params[1].builtin, Builtin::none);
}

// A pass may also omit an optional port, as if the port had no resource.
TEST_F(ResolveConditions, MembersOfAPortThatThePassOmits) {
    shaders["maybe.comp"] =
        with_params(std::move(shaders["maybe.comp"]), {member("srcSize", 2), member("srcValid")});
    const std::string without = R"j("resources": {"y": "rgba16f"}, "passes": {
"reader": {"type": "compute", "shader": "maybe.comp", "in": {}, "out": {"dst": "y"}}})j";
    const ResolvedGraph g = good(without);
    ASSERT_EQ(pass_in(g, "reader").params.size(), 2u);
    for (const ParamWrite& write : pass_in(g, "reader").params) {
        EXPECT_EQ(write.value[0], 0.0);
        EXPECT_EQ(write.builtin, Builtin::none);
    }
    shaders["maybe.comp"] =
        with_params(std::move(shaders["maybe.comp"]), {member("dstValid"), member("otherValid")});
    EXPECT_EQ(bad(without).code, "W113") << "the shader has no constant HAS_other";
}

TEST_F(ResolveConditions, SkippingAnInPlacePassPassesTheVersionOn) {
    const std::string body =
        R"j("params": {"on": false}, "resources": {"x": "rgba16f", "y": "rgba16f"}, "passes": {
      "maker": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
      "fog": {"type": "compute", "shader": "update.comp", "if": "on", "in": ["x"], "out": ["x"]},
      "reader": {"type": "compute", "shader": "copy.comp", "in": {"src": "x"}, "out": {"dst": "y"}},
      "pinned": {"type": "readback", "in": ["x@fog"]}})j";
    EXPECT_EQ(seen(good(body), "reader", "src"), "maker");
    EXPECT_EQ(seen(good(body), "pinned", "x"), "maker");
    params["on"] = 1;
    EXPECT_EQ(seen(good(body), "reader", "src"), "fog");
    EXPECT_EQ(seen(good(body), "pinned", "x"), "fog");
}

TEST_F(ResolveConditions, APinOfAPassWithAFaultyConditionAddsNoError) {
    const Diagnostic d = bad(R"j("resources": {"x": "rgba16f"}, "passes": {
      "maker": {"type": "clear", "out": ["x"]},
      "fog": {"type": "clear", "if": "outptu.x", "out": {"x": "x@maker"}},
      "pinned": {"type": "readback", "in": ["x@fog"]}})j");
    EXPECT_EQ(d.code, "W107");
    EXPECT_EQ(d.line, 3u);
}

TEST_F(ResolveConditions, APinOfADroppedPassFollowsItsOwnPin) {
    const auto body = [](const std::string& fog) {
        return R"j("resources": {"x": "rgba16f"}, "passes": {
"maker": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
"fog": {"type": "compute", "shader": "update.comp", "if": false, "in": )j" +
               fog + R"j(, "out": ["x"]},
"rain": {"type": "compute", "shader": "update.comp", "in": ["x"], "out": ["x"]},
"pinned": {"type": "readback", "in": ["x@fog"]}})j";
    };
    EXPECT_EQ(seen(good(body(R"j(["x@maker"])j")), "pinned", "x"), "maker");
    // Several passes write "x", and the input of the removed pass `fog` has no pin such as "x@maker". So
    // resolve() cannot know which version of "x" replaces the output of `fog`.
    const Diagnostic d = bad(body(R"j(["x"])j"));
    EXPECT_EQ(d.code, "W123");
    EXPECT_EQ(d.line, 5u);
    expect_help(d, R"j("else")j");
}

TEST_F(ResolveConditions, AlternativesWriteTheSame) {
    const std::string body = graph(R"j("x")j", R"j(
"second": {"type": "compute", "shader": "copy.comp", "if": "1 - on", "in": {"src": "z"}, "out": {"dst": "x"}},)j");
    EXPECT_EQ(seen(good(body), "reader", "src"), "second");
    params["on"] = 1;
    EXPECT_EQ(seen(good(body), "reader", "src"), "maker");
}

TEST_F(ResolveConditions, AfterADroppedPassIsVoid) {
    const std::string body =
        graph(R"j("z")j", R"j("late": {"type": "clear", "out": ["x"], "after": ["maker"]},)j");
    EXPECT_TRUE(good(body).edges.size() == 1u);
}

TEST_F(ResolveConditions, HistoryOfADroppedWriterStays) {
    const ResolvedGraph g = good(R"j("resources": {"x": {"format": "rgba16f", "history": 1}, "y": "rgba16f"},
      "passes": {
      "m": {"type": "compute", "shader": "make.comp", "if": false, "out": {"dst": "x"}},
      "r": {"type": "compute", "shader": "copy.comp", "in": {"src": "x[-1]"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(seen(g, "r", "src"), "before");
}

TEST_F(ResolveConditions, AFaultyConditionIsTheOnlyFault) {
    const Diagnostic d = bad(R"j("resources": {"x": "rgba16f", "y": "rgba16f"}, "passes": {
      "m": {"type": "compute", "shader": "make.comp", "if": "onn", "out": {"dst": "x"}},
      "r": {"type": "compute", "shader": "copy.comp", "in": {"src": "x@m"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(d.code, "W107");
}

TEST_F(ResolveConditions, ASpecialisationConstantIsANumberOfTheScene) {
    imports.numbers = {{"lamps", 3}};
    shaders["make.comp"] = with_constants(compute({image_out("dst")}), {{"lamps", ScalarType::u32}});
    const std::string body = R"j("resources": {"x": "rgba16f"}, "passes": {
"m": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}}})j";
    EXPECT_EQ(constant(good(body), "m", 0), 3u);
    EXPECT_EQ(constant(good(R"j("consts": {"lamps": 5}, )j" + body), "m", 0), 5u)
        << "the graph's own comes first";
}

TEST_F(ResolveConditions, SpecialisationConstants) {
    shaders["make.comp"] = with_constants(compute({image_out("dst")}), {{"N", ScalarType::u32},
                                                                        {"K", ScalarType::f32},
                                                                        {"FAST", ScalarType::boolean},
                                                                        {"taps", ScalarType::i32}});
    const auto body = [](const std::string& constants) {
        return R"j("params": {"taps": 4}, "resources": {"x": "rgba16f"}, "passes": {
"m": {"type": "compute", "shader": "make.comp", "constants": {)j" +
               constants + R"j(}, "out": {"dst": "x"}}})j";
    };
    const ResolvedGraph g = good(body(R"j("N": "taps * 2", "K": 0.5, "FAST": true)j"));
    EXPECT_EQ(constant(g, "m", 0), 8u);
    EXPECT_EQ(constant(g, "m", 1), 0x3F000000u);
    EXPECT_EQ(constant(g, "m", 2), 1u);
    EXPECT_EQ(constant(g, "m", 3), 4u) << "parameters of the graph, as in Params";
    const Diagnostic missing = bad(body(R"j("N": 1, "FAST": true)j"));
    EXPECT_EQ(missing.code, "W113");
    expect_help(missing, R"j("constants": { "K": 0 })j");
    const Diagnostic unknown = bad(body(R"j("N": 1, "K": 1, "FAST": true, "FASTT": true)j"));
    EXPECT_EQ(unknown.code, "W113");
    EXPECT_EQ(unknown.line, 2u);
    expect_help(unknown, "did you mean \"FAST\"");
    EXPECT_EQ(bad(body(R"j("N": -1, "K": 1, "FAST": true)j")).code, "W113");
    EXPECT_EQ(bad(body(R"j("N": 1.5, "K": 1, "FAST": true)j")).code, "W113");
}

TEST_F(ResolveConditions, SwitchesAreNotSetByHand) {
    std::string body = graph(R"j("z")j", "", "maybe.comp");
    body.insert(body.rfind(R"j("in")j"), R"j("constants": {"HAS_src": true}, )j");
    const Diagnostic d = bad(body);
    EXPECT_EQ(d.code, "W113");
    expect_help(d, "remove the port");
}

}  // namespace
}  // namespace weft::test
