// Faulty graphs through the `weft` program: exit code 3 within 5 s and 1 GiB, the fault's place, and a
// remedy. The files are in bad/; "/*here*/" in one of them marks where the message must point.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "viewer/program.h"

namespace weft::test {
namespace {

constexpr double kMostTime_s = 5;
constexpr uint64_t kMostMemory_bytes = uint64_t{1} << 30;
constexpr const char* kBadFolder = WEFT_SOURCE_DIR "/tests/viewer/bad/";

struct BadGraph {
    const char* file;
    const char* code;
    const char* message;          // a part of it
    const char* help;             // a part of it
    const char* place = nullptr;  // the file that holds the mark, when it isn't the graph
    uint32_t offset = 0;          // columns from the mark, for faults inside strings
};

void PrintTo(const BadGraph& bad, std::ostream* out) {
    *out << bad.file;
}

constexpr BadGraph kBadGraphs[] = {
    {"truncated", "W001", "the file ends inside an object", "close the brace opened at line 8"},
    {"unknown_key", "W101", "unknown key \"resorces\"", "did you mean \"resources\"?"},
    {"unknown_pass_key", "W101", "unknown key \"shadr\"", "did you mean \"shader\"?"},
    {"duplicate_key", "W003", "the key \"sky\" is here twice", "remove one of the two"},
    {"wrong_type", "W102", "found number, wanted a list of references", "write a value of that kind"},
    {"number_in_quotes", "W102", "found string, wanted a number", "without quotes"},
    {"cycle", "W150", "dependency cycle: echo (reads hdr) -> sky (reads ldr) -> echo",
     "another version: name@pass"},
    {"unknown_resource", "W103", "reads unknown resource \"hrd\"", "did you mean \"hdr\"?"},
    {"unwritten_read", "W110", "reads \"hdr\", which no pass writes", "write it in the \"out\" of a pass"},
    {"unordered_writers", "W111", "\"sea\" and \"sky\" both write \"hdr\"",
     "\"after\": [\"sea\"] in \"sky\""},
    {"mip_out_of_range", "W105", "mip 3 of \"hdr\" is out of range", "only mip 0"},
    {"layer_out_of_range", "W105", "layer 1 of \"hdr\" is out of range", "only layer 0"},
    {"missing_shader", "W201", "shader \"tonemap/tonmap.frag\" not found",
     "did you mean \"tonemap/tonemap.frag\"?"},
    {"escaping_shader", "W201", "not found", "looked in"},
    {"glsl_error", "W202", "'amuont': undeclared identifier", "did you mean \"amount\"?",
     "shaders/inner.glsl"},
    {"missing_include", "W203", "nowhere.glsl", "looked for beside the file", "shaders/lonely.frag"},
    {"port_without_binding", "W112", "has nothing called \"hdx\"", "did you mean \"hdr\"?"},
    {"binding_without_port", "W112", "binds \"hdr\", but pass \"tonemap\" has no such port",
     "add it to \"in\""},
    {"wrong_numbers", "W112", "expects float values, but \"hdr\" has format \"rgba16u\"",
     "change the declaration in the shader"},
    {"unknown_format", "W116", "unknown format \"rgba16g\"", "\"rgba16f\"", nullptr, 1},
    {"bad_expression", "W106", "the expression ends where", "expressions know", nullptr, 9},
    {"unknown_name", "W107", "unknown name \"outptu\"", "did you mean \"output\"?", nullptr, 1},
    {"missing_key", "W108", "needs the key \"shader\"", "name the shader"},
    {"missing_value", "W113", "nothing gives Params.exposure", "\"params\": { \"exposure\": 0 }"},
    {"unknown_pin", "W104", "names unknown pass \"sly\"", "did you mean \"sky\"?"},
    {"unknown_import", "W118", "nothing offers the import \"bakcbuffer\"", "did you mean \"backbuffer\"?"},
    {"unknown_type", "W115", "unknown pass type \"cler\"", "did you mean \"clear\"?"},
    {"too_large", "W119", "is 40000x4", "the limit comes from the device profile"},
};

// "path:line:column" of the mark's end.
std::string marked_place(const std::string& path, uint32_t offset) {
    constexpr std::string_view kMark = "/*here*/";
    const std::string text = read_text(path);
    const size_t at = text.find(kMark);
    if (at == std::string::npos) return path + " has no mark";
    const size_t end = at + kMark.size();
    const size_t line_begin = text.rfind('\n', end) == std::string::npos ? 0 : text.rfind('\n', end - 1) + 1;
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    return path + ":" + std::to_string(line) + ":" + std::to_string(end - line_begin + 1 + offset);
}

void expect_refused(const RunResult& run, const std::vector<std::string>& wanted) {
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_LE(run.wall_s, kMostTime_s);
    EXPECT_LE(run.max_rss_bytes, kMostMemory_bytes);
    EXPECT_TRUE(run.out.empty()) << run.text();
    for (const std::string& part : wanted)
        EXPECT_NE(run.err.find(part), std::string::npos) << "wanted: " << part << "\n" << run.text();
}

class BadGraphTest : public testing::TestWithParam<BadGraph> {};

TEST_P(BadGraphTest, IsRefusedAtItsPlaceWithARemedy) {
    const BadGraph& bad = GetParam();
    const std::string graph = std::string(kBadFolder) + bad.file + ".json";
    const std::string place =
        marked_place(bad.place ? std::string(kBadFolder) + bad.place : graph, bad.offset);
    const RunResult run = run_weft({"check", graph});
    expect_refused(run, {place + ": error[" + bad.code + "]: ", bad.message});
    const size_t help = run.err.find("\n  help: ");
    ASSERT_NE(help, std::string::npos) << run.text();
    EXPECT_NE(run.err.find(bad.help, help), std::string::npos) << "wanted: " << bad.help << "\n"
                                                               << run.text();
    EXPECT_EQ(run.err.find("error["), run.err.rfind("error[")) << "one cause, one message\n" << run.text();
}

INSTANTIATE_TEST_SUITE_P(All, BadGraphTest, testing::ValuesIn(kBadGraphs),
                         [](const auto& row) { return std::string(row.param.file); });

TEST(BadGraph, TheGoodOneThatTheOthersAreMadeFromIsGood) {
    const RunResult run = run_weft({"check", std::string(kBadFolder) + "good.json"});
    EXPECT_EQ(run.exit_code, 0) << run.text();
}

TEST(BadGraph, AMissingFileIsNamed) {
    expect_refused(run_weft({"check", "no/such/graph.json"}),
                   {"no/such/graph.json: error[W002]", "help: check its spelling"});
}

TEST(BadGraph, RenderRefusesWhatCheckRefuses) {
    const std::string graph = std::string(kBadFolder) + "unknown_resource.json";
    const ScratchFolder scratch;
    const RunResult run =
        run_weft({"render", "builtin:spheres", "--size", "16x16", "--graph", graph, "-o", scratch / "a.png"});
    if (run.exit_code == 4) GTEST_SKIP() << "no Vulkan device";
    expect_refused(run, {marked_place(graph, 0) + ": error[W103]", "did you mean \"hdr\"?"});
    EXPECT_FALSE(std::filesystem::exists(scratch / "a.png"));
}

TEST(BadGraph, AllFaultsAreReportedAtOnce) {
    const ScratchFolder scratch;
    scratch.write("many.json", R"({
  "version": 1, "imports": { "backbuffer": "output" }, "consts": { "a": true },
  "resources": { "x": "rgba99" },
  "passes": { "p": { "type": "clear", "out": ["x"], "colour": 1 } }
})");
    expect_refused(run_weft({"check", scratch / "many.json"}),
                   {"2:73: error[W102]", "3:24: error[W116]", "4:53: error[W101]"});
}

// What hostile files do to parsers: depth, size, and bytes that are no text.
TEST(BadGraph, HostileFilesAreRefusedQuickly) {
    const ScratchFolder scratch;
    scratch.write("deep.json", std::string(200'000, '['));
    scratch.write("large.json", "{ \"name\": \"" + std::string(9u << 20, 'x') + "\" }");
    scratch.write("binary.json", std::string("\x7f"
                                             "ELF\x02\x01\xff\xfe\0\0",
                                             10));
    scratch.write("empty.json", "");
    expect_refused(run_weft({"check", scratch / "deep.json"}), {"error[W004]", "64 deep", "help: "});
    expect_refused(run_weft({"check", scratch / "large.json"}), {"error[W004]", "8 MiB", "help: "});
    expect_refused(run_weft({"check", scratch / "binary.json"}), {"binary.json:1:", "help: "});
    expect_refused(run_weft({"check", scratch / "empty.json"}),
                   {"error[W001]", "the file is empty", "help: "});
}

TEST(BadGraph, AParameterThatIsNotThereIsNamed) {
    const RunResult run = run_weft({"plan", std::string(kBadFolder) + "good.json", "--param", "exposur=1"});
    expect_refused(run, {"error[W120]", "no parameter \"exposur\"", "did you mean \"exposure\"?"});
}

TEST(BadProfile, IsRefusedToo) {
    const ScratchFolder scratch;
    const std::string graph = std::string(kBadFolder) + "good.json";
    scratch.write("profile.json", "{ \"name\": 7 }");
    expect_refused(run_weft({"check", graph, "--profile", scratch / "none.json"}), {"error[W141]", "help: "});
    expect_refused(run_weft({"check", graph, "--profile", scratch / "profile.json"}), {"error[W140]"});
}

}  // namespace
}  // namespace weft::test
