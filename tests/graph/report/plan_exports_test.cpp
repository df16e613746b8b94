// Tests what the texts and the page of a plan tell about resources that the program reads between frames.
#include "tests/graph/resolve/resolve_fixture.h"
#include "weft/compile.h"
#include "weft/report/plan_dump.h"
#include "weft/report/plan_explain.h"

namespace weft::test {
namespace {

TEST_F(ResolveTest, ThePlanTellsWhatTheProgramReads) {
    shaders["make.comp"] = compute({image_out("dst")});
    exports = {{"kept", {Access::sampled_read}}};
    const ResolvedGraph graph =
        good(R"("resources": {"kept": {"format": "rgba16f", "size": 64, "keep": true}},
        "passes": {"make": {"type": "compute", "shader": "make.comp", "out": {"dst": "kept"}}})");
    const FramePlan plan = compile(graph, content_needs(graph), {});
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    const Result<std::string> culled = explain_culled(plan, "make");
    ASSERT_TRUE(culled) << to_text(culled.errors());
    EXPECT_TRUE(has(*culled, "which the program reads between frames")) << *culled;
    const std::string text = plan_to_text(plan);
    EXPECT_TRUE(has(text, "\nafter the last pass\n")) << text;
    EXPECT_TRUE(has(text, "sampled_read shader_read_only")) << text;
    EXPECT_TRUE(
        has(plan_to_html(plan, {}), "the program reads it between frames in layout shader_read_only"));
    EXPECT_TRUE(has(plan_to_json(plan), "\"between\":"));
}

}  // namespace
}  // namespace weft::test
