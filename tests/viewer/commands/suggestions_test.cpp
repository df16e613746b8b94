// Tests that a misspelt name on the command line gets a suggestion, for every kind of name.
#include <gtest/gtest.h>

#include <filesystem>

#include <ostream>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

constexpr const char* kLive = WEFT_SOURCE_DIR "/tests/render/reload/live.json";

struct Slip {
    const char* name;
    std::vector<std::string> arguments;
    const char* guess;
    int exit_code;
    bool needs_device = false;
};

void PrintTo(const Slip& slip, std::ostream* out) {
    *out << slip.name;
}

const std::vector<Slip>& slips() {
    static const std::vector<Slip> all{
        {"Command", {"rendr"}, "\"rendr\": did you mean \"render\"?", 2},
        {"BenchCommand", {"bench", "frme"}, "\"frme\": did you mean \"frame\"?", 2},
        {"Flag", {"render", "--sizes", "8x8"}, "\"--sizes\": did you mean \"--size\"?", 2},
        {"FlagWithAValue", {"render", "--siez=8x8"}, "\"--siez\": did you mean \"--size\"", 2},
        {"FlagOfBench", {"bench", "frame", "--grahps", "a"}, "\"--grahps\": did you mean \"--graphs\"?", 2},
        {"Format", {"plan", kDeferredGraph, "--format", "htlm"}, "did you mean \"html\"?", 2},
        {"Metric", {"compare", "a", "b", "--metric", "psrn"}, "did you mean \"psnr\"?", 2},
        {"Shape", {"bench", "compile", "--shape", "chian"}, "did you mean \"chain\"?", 2},
        {"Question", {"explain", kDeferredGraph, "resorce", "hdr"}, "did you mean \"resource\"?", 2},
        {"Environment", {"render", "--env", "ksy"}, "did you mean \"sky\"?", 2},
        {"GraphAsScene",
         {"render", kDeferredGraph},
         "weft render --graph " WEFT_SOURCE_DIR "/graphs/deferred.json",
         2},
        {"GraphAsSceneOfView", {"view", kDeferredGraph, "--headless"}, "is a graph, not a scene", 2},
        {"GraphAsSceneOfBench", {"bench", "frame", kDeferredGraph}, "is a graph, not a scene", 2},
        {"Pass", {"explain", kDeferredGraph, "culled", "lightin"}, "did you mean \"lighting\"?", 3},
        {"Resource", {"explain", kDeferredGraph, "resource", "hdrr"}, "did you mean \"hdr\"?", 3},
        {"Tier", {"check", kLive, "--tier", "lwo"}, "did you mean \"low\"?", 3},
        {"TierOfDiff",
         {"diff", WEFT_SOURCE_DIR "/tests/render/reload/live.json:lwo", kLive},
         "did you mean \"low\"?",
         3},
        {"Parameter", {"check", kDeferredGraph, "--param", "exposur=1"}, "did you mean \"exposure\" or", 3},
        {"Profile", {"plan", kDeferredGraph, "--profile", "discret"}, "did you mean \"discrete\"?", 3},
        {"BuiltInScene", {"render", "builtin:sphers"}, "did you mean \"spheres\"?", 3},
        {"BuiltInSceneWithoutItsPrefix", {"render", "sphers"}, "did you mean \"builtin:spheres\"?", 3},
        {"Camera", {"render", "--camera", "galery"}, "did you mean \"gallery\"?", 3},
        {"GraphFile", {"plan", WEFT_SOURCE_DIR "/graphs/defered.json"}, "/graphs/deferred.json\"?", 3},
        {"GraphFileAsJson", {"check", "--json", WEFT_SOURCE_DIR "/graphs/defered.json"}, "did you mean", 3},
        {"ShippedGraph", {"render", "--graph", "deferred"}, "graphs/deferred.json\"", 3},
        {"Picture",
         {"compare", WEFT_SOURCE_DIR "/tests/golden/deferred-atrium-cuort.png", "b.png"},
         "deferred-atrium-court.png\"",
         3},
        {"ObservedResource",
         {"render", "builtin:spheres", "--resource", "albdo"},
         "did you mean \"albedo\"?",
         3,
         true},
        {"DebugView", {"render", "--debug", "Normls"}, "did you mean \"Normals\"", 3},
        {"Device", {"doctor", "--device", "llvmpiep"}, "no device matches \"llvmpiep\"", 4, true},
    };
    return all;
}

class Suggested : public testing::TestWithParam<Slip> {};

TEST_P(Suggested, ForAMisspeltName) {
    if (GetParam().needs_device && !has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder scratch;
    const RunResult run = run_weft(GetParam().arguments, {}, scratch.path());
    EXPECT_EQ(run.exit_code, GetParam().exit_code) << run.text();
    EXPECT_NE((run.err + run.out).find(GetParam().guess), std::string::npos) << run.text();
}

INSTANTIATE_TEST_SUITE_P(All, Suggested, testing::ValuesIn(slips()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Suggestions, NoFileIsSuggestedForItself) {
    const ScratchFolder scratch;
    std::filesystem::create_symlink("nowhere.json", scratch / "link.json");
    const RunResult run = run_weft({"check", "link.json"}, {}, scratch.path());
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_EQ(run.err.find("did you mean"), std::string::npos) << run.text();
}

TEST(Suggestions, OfADeviceAreWordsOfItsName) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const RunResult devices = run_weft({"doctor"});
    const size_t at = devices.out.find("chosen device     ");
    ASSERT_NE(at, std::string::npos) << devices.text();
    const std::string rest = devices.out.substr(at + 18);
    std::string word = rest.substr(0, rest.find_first_of(" :"));
    const std::string wanted = "did you mean \"" + word + "\"";
    std::swap(word[1], word[2]);
    std::swap(word[word.size() - 1], word[word.size() - 2]);
    const RunResult run = run_weft({"doctor", "--device", word + "x"});
    EXPECT_NE(run.err.find(wanted), std::string::npos) << run.text();
}

}  // namespace
}  // namespace weft::test
