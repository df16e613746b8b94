// Tests RestState and frame_steps() with groups: which rounds run in each frame, and what is recorded.
#include <algorithm>
#include <set>

#include "graph/rest/frame_steps.h"
#include "graph/rest/needed_by_units.h"
#include "graph/rest/rest_state.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

class RestGroups : public ResolveTest {
 protected:
    RestGroups() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["read.comp"] = compute({sampled("a"), image_out("dst")});
        ShaderBinding all = sampled("w");
        all.arrayed = true;
        shaders["all.comp"] = compute({all, image_out("dst")});
        shaders["show.frag"] = fragment({"backbuffer"}, {all, sampled("a")});
    }

    // Makes the plan of a graph with a group of three rounds. Its units have the numbers 0 to 2, or 1 to 3 if
    // the graph has another unit.
    void make(const std::string& keys, const std::string& more = "") {
        plan = made(R"j("g": {"repeat": {"i": "0..2"}, )j" + keys +
                        R"j("resources": {"raw": "rgba16f"}, "passes": {
            "make": {"type": "compute", "shader": "make.comp", "out": {"dst": "raw"}},
            "store": {"type": "compute", "shader": "read.comp", "in": {"a": "raw"},
                      "out": {"dst": "probes.layer(i)"}}}})j",
                    more);
        state.emplace(plan);
        inputs.assign(plan.graph.rest_unit_count, UnitInput(std::in_place));
    }
    FramePlan made(const std::string& groups, const std::string& more, const std::string& resources = "") {
        const ResolvedGraph graph = good(
            R"j("imports": {"backbuffer": "output", "list": "turns"}, "resources": {)j" + resources + R"j(
            "probes": {"format": "rgba16f", "layers": 3, "keep": true}, "k": {"format": "rgba16f", "keep": true}, "t": "rgba16f"},
            "groups": {)j" +
            groups + R"j(}, "passes": {)j" + more +
            R"j("fill": {"type": "compute", "shader": "make.comp", "out": {"dst": "t"}},
            "show": {"type": "fullscreen", "shader": "show.frag", "in": {"w": "probes", "a": "t"},
                     "out": ["backbuffer"]}})j");
        return compile(graph, content_needs(graph), {});
    }

    // Runs a frame. Returns the units that run, in the order of choose(), such as "2 0"; units that are no
    // rounds come first.
    std::string frame(const TurnLists& lists = {}) {
        last = state->choose(inputs, lists);
        state->commit(inputs, last);
        std::string text;
        const auto add = [&](uint32_t unit) { text += (text.empty() ? "" : " ") + std::to_string(unit); };
        for (uint32_t unit = 0; unit < last.wakes.size(); ++unit)
            if (last.wakes[unit].runs() && std::ranges::find(last.rounds, unit) == last.rounds.end())
                add(unit);
        for (const uint32_t unit : last.rounds) add(unit);
        return text;
    }
    void change(uint32_t unit) { inputs[unit]->push_back(std::byte{1}); }
    [[nodiscard]] WakeReason reason(uint32_t unit) const { return last.wakes[unit].reason; }

    FramePlan plan;
    std::optional<RestState> state;
    std::vector<UnitInput> inputs;
    UnitChoice last;
};

TEST_F(RestGroups, WithoutRestTheRoundsRunInTurn) {
    make(R"j("perFrame": 1, )j");
    EXPECT_EQ(frame(), "0 1 2") << "warm up";
    EXPECT_EQ(reason(1), WakeReason::first_run);
    for (const char* round : {"0", "1", "2", "0", "1"}) EXPECT_EQ(frame(), round);
    EXPECT_EQ(reason(1), WakeReason::turn);
    EXPECT_EQ(reason(0), WakeReason::waits);
    EXPECT_EQ(wake_text(plan, last.wakes[1]), "it is the turn of this round");
    EXPECT_EQ(wake_text(plan, last.wakes[0]), "");
}

TEST_F(RestGroups, UnitsNeedThePassesWhoseResultsTheyRead) {
    plan = made(R"j("g": {"repeat": {"i": "0..2"}, "passes": {
        "store": {"type": "compute", "shader": "read.comp", "in": {"a": "u"}, "out": {"dst": "probes.layer(i)"}}}})j",
                R"j("first": {"type": "compute", "shader": "make.comp", "out": {"dst": "s"}},
        "second": {"type": "compute", "shader": "read.comp", "in": {"a": "s"}, "out": {"dst": "u"}},)j",
                R"j("s": "rgba16f", "u": "rgba16f",)j");
    std::set<std::string> needed;
    const std::vector<uint8_t> by_position = needed_by_units(plan);
    for (Position p(0); p < plan.schedule.order.size(); ++p)
        if (by_position[p] != 0) needed.insert(plan.graph.passes[plan.schedule.order[p]].name);
    EXPECT_EQ(needed, (std::set<std::string>{"first", "second", "g::store#0", "g::store#1", "g::store#2"}));
}

TEST_F(RestGroups, WithoutPerFrameAllRoundsRun) {
    make("");
    for (int i = 0; i < 3; ++i) EXPECT_EQ(frame(), "0 1 2");
}

TEST_F(RestGroups, AGroupMayWarmUpSlowly) {
    make(R"j("perFrame": 1, "warmUp": 2, )j");
    for (const char* rounds : {"0 1", "2 0", "1", "0", "2"}) EXPECT_EQ(frame(), rounds);
}

TEST_F(RestGroups, WithRestTheRoundsThatChangedTakeTurns) {
    make(R"j("perFrame": 1, "rest": true, )j");
    EXPECT_EQ(frame(), "0 1 2");
    EXPECT_EQ(frame(), "");
    EXPECT_EQ(reason(0), WakeReason::rests);
    change(2);
    EXPECT_EQ(frame(), "2");
    EXPECT_EQ(reason(2), WakeReason::input);
    for (const uint32_t unit : {0, 1, 2}) change(unit);
    EXPECT_EQ(frame(), "0");
    EXPECT_EQ(reason(1), WakeReason::waits);
    change(0);
    EXPECT_EQ(frame(), "1") << "round 0 changed again, but waits behind rounds that waited longer";
    EXPECT_EQ(frame(), "2");
    EXPECT_EQ(frame(), "0");
    EXPECT_EQ(frame(), "");
}

TEST_F(RestGroups, SettleRunsARoundAgainAfterAChange) {
    make(R"j("rest": true, "settle": 2, )j");
    for (const char* rounds : {"0 1 2", "0 1 2", "0 1 2", "", ""}) EXPECT_EQ(frame(), rounds);
    change(1);
    EXPECT_EQ(frame(), "1");
    EXPECT_EQ(reason(1), WakeReason::input);
    EXPECT_EQ(frame(), "1");
    EXPECT_EQ(reason(1), WakeReason::settles);
    change(1);
    EXPECT_EQ(frame(), "1") << "a change begins the count again";
    for (const char* rounds : {"1", "1", ""}) EXPECT_EQ(frame(), rounds);
}

TEST_F(RestGroups, APassThatRunsBeginsTheCountAgain) {
    plan =
        made(R"j("g": {"repeat": {"i": "0..2"}, "rest": true, "settle": 2, "passes": {
        "store": {"type": "compute", "shader": "read.comp", "in": {"a": "k"}, "out": {"dst": "probes.layer(i)"}}}})j",
             R"j("table": {"type": "compute", "shader": "make.comp", "out": {"dst": "k"}, "rest": true},)j");
    state.emplace(plan);
    inputs.assign(plan.graph.rest_unit_count, UnitInput(std::in_place));
    ASSERT_EQ(plan.graph.groups[0].first_unit, 1u);
    EXPECT_EQ(frame(), "0 1 2 3");
    for (const char* rounds : {"1 2 3", "1 2 3", ""}) EXPECT_EQ(frame(), rounds);
    change(0);
    EXPECT_EQ(frame(), "0 1 2 3");
    EXPECT_EQ(frame(), "1 2 3");
    change(0);
    EXPECT_EQ(frame(), "0 1 2 3");
    EXPECT_EQ(reason(1), WakeReason::unit) << "the round also settles, but this is a change";
    for (const char* rounds : {"1 2 3", "1 2 3", ""}) EXPECT_EQ(frame(), rounds);
}

TEST_F(RestGroups, RoundsSettleInTheirTurns) {
    make(R"j("perFrame": 1, "rest": true, "settle": 1, )j");
    EXPECT_EQ(frame(), "0 1 2");
    for (const char* rounds : {"0", "1", "2", ""}) EXPECT_EQ(frame(), rounds);
}

TEST_F(RestGroups, AListChoosesTheRounds) {
    make(R"j("perFrame": 2, "turns": "list", )j");
    EXPECT_EQ(frame({{"list", {1}}}), "0 1 2") << "rounds that have never run need no list";
    EXPECT_EQ(frame({{"list", {2, 0}}}), "2 0");
    EXPECT_EQ(frame({{"list", {}}}), "");
    EXPECT_EQ(frame({{"list", {1, 1, 5, 0, 2}}}), "1 0");
    EXPECT_EQ(last.dropped_turns, 3u);
    EXPECT_EQ(frame(), "2 0") << "without a list, the rounds run in turn";
}

TEST_F(RestGroups, AReaderWakesWhenTheRoundRuns) {
    make(R"j("perFrame": 1, "rest": true, )j",
         R"j("table": {"type": "compute", "shader": "read.comp", "in": {"a": "probes.layer(1)"},
                       "out": {"dst": "k"}, "rest": true},
             "look": {"type": "readback", "in": ["k"]},)j");
    ASSERT_EQ(plan.graph.groups[0].first_unit, 1u);
    EXPECT_EQ(frame(), "0 1 2 3");
    EXPECT_EQ(frame(), "");
    for (const uint32_t unit : {1, 2, 3}) change(unit);
    EXPECT_EQ(frame(), "1") << "round 1 only waits, so the table is still right";
    EXPECT_EQ(frame(), "0 2");
    EXPECT_EQ(reason(0), WakeReason::unit);
    EXPECT_EQ(last.wakes[0].unit, 2u);
    EXPECT_EQ(wake_text(plan, last.wakes[0]), "pass \"g::make#1\" ran");
    EXPECT_EQ(frame(), "3");
}

TEST_F(RestGroups, AFrameThatWasNotSubmittedChangesNothing) {
    make(R"j("perFrame": 1, )j");
    EXPECT_EQ(frame(), "0 1 2");
    const UnitChoice first = state->choose(inputs), again = state->choose(inputs);
    EXPECT_EQ(first.rounds, again.rounds);
}

TEST_F(RestGroups, TheStepsOfAFrameFollowTheRounds) {
    make("");
    std::vector<std::string> steps;
    const auto record = [&](const std::vector<uint8_t>& runs, const std::vector<uint32_t>& rounds) {
        steps.clear();
        ASSERT_EQ(plan.submissions.batches.size(), 1u);
        for (const FrameStep& step : frame_steps(plan, plan.submissions.batches[0], runs, rounds)) {
            const std::string& name = plan.graph.passes[plan.schedule.order[step.position]].name;
            steps.push_back(std::string(step.shared_before ? "(" : "") + (step.runs ? name : "") +
                            (step.shared_after ? ")" : ""));
        }
    };
    record({1, 0, 1}, {2, 0});
    std::vector<std::string> rounds{"(", "g::make#2", "g::store#2", "g::make#0", "g::store#0", ")"};
    const auto first = std::ranges::find(steps, "(");
    ASSERT_GE(steps.end() - first, static_cast<ptrdiff_t>(rounds.size()));
    EXPECT_EQ(std::vector(first, first + static_cast<ptrdiff_t>(rounds.size())), rounds);
    EXPECT_EQ(steps.back(), "(show)");
    EXPECT_EQ(steps.size(), rounds.size() + 2);
    record({0, 0, 0}, {});
    EXPECT_EQ(std::ranges::count(steps, ""), 0) << "a round that does not run has no step";
    EXPECT_EQ(std::ranges::count(steps, "("), 1) << "the shared barriers are recorded all the same";
    EXPECT_EQ(std::ranges::count(steps, ")"), 1);
}

TEST_F(RestGroups, ABorderRecordsOnlySharedBarriers) {
    BarrierDecl shared, own;
    own.if_pass_runs = true;
    const FrameStep first{Position(0), true, false, false}, round{Position(0), false, true, false},
        pass{Position(0), true, true, true};
    EXPECT_TRUE(first.is_border());
    EXPECT_FALSE(round.is_border());
    EXPECT_FALSE(pass.is_border());
    EXPECT_TRUE(first.records(shared, true));
    EXPECT_FALSE(first.records(shared, false));
    EXPECT_FALSE(first.records(own, true));
    EXPECT_TRUE(round.records(own, true));
    EXPECT_FALSE(round.records(shared, true));
}

}  // namespace
}  // namespace weft::test
