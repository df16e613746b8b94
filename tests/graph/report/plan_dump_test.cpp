#include "weft/report/plan_dump.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "tests/graph/compile/plan_expectations.h"
#include "tests/graph/samples/random_graph.h"

namespace weft::test {
namespace {

// Returns a small frame. It is the same for all seeds, except for the order in which its resources are
// declared. Seed 0 keeps the order of `names`; all other seeds give a random order.
GraphBuilder shuffled_frame(uint32_t seed) {
    std::vector<std::string> names{"depth", "color", "blurred", "unused"};
    std::mt19937 random(seed);
    if (seed > 0) std::shuffle(names.begin(), names.end(), random);
    GraphBuilder b;
    std::map<std::string, ResourceId> ids;
    for (const std::string& name : names)
        ids[name] = b.image(name, name == "depth" ? Format::d32f : Format::rgba16f, 64);
    b.pass("base", PassKind::raster,
           {{"color", ids["color"], Access::color_write, {}, kNoId},
            {"depth", ids["depth"], Access::depth_write, {}, kNoId}});
    b.compute("blur", {{"src", ids["color"], Access::sampled_read, {}, kNoId},
                       {"z", ids["depth"], Access::sampled_read, {}, kNoId},
                       {"dst", ids["blurred"], Access::storage_write, {}, kNoId}});
    b.compute("extra", {{"src", ids["color"], Access::sampled_read, {}, kNoId},
                        {"dst", ids["unused"], Access::storage_write, {}, kNoId}});
    read_back(b, "out", ids["blurred"]);
    return b;
}

TEST(PlanHash, TheOrderOfDeclarationDoesNotMatter) {
    const std::string hash = plan_hash(compiled(shuffled_frame(0)));
    EXPECT_EQ(hash.size(), 32u);
    for (uint32_t seed = 1; seed < 8; ++seed) EXPECT_EQ(plan_hash(compiled(shuffled_frame(seed))), hash);
}

TEST(PlanHash, WhereAThingWasWrittenDoesNotMatterWhatItIsDoes) {
    const ResolvedGraph graph = shuffled_frame(0).build();
    const std::string hash = plan_hash(compile(graph, content_needs(graph), {}));
    ResolvedGraph moved = graph;
    moved.passes[0].loc = {0, 12, 3, 1};
    moved.resources[0].loc = {0, 13, 3, 1};
    moved.edges[0].loc = {0, 14, 3, 1};
    moved.sources.files.push_back({"frame.json", "{}"});
    EXPECT_EQ(plan_hash(compile(moved, content_needs(moved), {})), hash);
    ResolvedGraph wider = graph;
    wider.resources[0].extent.width += 1;
    EXPECT_NE(plan_hash(compile(wider, content_needs(wider), {})), hash);
    FramePlan plan = compile(graph, content_needs(graph), {});
    plan.barriers.steps[1].barriers[0].dst.access = 0;
    EXPECT_NE(plan_hash(plan), hash);
}

TEST(PlanDump, TextTellsTheWholeStory) {
    const std::string text = plan_to_text(compiled(shuffled_frame(0)));
    for (const char* part : {"0  base  (raster)", "attach depth: load clear, store store",
                             "barrier color: color_output color_write color_attachment -> compute_shader "
                             "sampled_read shader_read_only  "
                             "[raw, after base]",
                             "[alias from ", "of the previous frame", "peak of live resources",
                             "candidates: program", "culled\n    extra: no pass reads \"unused\""})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\nis missing in\n" << text;
}

TEST(PlanDump, JsonHoldsNamesAndStates) {
    const std::string json = plan_to_json(compiled(shuffled_frame(0)));
    for (const char* part :
         {"\"hash\"", "\"aliasTransitions\"", "\"access\": \"sampled_read\"", "\"reason\": \"alias\"",
          "\"format\": \"rgba16f\"", "\"boundary\"", "\"peakLiveBytes\""})
        EXPECT_NE(json.find(part), std::string::npos) << part;
}

TEST(PlanDump, DotGreysWhatIsCulled) {
    const std::string dot = plan_to_dot(compiled(shuffled_frame(0)));
    EXPECT_EQ(dot.rfind("digraph", 0), 0u);
    EXPECT_NE(dot.find("label=\"extra\", color=grey"), std::string::npos) << dot;
    EXPECT_EQ(dot.find("label=\"0 base\", color=grey"), std::string::npos);
}

// The name of a graph can be any text. Control characters in it must not reach the terminal.
TEST(PlanDump, NoNameSteersATerminal) {
    FramePlan plan = compiled(shuffled_frame(0));
    plan.graph.name = "red \x1b[31m, right to left \u202e";
    for (const std::string& text : {plan_to_text(plan), plan_to_dot(plan)}) {
        EXPECT_NE(text.find("red ?[31m, right to left ?"), std::string::npos) << text;
        EXPECT_EQ(text.find('\x1b'), std::string::npos);
    }
}

TEST(PlanDump, TheSamePlanGivesTheSameBytes) {
    const ResolvedGraph graph = random_graph(7);
    const FramePlan a = compile(graph, content_needs(graph), {}),
                    b = compile(graph, content_needs(graph), {});
    EXPECT_EQ(plan_to_text(a), plan_to_text(b));
    EXPECT_EQ(plan_to_json(a), plan_to_json(b));
    EXPECT_EQ(plan_to_dot(a), plan_to_dot(b));
}

}  // namespace
}  // namespace weft::test
