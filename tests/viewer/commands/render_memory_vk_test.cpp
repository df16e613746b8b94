// Tests that the memory of `weft render` does not grow with the number of frames, even if each frame is read
// back.
#include <gtest/gtest.h>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

TEST(RenderMemory, IsNotThatOfAllFramesThatWereReadBack) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    const auto most_bytes = [&](const char* frames) {
        const RunResult run = run_weft(
            {"render", "builtin:spheres", "--graph", WEFT_SOURCE_DIR "/tests/render/steady/branches.json",
             "--resource", "by_frame", "--size", "512x512", "--frames", frames, "-o", folder / "x.exr"});
        EXPECT_EQ(run.exit_code, 0) << run.text();
        return static_cast<int64_t>(run.max_rss_bytes);
    };
    // Each frame reads back 2 MiB, so 40 more frames would need 80 MiB if the memory were not reused.
    EXPECT_LT(most_bytes("44") - most_bytes("4"), 32 << 20);
}

}  // namespace
}  // namespace weft::test
