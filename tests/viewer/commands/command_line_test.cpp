// Tests the behaviour that scripts rely on: exit codes, data on stdout, and the messages of the commands.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

using Json = nlohmann::json;

struct BadUsage {
    const char* name;
    std::vector<std::string> arguments;
    const char* message;
};

void PrintTo(const BadUsage& bad, std::ostream* out) {
    *out << bad.name;
}

const std::vector<BadUsage>& bad_usages() {
    static const std::vector<BadUsage> usages{
        {"Nothing", {}, "weft --help"},
        {"UnknownCommand", {"rendr"}, "rendr"},
        {"UnknownFlag", {"render", "--sizes", "8x8"}, "--sizes"},
        {"EmptySize", {"render", "--size", "0x5"}, "is not a size; wanted WIDTHxHEIGHT"},
        {"HugeSize", {"render", "--size", "99999x5"}, "is not a size; wanted WIDTHxHEIGHT"},
        {"NoFrames", {"render", "--frames", "0"}, "--frames"},
        {"ParameterWithoutValue", {"render", "--param", "exposure"}, "is not a parameter; wanted NAME=VALUE"},
        {"ParameterThatIsNoNumber", {"render", "--param", "exposure=much"}, "wanted a number, true or false"},
        {"TurnsWithoutList", {"render", "--turns", "order"}, "is not a list of turns; wanted NAME=ROUND"},
        {"TurnsWithAWord", {"render", "--turns", "order=1,x"}, "is not a number of a round"},
        {"TurnsOfAGraphWithoutThem",
         {"render", "--turns", "order=1"},
         "has no import \"order\" of kind \"turns\""},
        {"UnknownEnvironment", {"render", "--env", "moon"}, "--env"},
        {"UnknownPicture", {"render", "-o", "a.gif"}, ".png, .exr or .pfm"},
        {"CameraOfSixNumbers", {"render", "builtin:spheres", "--camera", "1,2,3,4,5,6"}, "seven numbers"},
        {"CheckWithoutFile", {"check"}, "FILE"},
        {"UnknownPlanFormat", {"plan", kDeferredGraph, "--format", "pdf"}, "--format"},
        {"TimeOutsideTheDay", {"render", "--time", "25"}, "--time"},
        {"TimeOfASceneWithoutHours", {"render", "builtin:spheres", "--time", "12"}, "has no time of day"},
        {"LaterProfile", {"render", "--profile", "a.json"}, "is not available in this version"},
        {"CheckJsonAndSarif", {"check", kDeferredGraph, "--json", "--sarif"}, "excludes"},
        {"LaterView", {"view"}, "this version of weft has no window yet"},
        {"ExplainUnknownQuestion", {"explain", kDeferredGraph, "why", "x"}, "QUESTION"},
        {"ExplainOnePassOfTwo", {"explain", kDeferredGraph, "barrier", "gbuffer"}, "barrier PASS PASS"},
        {"ExplainTwoPassesOfOne", {"explain", kDeferredGraph, "wait", "gbuffer", "lighting"}, "wait PASS"},
        {"DiffOfOne", {"diff", kDeferredGraph}, "TO"},
        {"SchemaOfTwo", {"schema", kDeferredGraph, kDeferredGraph}, "not expected"},
        {"BenchWithoutWhat", {"bench"}, "subcommand is required"},
        {"BenchShape", {"bench", "compile", "--shape", "star"}, "--shape"},
        {"BenchOfNoPasses", {"bench", "compile", "--passes", "0"}, "--passes"},
        {"BenchOfNoRounds", {"bench", "frame", "--rounds", "0"}, "--rounds"},
        {"BenchOfNoLights", {"bench", "frame", "--lights", "0,10"}, "--lights"},
        {"BenchPlotThatIsNoSvg",
         {"bench", "frame", "--plot", "curve.png"},
         "is not a name of a plot; wanted FILE.svg"},
        {"TooManyQueues", {"plan", kDeferredGraph, "--queues", "5"}, "--queues"},
        {"CompareOfOne", {"compare", "a.png"}, "TEST"},
        {"CompareUnknownMetric", {"compare", "a.png", "b.png", "--metric", "ssim"}, "--metric"},
        {"CompareMaxOfPsnr", {"compare", "a", "b", "--metric", "psnr", "--max", "9"}, "use --min for psnr"},
        {"CompareMinOfFlip", {"compare", "a", "b", "--min", "9"}, "use --max for flip and max"},
        {"CompareLimitThatIsNoNumber", {"compare", "a", "b", "--max", "nan"}, "is not a finite number"},
        {"CompareHeatMapThatIsNoPng", {"compare", "a", "b", "-o", "heat.exr"}, "the heat map is a .png file"},
        {"ProbesThatAreNoPng", {"scene", "-o", "probes.svg"}, "a name that ends in .png"},
        {"SceneThatIsAGraph", {"scene", kDeferredGraph}, "is a graph, not a scene"},
    };
    return usages;
}

// A flag that takes a number, and the range of the number. The command must refuse values outside the range,
// and texts that are not finite numbers.
struct NumberFlag {
    const char* name;
    std::vector<std::string> command;
    const char* flag;
    const char* range;
    // Texts that must be refused: a value below the range and a value above it. For a flag that takes a list,
    // one number of the list is outside the range.
    const char* below;
    const char* above;
};

void PrintTo(const NumberFlag& flag, std::ostream* out) {
    *out << flag.name;
}

const std::vector<NumberFlag>& number_flags() {
    static const std::vector<NumberFlag> flags{
        {"Timeout", {"render"}, "--timeout", "0.001 to 3600 s", "0", "3600.5"},
        {"FixedDt", {"render"}, "--fixed-dt", "0 to 3600 s", "-1/60", "7201/2"},
        {"Exposure", {"render"}, "--exposure", "-40 to 40 EV", "-41", "1e9"},
        {"Time", {"render"}, "--time", "0 to 24 hours", "-0.1", "24.1"},
        {"Frames", {"render"}, "--frames", "1 to 1000000", "0", "1000001"},
        {"Lights", {"render"}, "--lights", "1 to 65536", "0", "65537"},
        {"Seed", {"render"}, "--seed", "0 to 4294967295", "-1", "4294967296"},
        {"Queues", {"render"}, "--queues", "1 to 4", "0", "5"},
        {"ViewTimeout", {"view", "--headless"}, "--timeout", "0.001 to 3600 s", "-1", "3601"},
        {"ViewFrames", {"view", "--headless"}, "--frames", "1 to 100000000", "0", "100000001"},
        {"PlanQueues", {"plan", kDeferredGraph}, "--queues", "1 to 4", "-1", "5"},
        {"BenchPasses", {"bench", "compile"}, "--passes", "1 to 1000000", "0", "1000001"},
        {"BenchSeed", {"bench", "compile"}, "--seed", "0 to 4294967295", "-1", "4294967296"},
        {"BenchRounds", {"bench", "frame"}, "--rounds", "1 to 1000", "0", "1001"},
        {"BenchLights", {"bench", "frame"}, "--lights", "1 to 65536", "1,0", "10,65537"},
        {"BenchTimeout", {"bench", "frame"}, "--timeout", "0.001 to 3600 s", "0", "3601"},
        {"CompareMax", {"compare", "a", "b"}, "--max", "-1e+30 to 1e+30", "-1e31", "1e31"},
        {"CompareMin", {"compare", "a", "b"}, "--min", "-1e+30 to 1e+30", "-1e31", "1e31"},
    };
    return flags;
}

class NumberFlagTest : public testing::TestWithParam<NumberFlag> {};

TEST_P(NumberFlagTest, TakesFiniteNumbersWithinItsRangeAlone) {
    const NumberFlag& flag = GetParam();
    for (const std::string value : {"nan", "-inf", "1e999", "0x1p1", "1/0", flag.below, flag.above}) {
        std::vector<std::string> words = flag.command;
        words.push_back(std::string(flag.flag) + "=" + value);
        const RunResult run = run_weft(words);
        EXPECT_EQ(run.exit_code, 2) << value << "\n" << run.text();
        EXPECT_NE(run.err.find(flag.flag), std::string::npos) << value << "\n" << run.text();
        EXPECT_NE(run.err.find(flag.range), std::string::npos) << value << "\n" << run.text();
    }
}

INSTANTIATE_TEST_SUITE_P(All, NumberFlagTest, testing::ValuesIn(number_flags()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(CommandLine, NumbersInOtherArgumentsAreFiniteToo) {
    for (const char* value : {"nan", "inf", "1e39", "-1e39", "0x10", "1/2"}) {
        const RunResult run = run_weft({"render", "--param", std::string("exposure=") + value});
        EXPECT_EQ(run.exit_code, 2) << run.text();
    }
    for (const char* size :
         {"-1x8", "8x-1", "+8x8", " 8x8", "8x 8", "8x8x8", "8.0x8", "nanx8", "4294967297x8", "x8", "8x"}) {
        const RunResult run = run_weft({"render", "--size", size});
        EXPECT_EQ(run.exit_code, 2) << run.text();
        EXPECT_NE(run.err.find("each 1 to 16384"), std::string::npos) << run.text();
    }
    for (const char* camera :
         {"nan,0,5,0,0,0,50", "0,0,inf,0,0,0,50", "0,0,5,0,0,0,nan", "0,0,5,0,0,0,0", "0,0,5,0,0,0,180",
          "1e30,0,5,0,0,0,50", "0,0,5,0,0,5,50", "1,2,3,4,5,6,7,8", "1,2,3,,5,6,7"}) {
        const RunResult run = run_weft({"render", "builtin:spheres", "--camera", camera});
        EXPECT_EQ(run.exit_code, 2) << run.text();
        EXPECT_NE(run.err.find("error[X520]"), std::string::npos) << run.text();
    }
}

class BadUsageTest : public testing::TestWithParam<BadUsage> {};

TEST_P(BadUsageTest, IsExitCode2AndSaysWhy) {
    const RunResult run = run_weft(GetParam().arguments);
    EXPECT_EQ(run.exit_code, 2) << run.text();
    EXPECT_TRUE(run.out.empty()) << run.text();
    EXPECT_NE(run.err.find(GetParam().message), std::string::npos) << run.text();
}

INSTANTIATE_TEST_SUITE_P(All, BadUsageTest, testing::ValuesIn(bad_usages()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(CommandLine, HelpAndVersionAreData) {
    const RunResult help = run_weft({"render", "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.out.find("--validate"), std::string::npos) << help.text();
    EXPECT_EQ(help.out.find("--test-drop-barriers"), std::string::npos) << "a test hook is no feature";
    const RunResult version = run_weft({"--version"});
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_TRUE(version.out.starts_with("weft ")) << version.text();
}

TEST(Check, TheShippedGraphIsGoodAndPrintsNothing) {
    const RunResult run = run_weft({"check", kDeferredGraph});
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_TRUE(run.out.empty()) << run.text();
    EXPECT_NE(run.err.find("deferred.json: ok"), std::string::npos) << run.text();
}

TEST(Check, JsonHoldsEveryFieldOfTheContract) {
    const RunResult good = run_weft({"check", "--json", kDeferredGraph});
    EXPECT_EQ(good.exit_code, 0) << good.text();
    EXPECT_EQ(Json::parse(good.out), Json::array()) << good.text();

    const std::string bad = WEFT_SOURCE_DIR "/tests/diagnostics/W103_port.json";
    const RunResult run = run_weft({"check", "--json", kDeferredGraph, bad});
    EXPECT_EQ(run.exit_code, 3) << run.text();
    const Json list = Json::parse(run.out);
    ASSERT_EQ(list.size(), 1u) << run.text();
    const Json& fault = list[0];
    EXPECT_EQ(fault.at("code"), "W103");
    EXPECT_EQ(fault.at("severity"), "error");
    EXPECT_EQ(fault.at("file"), bad);
    EXPECT_EQ(fault.at("line"), 7);
    EXPECT_EQ(fault.at("column"), 46);
    EXPECT_EQ(fault.at("pointer"), "/passes/show/in/src");
    EXPECT_NE(fault.at("message").get<std::string>().find("colour"), std::string::npos);
    EXPECT_FALSE(fault.at("help").empty());
    EXPECT_TRUE(fault.at("notes").is_array());
    EXPECT_TRUE(fault.at("tier").is_null());
}

TEST(Plan, SpeaksTextJsonAndDot) {
    const RunResult text = run_weft({"plan", kDeferredGraph});
    EXPECT_EQ(text.exit_code, 0) << text.text();
    for (const char* pass : {"lightUpload", "gbuffer", "lighting", "glass", "tonemap"})
        EXPECT_NE(text.out.find(pass), std::string::npos) << text.text();

    const RunResult json = run_weft({"plan", kDeferredGraph, "--format", "json"});
    EXPECT_EQ(json.exit_code, 0) << json.text();
    const Json plan = Json::parse(json.out);
    EXPECT_EQ(plan.at("hash").get<std::string>().size(), 32u);
    // Passes without readers do not run: those of the debug views of light probes.
    EXPECT_EQ(plan.at("schedule").at("order").size() + 5, plan.at("graph").at("passes").size());

    const RunResult dot = run_weft({"plan", kDeferredGraph, "--format", "dot"});
    EXPECT_EQ(dot.exit_code, 0) << dot.text();
    EXPECT_TRUE(dot.out.starts_with("digraph")) << dot.text();
}

TEST(Plan, IsTheSameBytesEveryTimeAndGoesToAFile) {
    const ScratchFolder scratch;
    const RunResult first = run_weft({"plan", kDeferredGraph, "--format", "json"});
    const RunResult second =
        run_weft({"plan", kDeferredGraph, "--format", "json", "-o", scratch / "plan.json"});
    EXPECT_EQ(second.exit_code, 0) << second.text();
    EXPECT_TRUE(second.out.empty());
    EXPECT_EQ(read_text(scratch / "plan.json"), first.out);
    const RunResult nowhere = run_weft({"plan", kDeferredGraph, "-o", scratch / "no/folder/plan.txt"});
    EXPECT_EQ(nowhere.exit_code, 1) << nowhere.text();
    EXPECT_NE(nowhere.err.find("error[X510]"), std::string::npos) << nowhere.text();
}

TEST(Plan, DependsOnTheSize) {
    const RunResult small = run_weft({"plan", kDeferredGraph, "--size", "320x180", "--format", "json"});
    const RunResult large = run_weft({"plan", kDeferredGraph, "--size", "641x361", "--format", "json"});
    EXPECT_EQ(small.exit_code, 0) << small.text();
    EXPECT_NE(Json::parse(small.out).at("hash"), Json::parse(large.out).at("hash"));
}

TEST(Plan, TellsWhereMemoryPeaksAndWhoIsAliveThere) {
    const RunResult run = run_weft({"plan", kDeferredGraph});
    EXPECT_NE(
        run.out.find(" gbuffer: hdr (7200.0 KiB) environmentRaw (4096.0 KiB) albedo (3600.0 KiB) depth"),
        std::string::npos)
        << run.text();
    for (const char* part :
         {"sum of resources ", "peak of live resources ", "heaps ", "excess of the heaps over the peak "})
        EXPECT_NE(run.out.find(part), std::string::npos) << part;
}

TEST(Plan, SpeaksOfQueues) {
    const RunResult run = run_weft({"plan", kDeferredGraph, "--queues", "3", "--profile", "discrete"});
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_NE(run.out.find("queues 0 graphics of family 0, 1 compute of family 1, 2 transfer of family 2"),
              std::string::npos)
        << run.text();
}

TEST(Profiles, TheShippedGraphFitsAllOfThemByName) {
    for (const char* name : {"lavapipe", "discrete", "integrated", "tiler", "hostile"}) {
        const RunResult run = run_weft({"check", kDeferredGraph, "--profile", name, "--queues", "3"});
        EXPECT_EQ(run.exit_code, 0) << run.text();
    }
    const RunResult plan = run_weft({"plan", kDeferredGraph, "--profile", "hostile"});
    EXPECT_EQ(plan.exit_code, 0) << plan.text();
    EXPECT_NE(plan.out.find("memory type 2, device-local"), std::string::npos) << plan.text();
}

TEST(Profiles, AnUnknownNameIsGuessedAt) {
    const RunResult run = run_weft({"plan", kDeferredGraph, "--profile", "discret"});
    EXPECT_EQ(run.exit_code, 3) << run.text();
    for (const char* part : {"error[W141]", "did you mean \"discrete\"?", "hostile, integrated"})
        EXPECT_NE(run.err.find(part), std::string::npos) << run.text();
}

TEST(Profiles, TooSmallAHeapIsAWarning) {
    const RunResult run =
        run_weft({"check", kDeferredGraph, "--profile", "integrated", "--size", "3840x2160"});
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_NE(run.err.find("warning[W142]"), std::string::npos) << run.text();
    EXPECT_NE(run.err.find("the largest resources at the peak are hdr 63.3 MiB"), std::string::npos)
        << run.text();
}

TEST(Doctor, DescribesTheMachineAndItsProfileWorks) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const RunResult text = run_weft({"doctor"});
    EXPECT_EQ(text.exit_code, 0) << text.text();
    EXPECT_NE(text.out.find("chosen device"), std::string::npos) << text.text();
    const RunResult json = run_weft({"doctor", "--json"});
    EXPECT_EQ(json.exit_code, 0) << json.text();
    EXPECT_TRUE(Json::parse(json.out).contains("formats")) << json.text();
    const ScratchFolder scratch;
    scratch.write("here.json", json.out);
    const RunResult check = run_weft({"check", kDeferredGraph, "--profile", scratch / "here.json"});
    EXPECT_EQ(check.exit_code, 0) << check.text();
}

const Environment kNoDriver{{"VK_DRIVER_FILES", "/nonexistent"}, {"VK_ICD_FILENAMES", "/nonexistent"}};

TEST(NoDevice, IsExitCode4AndNamesWhatToInstall) {
    const ScratchFolder scratch;
    const RunResult render =
        run_weft({"render", "builtin:spheres", "--size", "16x16", "-o", scratch / "a.png"}, kNoDriver);
    EXPECT_EQ(render.exit_code, 4) << render.text();
    EXPECT_NE(render.err.find("mesa-vulkan-drivers"), std::string::npos) << render.text();
    const RunResult doctor = run_weft({"doctor"}, kNoDriver);
    EXPECT_EQ(doctor.exit_code, 4) << doctor.text();
    EXPECT_NE(doctor.err.find("mesa-vulkan-drivers"), std::string::npos) << doctor.text();
}

TEST(NoDevice, GraphsAreCheckedAllTheSame) {
    const RunResult run = run_weft({"check", kDeferredGraph}, kNoDriver);
    EXPECT_EQ(run.exit_code, 0) << run.text();
}

TEST(NoDevice, AnUnknownDeviceIsOneToo) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const RunResult run = run_weft({"doctor", "--device", "no such device"});
    EXPECT_EQ(run.exit_code, 4) << run.text();
    EXPECT_NE(run.err.find("error[V403]"), std::string::npos) << run.text();
}

TEST(TimeOut, IsExitCode7NamingThePassesInFlight) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    // The loop of pass "turning" is practically endless, so the frame exceeds the time limit of 2 s.
    folder.write("endless.comp", R"(#version 460
layout(local_size_x = 8, local_size_y = 8) in;
writeonly uniform image2D x;
void main() {
    float f = 1;
    for (uint i = 0; i < 4000000000u; ++i)
        for (uint j = 0; j < 4000000000u; ++j) f = sin(f * float(i ^ j));
    imageStore(x, ivec2(gl_GlobalInvocationID.xy), vec4(f));
}
)");
    folder.write("endless.json", R"({ "version": 1, "imports": { "backbuffer": "output" },
  "resources": { "x": "rgba8" },
  "passes": {
    "turning": { "type": "compute", "shader": "endless.comp", "out": ["x"] },
    "show": { "type": "copy", "in": ["x"], "out": ["backbuffer"] }
  }
})");
    const RunResult run = run_weft({"render", "builtin:spheres", "--graph", folder / "endless.json", "--size",
                                    "256x256", "--timeout", "2", "--frames", "3", "-o", folder / "late.png"});
    EXPECT_EQ(run.exit_code, 7) << run.text();
    EXPECT_NE(run.err.find("V407"), std::string::npos) << run.text();
    EXPECT_NE(run.err.find("turning"), std::string::npos) << run.text();
}

// The shader loops for a very long time. The message must name the number of objects that the passes draw,
// because a scene with too many objects is another possible cause of a time-out.
TEST(TimeOut, CountsTheObjectsThatThePassesInFlightDraw) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    std::filesystem::copy(WEFT_SOURCE_DIR "/docs/examples", folder.path(),
                          std::filesystem::copy_options::recursive);
    std::string shader = read_text(folder.path() / "ink/surfaces/surfaces.frag");
    const std::string turns =
        "for (uint i = 0; i < 4000000000u; ++i) for (uint j = 0; j < 4000000000u; ++j) light = "
        "sin(light * float(i ^ j));\n";
    shader.replace(shader.find("const float light"), 17, "float light");
    shader.insert(shader.find("const float luminance"), turns);
    folder.write("ink/surfaces/surfaces.frag", shader);
    const RunResult run = run_weft({"render", "builtin:spheres", "--size", "64x64", "--timeout", "2",
                                    "--graph", folder / "ink.json", "-o", folder / "late.png"});
    EXPECT_EQ(run.exit_code, 7) << run.text();
    EXPECT_NE(run.err.find("error[V407]"), std::string::npos) << run.text();
    EXPECT_NE(run.err.find("the unfinished passes draw these numbers of objects: surfaces 5"),
              std::string::npos)
        << run.text();
}

// A time limit of 1 ms may expire anywhere: during an upload, during a frame, or not at all.
TEST(TimeOut, NeverCrashesWhereverItStrikes) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    for (int i = 0; i < 10; ++i) {
        const RunResult run = run_weft({"render", "builtin:spheres", "--size", "64x64", "--timeout", "0.001",
                                        "-o", folder / "late.png"});
        EXPECT_TRUE(run.exit_code == 7 || run.exit_code == 0) << run.text();
    }
}

}  // namespace
}  // namespace weft::test
