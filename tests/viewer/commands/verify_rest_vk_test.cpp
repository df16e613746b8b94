// Tests `weft render --verify-rest`: it finds a pass whose result depends on more than its inputs.
#include <gtest/gtest.h>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

RunResult verify(const std::string& graph, const std::string& frames) {
    const ScratchFolder scratch;
    return run_weft({"render", "builtin:spheres", "--graph", WEFT_SOURCE_DIR "/" + graph, "--frames", frames,
                     "--size", "16x16", "-o", "out.png", "--verify-rest"},
                    {}, scratch.path());
}

TEST(VerifyRest, NamesTheResourceOfAPassThatWritesOnlyAPart) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const RunResult run = verify("tests/render/rest/partial/partial.json", "3");
    EXPECT_EQ(run.exit_code, 6) << run.text();
    for (const char* part : {"error[W189]", "\"mid\" differs", "pass \"half\"", "partial.json:7:"})
        EXPECT_NE(run.err.find(part), std::string::npos) << run.text();
}

TEST(VerifyRest, TellsWhatWasVerified) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const RunResult run = verify("tests/render/rest/rest.json", "4");
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_NE(run.err.find("rested 18 of 24 times"), std::string::npos) << run.text();
    EXPECT_NE(verify("tests/render/rest/rest.json", "1").err.find("nothing was verified"), std::string::npos);
    EXPECT_NE(verify("graphs/reaction_diffusion.json", "2").err.find("no pass of this graph has \"rest\""),
              std::string::npos);
}

}  // namespace
}  // namespace weft::test
