// Tests each limit on graph files with an expensive input. `weft` must not refuse an input at the limit
// because of this limit. It must refuse an input with one item more. Both runs must stay within 5 s of
// processor time and 1 GiB of memory. The test also fails if limit_edges.cpp has no input for a limit.
#include "tests/viewer/hostile/limit_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

#include "weft/graph_builder.h"
#include "weft/limits.h"

namespace weft::test {
namespace {

// Limits on files other than graphs, by the first part of their names, and the test suite that covers them.
const std::map<std::string, std::string> kSuites{
    {"shader", "HostileShader"}, {"scene", "HostileScene"}, {"picture", "Compare"}};

bool has_suite(const std::string& name) {
    const testing::UnitTest& all = *testing::UnitTest::GetInstance();
    for (int i = 0; i < all.total_test_suite_count(); ++i)
        if (all.GetTestSuite(i)->name() == name) return true;
    return false;
}

class LimitEdges : public testing::Test {
 protected:
    RunResult check(const std::string& limits = {}) const {
        std::vector<std::string> words{"check", scratch_ / "graph.json"};
        if (!limits.empty()) {
            scratch_.write("limits.json", limits);
            words.insert(words.end(), {"--limits", scratch_ / "limits.json"});
        }
        RunResult run = run_weft(words);
        EXPECT_LE(run.cpu_s, kMostInputCpu_s) << run.text();
        EXPECT_LE(run.max_rss_bytes, kMostInputMemory_bytes) << run.text();
        return run;
    }
    static bool names_limit(const RunResult& run, const std::string& limit) {
        return run.err.find("raise " + limit + " with") != std::string::npos;
    }
    void expect_accepted(const LimitEdge& edge, const RunResult& run) const {
        EXPECT_EQ(run.exit_code, edge.is_good ? 0 : 3) << edge.limit << run.text();
        EXPECT_FALSE(names_limit(run, edge.limit)) << edge.limit << run.text();
    }
    void expect_refused(const LimitEdge& edge, const RunResult& run) const {
        EXPECT_EQ(run.exit_code, 3) << edge.limit << run.text();
        EXPECT_TRUE(names_limit(run, edge.limit)) << edge.limit << run.text();
        EXPECT_NE(run.err.find("graph.json:"), std::string::npos) << edge.limit << run.text();
    }

    ScratchFolder scratch_;
};

TEST_F(LimitEdges, EveryLimitHasOne) {
    for (const LimitRow& row : limit_table()) {
        const std::string name(row.name);
        const auto suite = kSuites.find(name.substr(0, name.find('.')));
        if (suite != kSuites.end()) {
            EXPECT_TRUE(has_suite(suite->second)) << name;
            continue;
        }
        const bool has_edge =
            std::ranges::any_of(limit_edges(), [&](const LimitEdge& e) { return e.limit == name; });
        EXPECT_TRUE(has_edge) << name << " has no edge: add one to limit_edges.cpp";
    }
}

TEST_F(LimitEdges, AreSharpWhereverTheyAreSet) {
    for (const LimitEdge& edge : limit_edges()) {
        if (edge.small == 0) continue;
        const std::string limits =
            "{ \"" + std::string(edge.limit) + "\": " + std::to_string(edge.small) + " }";
        edge.write(scratch_, edge.small);
        expect_accepted(edge, check(limits));
        edge.write(scratch_, edge.small + 1);
        expect_refused(edge, check(limits));
    }
}

// Searches for the number of steps that the graph needs. The graph must be accepted if graph.steps is this
// number, and refused if graph.steps is one less.
TEST_F(LimitEdges, StepsAreCountedExactly) {
    const auto edge = std::ranges::find(limit_edges(), std::string_view("graph.steps"), &LimitEdge::limit);
    edge->write(scratch_, 400);
    const auto run_with = [&](uint64_t steps) {
        return check("{ \"graph.steps\": " + std::to_string(steps) + " }");
    };
    uint64_t too_few = 1, enough = 1u << 20;
    ASSERT_EQ(run_with(enough).exit_code, 0);
    while (enough - too_few > 1) {
        const uint64_t middle = too_few + (enough - too_few) / 2;
        (run_with(middle).exit_code == 0 ? enough : too_few) = middle;
    }
    EXPECT_GT(too_few, 400u);
    expect_refused(*edge, run_with(too_few));
    EXPECT_EQ(run_with(enough).exit_code, 0);
}

// These graphs are very expensive for the checker, but within the limit graph.steps. Hundreds of passes read
// all 2048 × 3 subresources of an image. In the first graph, one pass for each layer writes the image; in the
// second graph, a single pass writes it.
TEST_F(LimitEdges, HoldForPlansOfManyParts) {
    const auto check_graph = [&](const std::string& written, int readers) {
        scratch_.write("graph.json", R"json({ "version": 1, "imports": { "backbuffer": "output" },
            "resources": { "x": { "format": "r8", "size": [4, 4], "layers": 2048, "mips": "full" } },
            "passes": { "show": { "type": "clear", "out": ["backbuffer"] },
              "write": { "type": "clear", )json" +
                                         written + R"json( },
              "read": { "type": "readback", "in": ["x"], "repeat": { "i": "1..)json" +
                                         std::to_string(readers) + R"json(" } } } })json");
        EXPECT_EQ(check().exit_code, 0);
    };
    check_graph(R"json("out": ["x.layer(i)"], "repeat": { "i": "0..2047" })json", 390);
    check_graph(R"json("out": ["x"])json", 830);
}

// Groups of 12 resources use the same memory one after another. For each group, one pass writes mip level 0
// of the resources, and another pass writes mip level 1.
TEST_F(LimitEdges, HoldForManyResourcesInOneMemory) {
    constexpr int kGroups = 1300, kEach = 12;
    GraphBuilder graph("many");
    graph.import("backbuffer", "output");
    for (int group = 0; group < kGroups; ++group) {
        const std::string number = std::to_string(group);
        std::vector<GraphValue> parts[2];
        for (int i = 0; i < kEach; ++i) {
            const std::string name = "r" + std::to_string(group * kEach + i);
            graph.image(name, "r8").size(4).mips(2);
            for (int mip : {0, 1}) parts[mip].push_back(name + ".mip(" + std::to_string(mip) + ")");
        }
        for (int mip : {0, 1})
            graph.pass("p" + number + "_" + std::to_string(mip), "clear").set("out", parts[mip]);
        graph.pass("q" + number, "readback").set("in", {"r" + std::to_string(group * kEach)});
    }
    graph.pass("show", "clear").set("out", {"backbuffer"});
    scratch_.write("graph.json", graph.to_json());
    EXPECT_EQ(check().exit_code, 0);
}

TEST_F(LimitEdges, HoldWithTheWorstInput) {
    if (!extended()) GTEST_SKIP() << "large files: set WEFT_EXTENDED=1";
    Limits defaults;
    for (const LimitRow& row : limit_table()) {
        const auto edge = std::ranges::find(limit_edges(), std::string_view(row.name), &LimitEdge::limit);
        if (edge == limit_edges().end()) continue;
        edge->write(scratch_, row.of(defaults));
        const RunResult most = check();
        if (edge->is_good) {
            EXPECT_EQ(most.exit_code, 0) << row.name << most.text();
        }
        std::printf("%s at %llu: %.2f s of CPU, %.0f MiB\n", row.name,
                    static_cast<unsigned long long>(row.of(defaults)), most.cpu_s,
                    static_cast<double>(most.max_rss_bytes) / 1048576.0);
        edge->write(scratch_, row.of(defaults) + 1);
        const RunResult more = check();
        // The message is not checked here, unlike in expect_refused(): it may name a lower limit of the
        // device, which `weft` checks before its own limit.
        EXPECT_TRUE(more.exit_code == 3 || !edge->is_good) << row.name << more.text();
    }
}

}  // namespace
}  // namespace weft::test
