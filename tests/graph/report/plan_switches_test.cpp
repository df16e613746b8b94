// Tests what the texts and the page of a plan tell about switches.
#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_switches.h"
#include "weft/compile.h"
#include "weft/report/plan_dump.h"
#include "weft/report/plan_explain.h"

namespace weft::test {
namespace {

class PlanSwitches : public ResolveTest {
 protected:
    PlanSwitches() {
        shaders = switch_shaders();
        const ResolvedGraph graph = good(R"("params": {"fog": true, "rain": true}, "resources": {
            "x": {"format": "rgba16f", "size": 64}, "y": {"format": "rgba16f", "size": 64},
            "kept": {"format": "rgba16f", "size": 64, "keep": true}, "z": {"format": "rgba16f", "size": 64}},
            "passes": {
                "base": {"type": "compute", "shader": "s0.comp", "out": {"dst": "x"}},
                "over": {"type": "compute", "shader": "s0.comp", "out": {"dst": "x"}, "switch": "!rain"},
                "make": {"type": "compute", "shader": "s0.comp", "out": {"dst": "y"}, "switch": "fog"},
                "store": {"type": "compute", "shader": "s0.comp", "out": {"dst": "kept"}, "switch": "rain"},
                "read": {"type": "compute", "shader": "v2.comp", "in": {"a": "kept", "b": {"ref": "y", "else": "x"}},
                         "out": {"dst": "z"}},
                "see": {"type": "readback", "in": ["z"]}})");
        plan_ = compile(graph, content_needs(graph), {});
    }

    static bool has(const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    }
    std::string explained(const char* pass) {
        const Result<std::string> text = explain_switch(plan_, pass);
        return text ? *text : to_text(text.errors());
    }

    FramePlan plan_;
};

TEST_F(PlanSwitches, TheTextNamesSwitches) {
    const std::string text = plan_to_text(plan_);
    EXPECT_TRUE(has(text, "\nswitch fog: passes make\n")) << text;
    EXPECT_TRUE(has(text, "\n    runs while \"fog\" is on\n")) << text;
    EXPECT_TRUE(has(text, "\n    runs while \"rain\" is off\n")) << text;
    EXPECT_TRUE(has(text, "    in  b = y (sampled_read) while \"fog\" is on\n")) << text;
    EXPECT_TRUE(has(text, "    in  b = x (sampled_read) while \"fog\" is off\n")) << text;
}

TEST_F(PlanSwitches, ExplainTellsWhatReadersSee) {
    EXPECT_TRUE(
        has(explained("over"), "runs while \"rain\" is off. Its barriers are recorded in every frame."))
        << explained("over");
    EXPECT_TRUE(has(explained("over"), "While it is off, \"x\" keeps the content of pass \"base\""))
        << explained("over");
    EXPECT_TRUE(has(explained("make"), "While it is off, \"y\" has no content.")) << explained("make");
    EXPECT_TRUE(has(explained("store"), "\"kept\" keeps the content of an earlier frame"))
        << explained("store");
    EXPECT_TRUE(has(explained("read"), "has no \"switch\"")) << explained("read");
    EXPECT_TRUE(has(explained("read"), " reads \"x\" while \"fog\" is off.")) << explained("read");
    EXPECT_TRUE(has(explained("read"), "  Its 2 variants, ")) << explained("read");
    const Result<std::string> base = explain_culled(plan_, "base");
    ASSERT_TRUE(base);
    EXPECT_TRUE(has(*base, "hands on its result while it is switched off")) << *base;
}

TEST_F(PlanSwitches, ThePageExplainsSwitches) {
    const std::string page = plan_to_html(plan_, {});
    EXPECT_TRUE(has(page, "has no content.")) << "the article of the pass \"make\"";
}

}  // namespace
}  // namespace weft::test
