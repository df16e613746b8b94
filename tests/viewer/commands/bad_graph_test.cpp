// Tests that `weft` refuses faulty graphs with exit code 3, within 5 s of processor time and 1 GiB of memory.
// The message must name the fault, and in most cases its place and a remedy.
// tests/viewer/documentation/diagnostics_test.cpp tests each kind of fault separately.
#include <gtest/gtest.h>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

constexpr const char* kSky = WEFT_SOURCE_DIR "/tests/viewer/commands/sky.json";

void expect_graph_refused(const RunResult& run, const std::vector<std::string>& wanted) {
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_LE(run.cpu_s, kMostInputCpu_s);
    EXPECT_LE(run.max_rss_bytes, kMostInputMemory_bytes);
    EXPECT_TRUE(run.out.empty()) << run.text();
    for (const std::string& part : wanted)
        EXPECT_NE(run.err.find(part), std::string::npos) << "wanted: " << part << "\n" << run.text();
}

TEST(BadGraph, AMissingFileIsNamed) {
    expect_graph_refused(run_weft({"check", "no/such/graph.json"}),
                         {"no/such/graph.json: error[W002]", "help: check the path"});
}

TEST(BadGraph, RenderRefusesWhatCheckRefuses) {
    const std::string graph = WEFT_SOURCE_DIR "/tests/diagnostics/W103_port.json";
    const ScratchFolder scratch;
    const RunResult run =
        run_weft({"render", "builtin:spheres", "--size", "16x16", "--graph", graph, "-o", scratch / "a.png"});
    if (run.exit_code == 4) GTEST_SKIP() << "no Vulkan device";
    expect_graph_refused(run, {graph + ":7:46: error[W103]", "did you mean \"color\"?"});
    EXPECT_FALSE(std::filesystem::exists(scratch / "a.png"));
}

TEST(BadGraph, AllFaultsAreReportedAtOnce) {
    const ScratchFolder scratch;
    scratch.write("many.json", R"({
  "version": 1, "imports": { "backbuffer": "output" }, "consts": { "a": true },
  "resources": { "x": "rgba99" },
  "passes": { "p": { "type": "clear", "out": ["x"], "colour": 1 } }
})");
    expect_graph_refused(run_weft({"check", scratch / "many.json"}),
                         {"2:73: error[W102]", "3:24: error[W116]", "4:53: error[W101]"});
}

// The files of this test are difficult for a parser: one has deep nesting, one is too large, one has bytes
// that are not text, and one is empty.
TEST(BadGraph, HostileFilesAreRefusedQuickly) {
    const ScratchFolder scratch;
    scratch.write("deep.json", std::string(200'000, '['));
    scratch.write("large.json", "{ \"name\": \"" + std::string(9u << 20, 'x') + "\" }");
    scratch.write("binary.json", std::string("\x7f"
                                             "ELF\x02\x01\xff\xfe\0\0",
                                             10));
    scratch.write("empty.json", "");
    expect_graph_refused(run_weft({"check", scratch / "deep.json"}),
                         {"error[W004]", "64 levels deep", "help: "});
    expect_graph_refused(run_weft({"check", scratch / "large.json"}), {"error[W004]", "8 MiB", "help: "});
    expect_graph_refused(run_weft({"check", scratch / "binary.json"}), {"binary.json:1:", "help: "});
    expect_graph_refused(run_weft({"check", scratch / "empty.json"}),
                         {"error[W001]", "the file is empty", "help: "});
}

TEST(BadGraph, AParameterThatIsNotThereIsNamed) {
    const RunResult run = run_weft({"plan", kSky, "--param", "exposur=1"});
    expect_graph_refused(run, {"error[W120]", "no parameter \"exposur\"", "did you mean \"exposure\"?"});
}

TEST(BadProfile, IsRefusedToo) {
    const ScratchFolder scratch;
    const std::string graph = kSky;
    scratch.write("profile.json", "{ \"name\": 7 }");
    expect_graph_refused(run_weft({"check", graph, "--profile", scratch / "none.json"}),
                         {"error[W141]", "help: "});
    expect_graph_refused(run_weft({"check", graph, "--profile", scratch / "profile.json"}), {"error[W140]"});
}

}  // namespace
}  // namespace weft::test
