// Tests rendering when the disk with the shader caches is full. The Mesa driver and Weft each have a cache.
// If Mesa writes to its cache and the disk is full, SIGBUS ends the program. `weft` must prevent this.
#include <gtest/gtest.h>

#include "tests/viewer/output/full_disk.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

class FullCache : public testing::Test {
 protected:
    void SetUp() override {
        if (!has_device()) GTEST_SKIP() << "no Vulkan device";
        if (!can_mount()) GTEST_SKIP() << "this user may not mount a file system";
    }
    // Renders with all caches on a disk of this size. The shell script `before` prepares the content of the
    // caches.
    [[nodiscard]] static RunResult render(const std::string& size, const std::string& before = "") {
        const ScratchFolder out;
        const std::string picture = out / "a.png";
        const std::string script = before +
                                   "\nexport XDG_CACHE_HOME=\"$DISK\" MESA_SHADER_CACHE_DIR=\"$DISK\"\n" +
                                   weft_in_shell({"render", "builtin:spheres", "--graph",
                                                  WEFT_SOURCE_DIR "/tests/render/reload/live.json", "--size",
                                                  "16x16", "-o", picture});
        RunResult run = run_on_small_disk(size, script);
        run.out = read_text(picture);
        return run;
    }
    static void expect_picture(const RunResult& run) {
        EXPECT_EQ(run.exit_code, 0) << run.text();
        EXPECT_TRUE(run.out.starts_with("\x89PNG")) << run.text();
    }
    static bool warns(const RunResult& run) {
        return run.err.find("warning[X513]: Mesa's shader cache in ") != std::string::npos;
    }
};

TEST_F(FullCache, RendersWithoutMesasCacheAndSaysSo) {
    const RunResult run = render("64k");
    expect_picture(run);
    EXPECT_TRUE(warns(run)) << run.text();
    EXPECT_NE(run.err.find("No space left on device"), std::string::npos) << run.text();
}

// When `weft` starts, it reserves disk space for the index file of Mesa's cache (1310728 bytes). On this disk
// no other cache file fits.
TEST_F(FullCache, RendersWhereOnlyTheIndexHasRoom) {
    const RunResult run = render("1292k");
    expect_picture(run);
    EXPECT_FALSE(warns(run)) << run.text();
}

// Another program may leave an index of full size that uses no disk space (a sparse file). `weft` must
// reserve the space for the index. This disk is too small, so `weft` must warn.
TEST_F(FullCache, TakesTheSpaceOfAnIndexThatHasNone) {
    const RunResult run = render(
        "64k", "mkdir \"$DISK/mesa_shader_cache\"; truncate -s 1310728 \"$DISK/mesa_shader_cache/index\"");
    expect_picture(run);
    EXPECT_TRUE(warns(run)) << run.text();
}

TEST_F(FullCache, RendersWithAReadOnlyHome) {
    const RunResult run = render("64k", "mount -o remount,ro \"$DISK\"");
    expect_picture(run);
    EXPECT_TRUE(warns(run)) << run.text();
}

}  // namespace
}  // namespace weft::test
