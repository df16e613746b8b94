// Tests what the texts and the page of a plan tell about groups.
#include <algorithm>

#include "graph/report/group_phrases.h"
#include "tests/graph/report/html/markup_reader.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_groups.h"
#include "weft/compile.h"
#include "weft/report/plan_diff.h"
#include "weft/report/plan_dump.h"
#include "weft/report/plan_explain.h"

namespace weft::test {
namespace {

class PlanGroups : public ResolveTest {
 protected:
    PlanGroups() {
        shaders = group_shaders();
        imports.imports["noise"].resource.format = Format::rgba16f;
    }

    static bool has(const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    }
    FramePlan plan_of(const std::string& text) {
        const ResolvedGraph graph = good(text);
        return compile(graph, content_needs(graph), {});
    }
    // Each round copies "k", which a pass outside writes, through "raw" to a layer of "probes".
    FramePlan copies(const std::string& keys, const std::string& sky_keys = "", uint32_t rounds = 3) {
        const std::string count = std::to_string(rounds);
        return plan_of(
            R"j("imports": {"list": "turns"}, "resources": {"k": {"format": "rgba16f", "size": 64)j" +
            (sky_keys.empty() ? std::string("}") : R"j(, "keep": true})j") +
            R"j(, "probes": {"format": "rgba16f", "size": 64, "keep": true, "layers": )j" + count +
            R"j(}}, "groups": {"g": {"repeat": {"i": "0..)j" + count + R"j( - 1"}, )j" + keys +
            R"j("resources": {"raw": {"format": "rgba16f", "size": 64}}, "passes": {
            "make": {"type": "copy", "in": {"src": "k"}, "out": {"dst": "raw"}},
            "store": {"type": "copy", "in": {"src": "raw"}, "out": {"dst": "probes.layer(i)"}}}}}, "passes": {
            "sky": {"type": "clear", "out": ["k"])j" +
            sky_keys + R"j(}, "see": {"type": "readback", "in": ["probes"]}})j");
    }
};

TEST_F(PlanGroups, TheTextNamesGroupsAndRounds) {
    const std::string text = plan_to_text(copies(""));
    EXPECT_TRUE(has(text, "\ngroup  g: 3 rounds, all per frame\n")) << text;
    EXPECT_TRUE(has(text, "    round 1 of group \"g\", unit 1: g::make#1, g::store#1\n")) << text;
    EXPECT_FALSE(has(text, "    rest "));
    const std::string more =
        plan_to_text(copies(R"j("perFrame": 1, "warmUp": 2, "turns": "list", "rest": true, "settle": 4, )j",
                            R"j(, "rest": true)j"));
    EXPECT_TRUE(has(more,
                    "\ngroup  g: 3 rounds, 1 per frame, 2 per frame until all have run, turns from \"list\", "
                    "rest, settle 4\n"))
        << more;
    EXPECT_TRUE(has(more, "    rest unit 0: sky\n")) << more;
}

TEST_F(PlanGroups, TurnsAreDescribed) {
    GroupDecl group{.name = "g", .rounds = 3};
    EXPECT_EQ(describe_turns(group), "In each frame, all rounds of the group may run.");
    group.per_frame = 2;
    EXPECT_EQ(
        describe_turns(group),
        "In each frame, at most 2 rounds of the group may run. The rounds that have waited longest come "
        "first. Rounds that have not run yet come first: all of them in each frame.");
    group.warm_up = 1;
    EXPECT_FALSE(has(describe_turns(group), "not run yet")) << "perFrame is higher";
    group.per_frame = 0;
    EXPECT_TRUE(has(describe_turns(group), "no round of the group may run")) << describe_turns(group);
    EXPECT_TRUE(has(describe_turns(group), "come first: up to 1 in each frame")) << describe_turns(group);
    group.turns = "list";
    EXPECT_TRUE(has(describe_turns(group), "The program lists the rounds in \"list\""))
        << describe_turns(group);
    EXPECT_EQ(describe_group(group),
              "3 rounds, 0 per frame, 1 per frame until all have run, turns from \"list\"");
    EXPECT_TRUE(has(describe_turns(group), "before the list: up to 1 in each")) << describe_turns(group);
}

TEST_F(PlanGroups, ExplainRestTellsOfTheRound) {
    const Result<std::string> turn = explain_rest(copies(R"j("perFrame": 1, )j"), "g::make#2");
    ASSERT_TRUE(turn.ok());
    EXPECT_TRUE(has(*turn, "belongs to round 2 of group \"g\" (3 rounds, 1 per frame")) << *turn;
    EXPECT_TRUE(has(*turn, "runs only together with \"g::store#2\"")) << *turn;
    EXPECT_TRUE(has(*turn, "has no \"rest\", so the round runs whenever it has its turn")) << *turn;
    EXPECT_FALSE(has(*turn, "g::store#1")) << *turn;
    const FramePlan resting = copies(R"j("rest": true, "settle": 2, )j", R"j(, "rest": true)j");
    const Result<std::string> rest = explain_rest(resting, "g::store#0");
    ASSERT_TRUE(rest.ok());
    EXPECT_TRUE(has(*rest, "runs only after a change, and then 2 more times (\"settle\")")) << *rest;
    EXPECT_TRUE(has(*rest, "\n  \"k\", if pass \"sky\" (graph.json")) << *rest;
    const Result<std::string> all = explain_rest(resting, "g::store");
    ASSERT_TRUE(all.ok());
    EXPECT_TRUE(has(*all, "round 0") && has(*all, "round 1") && has(*all, "round 2")) << *all;
    const Result<std::string> outside = explain_rest(resting, "see");
    ASSERT_TRUE(outside.ok());
    EXPECT_TRUE(has(*outside, "runs in every frame")) << *outside;
}

TEST_F(PlanGroups, ABarrierBeforeAllRoundsIsFound) {
    const FramePlan plan = copies("");
    for (const char* round : {"g::make#0", "g::make#1", "g::make#2"}) {
        const Result<std::string> answer = explain_barrier(plan, "sky", round);
        ASSERT_TRUE(answer.ok());
        EXPECT_TRUE(has(*answer, "\"k\": a barrier before \"g::make#0\"")) << *answer;
        EXPECT_EQ(has(*answer, "It stands before all rounds of group \"g\""),
                  round != std::string("g::make#0"))
            << *answer;
    }
    const Result<std::string> rounds = explain_barrier(plan, "g::store#0", "g::make#2");
    ASSERT_TRUE(rounds.ok());
    EXPECT_TRUE(has(*rounds, "whichever of them runs first")) << *rounds;
    EXPECT_FALSE(has(*rounds, "of the previous frame")) << *rounds;
}

// Each barrier that a pass of a group needs must be found, even if it stands at the border of the block.
TEST_F(PlanGroups, EveryBarrierOfRandomGroupsIsFound) {
    size_t moved = 0;
    for (uint32_t seed = 1; seed <= 40; ++seed) {
        const RandomGroups made = random_groups(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + made.text);
        observed = made.observed;
        const FramePlan plan = plan_of(made.text);
        for (const PassStep& step : plan.barriers.steps)
            for (const BarrierDecl& barrier : step.barriers) {
                if (barrier.from == kNoId) continue;
                const Position position = plan.schedule.position[step.pass];
                const GroupBlock block = block_around(plan, position);
                const bool border = !block.empty() && !barrier.if_pass_runs;
                for (Position p = position; p <= (border ? block.last : position); p = Position(p + 1)) {
                    const PassDecl& pass = plan.graph.passes[plan.schedule.order[p]];
                    const bool uses = std::ranges::any_of(pass.uses, [&](const UseDecl& use) {
                        return use.resource == barrier.resource && overlaps(use.range, barrier.range);
                    });
                    if (p != position && !uses) continue;
                    const Result<std::string> answer =
                        explain_barrier(plan, plan.graph.passes[barrier.from].name, pass.name);
                    ASSERT_TRUE(answer.ok());
                    EXPECT_TRUE(
                        has(*answer, "a barrier before \"" + plan.graph.passes[step.pass].name + "\""))
                        << *answer;
                    moved += p != position ? 1 : 0;
                }
            }
    }
    EXPECT_GT(moved, 10u);
}

TEST_F(PlanGroups, ThePageHasAPanelOfGroups) {
    const std::string text = plan_to_html(copies(R"j("perFrame": 1, )j"), {});
    EXPECT_EQ(read_markup(text).fault, "");
    EXPECT_TRUE(has(text, "id=\"groups\"")) << text;
    EXPECT_TRUE(has(text, "href=\"#groups\""));
    EXPECT_TRUE(has(text, "<td>3 rounds, 1 per frame, all per frame until all have run</td>")) << text;
    EXPECT_TRUE(has(text, "copy pass, round 2 of group &quot;g&quot;, runs at position")) << text;
    EXPECT_TRUE(has(text, "The barrier stands before all rounds of the group")) << text;
    EXPECT_TRUE(has(text, "belongs to round 1 of group")) << text;
    const std::string without =
        plan_to_html(plan_of(R"j("resources": {"k": {"format": "rgba16f", "size": 64}}, "passes": {
                    "sky": {"type": "clear", "out": ["k"]}, "see": {"type": "readback", "in": ["k"]}})j"),
                     {});
    EXPECT_FALSE(has(without, "#groups") || has(without, "id=\"groups\"")) << without;
}

TEST_F(PlanGroups, TheDiffNamesGroups) {
    const FramePlan all = copies(""), one = copies(R"j("perFrame": 1, )j");
    const PlanDiff diff = diff_plans(all, one);
    EXPECT_FALSE(diff.same);
    EXPECT_TRUE(has(plan_diff_to_text(diff),
                    "\ngroups\n  ~ g\n      - 3 rounds, all per frame\n      + 3 rounds, 1 per frame, "))
        << plan_diff_to_text(diff);
    EXPECT_TRUE(has(plan_diff_to_json(diff), "\"groups\": {"));
    EXPECT_TRUE(diff.passes.changed.empty());
}

// On the page, the passes of many rounds are one box for each pass of the group.
TEST_F(PlanGroups, ManyRoundsAreFolded) {
    const FramePlan plan = copies("", "", 20);
    const std::string text = plan_to_html(plan, {});
    EXPECT_EQ(read_markup(text).fault, "");
    EXPECT_TRUE(has(text, "a repeat of 20 iterations")) << text;
    EXPECT_TRUE(has(text, "<h3>g::make</h3>") && has(text, "<h3>g::store</h3>")) << text;
}

}  // namespace
}  // namespace weft::test
