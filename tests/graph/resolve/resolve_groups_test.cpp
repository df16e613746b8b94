// Tests the rules for groups: rounds and their units, what a round sees, and which graphs are refused.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

// The resources and imports of all graphs of this file are in line 1. The text of the groups begins in line
// 2.
class ResolveGroups : public ResolveTest {
 protected:
    ResolveGroups() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["read.comp"] = compute({sampled("a"), image_out("dst")});
        shaders["load.comp"] = compute({image_in("a"), image_out("dst")});
        shaders["both.comp"] = compute({sampled("a"), sampled("b"), image_out("dst")});
        shaders["change.comp"] = compute({image_in_out("dst")});
        ShaderBinding all = sampled("w");
        all.arrayed = true;
        shaders["all.comp"] = compute({all, image_out("dst")});
        shaders["again.comp"] = compute({sampled("a"), all, image_out("dst")});
        shaders["show.frag"] = fragment({"backbuffer"}, {sampled("a")});
        shaders["look.frag"] = fragment({"backbuffer"}, {all});
        PassType custom;
        custom.name = "upload";
        custom.ports = {Out{"dst", Access::copy_write}};
        passes["upload"] = custom;
    }

    static std::string graph(const std::string& groups, const std::string& outside) {
        return R"j("imports": {"backbuffer": "output", "list": "turns"}, "params": {"few": {"default": 2}},)j"
               R"j("resources": {"probes": {"format": "rgba16f", "layers": 3, "keep": true},)j"
               R"j("many": {"format": "rgba16f", "layers": 3, "keep": true},)j"
               R"j("k": {"format": "rgba16f", "keep": true}, "t": "rgba16f", "u": "rgba16f",)j"
               R"j("h": {"format": "rgba16f", "history": 1}}, "groups": {)j"
               "\n" +
               groups + "},\n\"passes\": {\n" + outside + "}";
    }
    // Returns a group "g" with three rounds, with a list of passes.
    static std::string group(const std::string& passes, const std::string& keys = "") {
        return R"j("g": {"repeat": {"i": "0..2"}, )j" + keys +
               R"j("resources": {"raw": "rgba16f"}, "passes": {)j" + "\n" + passes + "}}";
    }
    static std::string pass(const std::string& name, const std::string& shader, const std::string& in,
                            const std::string& out, const std::string& more = "") {
        return "\"" + name + R"j(": {"type": "compute", "shader": ")j" + shader + R"j(.comp", "in": {)j" +
               in + R"j(}, "out": {"dst": ")j" + out + "\"}" + more + "}";
    }
    static std::string show(const std::string& in) {
        return R"j("show": {"type": "fullscreen", "shader": "show.frag", "in": {"a": ")j" + in +
               R"j("}, "out": ["backbuffer"]})j";
    }
    // A round makes "raw" from nothing, and stores it in its layer.
    static std::string make_and_store(const std::string& keys = "") {
        return group(pass("make", "make", "", "raw") + ",\n" +
                         pass("store", "read", R"j("a": "raw")j", "probes.layer(i)"),
                     keys);
    }

    // Expects one error at the place "line:column".
    void expect_refused(const std::string& text, const std::string& code, const std::string& place,
                        const std::string& message, const std::string& help) {
        const Diagnostic d = bad(text);
        EXPECT_EQ(d.code, code);
        EXPECT_EQ(std::to_string(d.line) + ":" + std::to_string(d.column), place) << text << to_text(d);
        EXPECT_NE(d.message.find(message), std::string::npos) << d.message;
        expect_help(d, help);
    }
};

TEST_F(ResolveGroups, EveryRoundIsAUnit) {
    const ResolvedGraph made =
        good(graph(make_and_store(), pass("rests", "make", "", "k", R"j(, "rest": true)j") + ",\n" +
                                         pass("join", "both", R"j("a": "k", "b": "probes.layer(1)")j", "t") +
                                         ",\n" + show("t")));
    ASSERT_EQ(made.groups.size(), 1u);
    const GroupDecl& group = made.groups[0];
    EXPECT_EQ(group.name, "g");
    EXPECT_EQ(group.first_unit, 1u) << "units of groups have the highest numbers";
    EXPECT_EQ(group.rounds, 3u);
    EXPECT_EQ(made.rest_unit_count, 4u);
    EXPECT_EQ(pass_in(made, "rests").rest_unit, 0u);
    for (const char* name : {"g::make#0", "g::store#0"}) EXPECT_EQ(pass_in(made, name).rest_unit, 1u);
    for (const char* name : {"g::make#2", "g::store#2"}) EXPECT_EQ(pass_in(made, name).rest_unit, 3u);
    EXPECT_EQ(pass_in(made, "join").rest_unit, kNoId);
    EXPECT_FALSE(group.rests);
    EXPECT_EQ(group.per_frame, GroupDecl::kAll);
    EXPECT_EQ(group.warm_up, GroupDecl::kAll);
    EXPECT_EQ(group.settle, 0u);
    EXPECT_EQ(group.turns, "");
}

TEST_F(ResolveGroups, SeveralIndicesCountLikeLoops) {
    const std::string groups =
        R"j("g": {"repeat": {"i": "0..1", "n": "2..1 by -1"}, "resources": {"raw": "rgba16f"}, "passes": {)j" +
        pass("make", "make", "", "raw") + "," + pass("cut", "make", "", "raw", R"j(, "if": "0")j") + "}}";
    const ResolvedGraph made = good(graph(groups, pass("fill", "make", "", "k") + "," + show("k")));
    ASSERT_EQ(made.groups.size(), 1u);
    EXPECT_EQ(made.groups[0].rounds, 4u);
    EXPECT_EQ(pass_in(made, "g::make#0.2").rest_unit, 0u);
    EXPECT_EQ(pass_in(made, "g::make#0.1").rest_unit, 1u);
    EXPECT_EQ(pass_in(made, "g::make#1.1").rest_unit, 3u);
}

TEST_F(ResolveGroups, AGroupWithoutRepeatIsOneRound) {
    const ResolvedGraph made = good(
        graph(R"j("g": {"rest": true, "passes": {)j" + pass("store", "make", "", "k") + "}}", show("k")));
    ASSERT_EQ(made.groups.size(), 1u);
    EXPECT_EQ(made.groups[0].rounds, 1u);
    EXPECT_TRUE(made.groups[0].rests);
    EXPECT_EQ(pass_in(made, "g::store").rest_unit, 0u);
}

TEST_F(ResolveGroups, NumbersOfRoundsAreExpressions) {
    const std::string text = graph(
        make_and_store(
            R"j("perFrame": "few - 1", "warmUp": "few", "turns": "list", "rest": true, "settle": "few * 2", )j"),
        show("probes.layer(0)"));
    GroupDecl group = good(text).groups.at(0);
    EXPECT_EQ(group.per_frame, 1u);
    EXPECT_EQ(group.warm_up, 2u);
    EXPECT_EQ(group.settle, 4u);
    EXPECT_EQ(group.turns, "list");
    EXPECT_TRUE(group.rests);
    params["few"] = 1;
    group = good(text).groups.at(0);
    EXPECT_EQ(group.per_frame, 0u);
    EXPECT_EQ(group.settle, 2u);
    expect_refused(graph(make_and_store(R"j("perFrame": "few - 5", )j"), show("probes.layer(0)")), "W109",
                   "2:45", "\"perFrame\" of group \"g\" is -4", "from 0 to 100000");
}

TEST_F(ResolveGroups, ARoundSeesOnlyItsOwnLocals) {
    const ResolvedGraph made = good(graph(make_and_store(), show("probes.layer(2)")));
    EXPECT_EQ(seen(made, "g::store#0", "a"), "g::make#0");
    EXPECT_EQ(seen(made, "g::store#2", "a"), "g::make#2");
    EXPECT_FALSE(use(made, "g::store#2", "a").latest);
    EXPECT_FALSE(has_edge(made, "g::make#0", "g::store#1", EdgeKind::raw));
    for (const EdgeDecl& edge : made.edges)
        EXPECT_TRUE(made.passes[edge.to].rest_unit == kNoId ||
                    made.passes[edge.from].rest_unit == made.passes[edge.to].rest_unit)
            << made.passes[edge.from].name << " to " << made.passes[edge.to].name;
}

TEST_F(ResolveGroups, AReaderOutsideSeesWhatTheRoundLeavesLast) {
    const std::string groups =
        group(pass("store", "make", "", "probes.layer(i)") + ",\n" +
              pass("mend", "change", "", "probes.layer(i)", R"j(, "after": ["store"])j"));
    const ResolvedGraph made = good(graph(groups, show("probes.layer(1)")));
    EXPECT_EQ(seen(made, "show", "a"), "g::mend#1");
    EXPECT_EQ(seen(made, "g::mend#1", "dst"), "g::store#1");
    EXPECT_FALSE(use(made, "show", "a").latest);
    EXPECT_TRUE(has_edge(made, "g::mend#1", "show", EdgeKind::raw));
}

TEST_F(ResolveGroups, PinsAndAfterMeanTheOwnRound) {
    const std::string groups =
        group(pass("first", "make", "", "raw") + ",\n" +
              pass("change", "change", "", "raw", R"j(, "after": ["first"])j") + ",\n" +
              pass("store", "read", R"j("a": "raw@first")j", "probes.layer(i)"));
    const ResolvedGraph made = good(graph(groups, show("probes.layer(1)")));
    EXPECT_EQ(seen(made, "g::store#1", "a"), "g::first#1");
    EXPECT_TRUE(has_edge(made, "g::first#2", "g::change#2", EdgeKind::after));
    EXPECT_FALSE(has_edge(made, "g::first#0", "g::change#2", EdgeKind::after));
    EXPECT_TRUE(has_edge(made, "g::store#2", "g::change#2", EdgeKind::war));
    EXPECT_FALSE(has_edge(made, "g::store#0", "g::change#2", EdgeKind::war));
}

TEST_F(ResolveGroups, WhatOtherRoundsWriteIsSeenAsItIs) {
    const std::string port = R"j("w": {"ref": "probes", "wakes": false})j";
    const std::string groups = group(pass("make", "all", port, "raw") + ",\n" +
                                     pass("store", "read", R"j("a": "raw")j", "probes.layer(i)"));
    const ResolvedGraph made = good(graph(groups, show("probes.layer(0)")));
    const UseDecl& w = use(made, "g::make#1", "w");
    EXPECT_TRUE(w.latest);
    EXPECT_FALSE(w.wakes);
    for (const VersionSource& source : w.sources) EXPECT_EQ(source.producer, kNoId);
    EXPECT_FALSE(has_edge(made, "g::store#1", "g::make#1", EdgeKind::raw));
    EXPECT_FALSE(has_edge(made, "g::store#0", "g::make#1", EdgeKind::raw));
    EXPECT_TRUE(has_edge(made, "g::make#1", "g::store#1", EdgeKind::war))
        << "the round reads before it writes its own layer";
    EXPECT_FALSE(use(made, "g::store#1", "a").latest);
}

TEST_F(ResolveGroups, APassAfterTheOwnWriteSeesIt) {
    const std::string groups = group(
        pass("store", "make", "", "probes.layer(i)") + ",\n" +
        pass("sum", "all", R"j("w": "probes")j", "raw") + ",\n" +
        R"j("look": {"type": "compute", "shader": "read.comp", "in": {"a": "raw"}, "out": {"dst": "many.layer(i)"
}
})j");
    const std::string text = graph(groups, show("many.layer(1)"));
    const ResolvedGraph made = good(text);
    EXPECT_EQ(seen(made, "g::sum#1", "w"), "before g::store#1 before");
    EXPECT_TRUE(use(made, "g::sum#1", "w").latest);
    EXPECT_TRUE(has_edge(made, "g::store#1", "g::sum#1", EdgeKind::raw));
    EXPECT_FALSE(has_edge(made, "g::store#0", "g::sum#1", EdgeKind::raw));
}

TEST_F(ResolveGroups, AnObserverSeesALocalOfTheLastRound) {
    observed = {"g::raw"};
    const ResolvedGraph made = good(graph(make_and_store(), show("probes.layer(0)")));
    bool found = false;
    for (const PassDecl& p : made.passes) {
        if (p.kind != PassKind::readback) continue;
        found = true;
        EXPECT_TRUE(p.uses[0].latest);
        EXPECT_EQ(seen(made, p.name.c_str(), p.uses[0].port.c_str()), "g::make#2");
    }
    EXPECT_TRUE(found);
}

TEST_F(ResolveGroups, ReadsThatNeedDifferentLayoutsUseGeneral) {
    const std::string groups =
        group(pass("make", "read", R"j("a": "k")j", "raw") + ",\n" +
              pass("store", "load", R"j("a": "k")j", "probes.layer(i)", R"j(, "after": ["make"])j"));
    const ResolvedGraph made = good(graph(
        groups, pass("table", "make", "", "k") + ",\n" +
                    pass("join", "both", R"j("a": "k", "b": "probes.layer(0)")j", "t") + ",\n" + show("t")));
    EXPECT_EQ(use(made, "g::make#0", "a").state.layout, Layout::general);
    EXPECT_EQ(use(made, "g::store#0", "a").state.layout, Layout::general);
    EXPECT_EQ(use(made, "join", "a").state.layout, Layout::shader_read_only);
}

// Errors W190.

TEST_F(ResolveGroups, SeveralRoundsMustNotWriteOnePart) {
    const std::string text = graph(group(pass("store", "make", "", "k")), show("k"));
    expect_refused(text, "W190", "3:78", "several rounds of group \"g\" write \"k\"", "\"k.layer(i)\"");
    expect_refused(text, "W190", "3:78", "would depend on the order in which the rounds run",
                   "\"resources\" of the group");
}

TEST_F(ResolveGroups, AnOutsidePassMustNotWriteThePartOfARound) {
    const std::string text = graph(
        make_and_store(), pass("more", "change", "", "probes.layer(1)", R"j(, "after": ["g::store"])j") +
                              ",\n" + show("probes.layer(1)"));
    expect_refused(text, "W190", "4:88", "pass \"more\" writes this part, too", "different resources");
    EXPECT_EQ(bad(text).notes.size(), 1u);
}

TEST_F(ResolveGroups, AnOutsidePassMustNotUseALocal) {
    expect_refused(graph(make_and_store(), show("g::raw")), "W190", "6:67",
                   "pass \"show\" uses \"g::raw\", which belongs to group \"g\"", "\"keep\": true");
    expect_refused(
        graph(make_and_store(), pass("fill", "make", "", "g::raw") + ",\n" + show("probes.layer(0)")), "W190",
        "6:77", "pass \"fill\" uses \"g::raw\"", "into the group");
}

TEST_F(ResolveGroups, NoOutsidePassRunsBetweenPassesOfAGroup) {
    const std::string groups = group(pass("store", "make", "", "probes.layer(i)") + ",\n" +
                                     pass("end", "read", R"j("a": "t")j", "many.layer(i)"));
    const std::string text = graph(
        groups, pass("sum", "read", R"j("a": "probes.layer(0)")j", "t") + ",\n" + show("many.layer(1)"));
    expect_refused(text, "W190", "6:1", "pass \"sum\" must run after pass \"g::store#0\"", "into the group");
    expect_refused(text, "W190", "6:1", "and before pass \"g::end#", "into two groups");
    expect_refused(text, "W190", "6:1", "without other passes between them", "let pass \"g::end\" read");
}

TEST_F(ResolveGroups, NoTypeInCppIsAllowed) {
    const std::string groups = group(R"j("store": {"type": "upload", "out": {"dst": "probes.layer(i)"
}
})j");
    expect_refused(graph(groups, show("probes.layer(1)")), "W190", "3:1",
                   "pass \"g::store\" has a type in C++", "out of the group");
}

// Errors W188 about groups.

TEST_F(ResolveGroups, ARoundThatRestsDoesNotDependOnOtherRounds) {
    const std::string groups = group(pass("store", "make", "", "probes.layer(i)") + ",\n" +
                                         pass("sum", "all", R"j("w": "probes")j", "raw") + ",\n" +
                                         pass("end", "read", R"j("a": "raw")j", "many.layer(i)"),
                                     R"j("rest": true, )j");
    const std::string text = graph(groups, show("many.layer(1)"));
    expect_refused(text, "W188", "4:62",
                   "pass \"g::sum\" belongs to group \"g\", which has \"rest\", but its result depends on",
                   "add \"wakes\": false to the port");
}

TEST_F(ResolveGroups, ARoundThatRestsReadsNothingThatAlwaysChanges) {
    const std::string groups =
        group(pass("store", "read", R"j("a": "t")j", "probes.layer(i)"), R"j("rest": true, )j");
    const std::string text = graph(groups, pass("fill", "make", "", "t") + ",\n" + show("probes.layer(1)"));
    expect_refused(text, "W188", "3:65",
                   "pass \"g::store\" belongs to group \"g\", which has \"rest\", but would never rest",
                   "remove \"rest\" from group \"g\", or add \"rest\": true to pass \"fill\"");
}

TEST_F(ResolveGroups, ARoundThatRestsDoesNotAddToOldContent) {
    const std::string groups = group(pass("store", "change", "", "probes.layer(i)"), R"j("rest": true, )j");
    expect_refused(graph(groups, show("probes.layer(1)")), "W188", "3:80",
                   "pass \"g::store\" belongs to group \"g\", which has \"rest\", but its result depends on",
                   "or a pass of its round before it");
    const ResolvedGraph made =
        good(graph(group(pass("store", "change", "", "probes.layer(i)")), show("probes.layer(1)")));
    EXPECT_EQ(seen(made, "g::store#1", "dst"), "before") << "without \"rest\", a round may add up";
}

TEST_F(ResolveGroups, WhatRoundsWriteMustLast) {
    expect_refused(graph(R"j("g": {"passes": {)j" + pass("store", "make", "", "t") + "}}", show("t")), "W188",
                   "2:95", "pass \"g::store\" belongs to group \"g\" and writes \"t\"",
                   "add \"keep\": true to resource \"t\"");
    expect_refused(graph(R"j("g": {"passes": {)j" + pass("store", "make", "", "h") + "}}", show("h")), "W188",
                   "2:95", "pass \"g::store\" belongs to group \"g\" and writes \"h\"",
                   "\"keep\": true instead of \"history\"");
}

TEST_F(ResolveGroups, NoReaderOutsideSeesAMiddleVersion) {
    const std::string groups =
        group(pass("store", "make", "", "probes.layer(i)") + ",\n" +
              pass("mend", "change", "", "probes.layer(i)", R"j(, "after": ["store"])j"));
    expect_refused(
        graph(groups, pass("early", "read", R"j("a": "probes.layer(1)@g::store")j", "t") + ",\n" + show("t")),
        "W190", "6:1", "after pass \"g::store#1\" and before pass \"g::mend#1\"", "into the group");
}

// A round that reads the whole image waits for itself. The error names the key that ends this.
TEST_F(ResolveGroups, ACycleInARoundEndsWithWakesFalse) {
    const std::string groups = group(pass("make", "all", R"j("w": "probes")j", "raw") + ",\n" +
                                     pass("store", "read", R"j("a": "raw")j", "probes.layer(i)"));
    const Result<ResolvedGraph> resolved = run(graph(groups, show("probes.layer(0)")));
    ASSERT_FALSE(resolved.ok());
    const Diagnostic& d = resolved.errors().front();
    EXPECT_EQ(d.code, "W150");
    EXPECT_NE(d.message.find("g::make#0 (reads probes)"), std::string::npos) << d.message;
    expect_help(d, R"j(if pass "g::make" needs only the content of "probes" from earlier rounds)j");
    expect_help(d, R"j({ "ref": "probes", "wakes": false })j");
}

// A readback may come before the first round has run. So the resource gets a first content, like one with
// "keep".
TEST_F(ResolveGroups, AnObservedResourceKeepsItsContent) {
    const std::string text = graph(make_and_store(), show("probes.layer(0)"));
    EXPECT_EQ(good(text).resources[find_resource(good(text), "g::raw")].lifetime,
              ResourceLifetime::transient);
    observed = {"g::raw"};
    const ResolvedGraph made = good(text);
    EXPECT_EQ(made.resources[find_resource(made, "g::raw")].lifetime, ResourceLifetime::persistent);
    EXPECT_EQ(made.resources[find_resource(made, "g::raw")].ring, find_resource(made, "g::raw"));
}

// "wakes": false concerns only what the group writes. Another layer of the same image is read as usual.
TEST_F(ResolveGroups, APortThatDoesNotWakeSeesTheNewVersionOfOtherLayers) {
    const std::string reads = R"j("w": {"ref": "many", "wakes": false})j";
    const std::string two =
        R"j("g": {"repeat": {"i": "0..1"}, "resources": {"raw": "rgba16f"}, "passes": {)j" +
        pass("make", "all", reads, "raw") + ",\n" +
        pass("store", "read", R"j("a": "raw")j", "many.layer(i)") + "}}";
    const ResolvedGraph made =
        good(graph(two, pass("fill", "make", "", "many.layer(2)") + ",\n" + show("many.layer(0)")));
    for (const UseDecl& use : pass_in(made, "g::make#0").uses) {
        if (use.port != "w") continue;
        for (const VersionSource& source : use.sources)
            EXPECT_EQ(source.producer, source.range.layer == 2 ? find_pass(made, "fill") : PassId(kNoId))
                << source.range.layer;
    }
}

}  // namespace
}  // namespace weft::test
