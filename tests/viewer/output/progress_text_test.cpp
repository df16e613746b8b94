#include "viewer/output/progress_text.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace weft::viewer {
namespace {

std::string all_of(ProgressText& text, const std::string& what, uint64_t total, double step_s) {
    std::string said;
    for (uint64_t done = 1; done <= total; ++done)
        said += text.at(static_cast<double>(done) * step_s, what, done, total);
    return said;
}

TEST(ProgressText, ShortWorkIsSilent) {
    for (const bool terminal : {false, true}) {
        ProgressText text("loading a.glb", terminal);
        EXPECT_EQ(all_of(text, "textures", 9, 0.1), "");
        EXPECT_EQ(text.finish(), "");
    }
}

TEST(ProgressText, AFileGetsALineForEachTenth) {
    ProgressText text("loading a.glb", false);
    const std::string said = all_of(text, "textures", 100, 1);
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 10) << said;
    EXPECT_TRUE(said.starts_with(
        "weft: loading a.glb: textures, 10 of 100\nweft: loading a.glb: textures, 20 of 100\n"))
        << said;
    EXPECT_TRUE(said.ends_with("textures, 100 of 100\n")) << said;
    // The stage "meshes" is new, so its count starts again, and its first line appears at once.
    EXPECT_EQ(text.at(200, "meshes", 1, 2), "weft: loading a.glb: meshes, 1 of 2\n");
    EXPECT_EQ(text.finish(), "");
}

TEST(ProgressText, ATerminalGetsOneLineThatIsWiped) {
    ProgressText text("loading a.glb", true);
    EXPECT_EQ(text.at(1.5, "textures", 1, 100), "\r\x1b[Kweft: loading a.glb: textures, 1 of 100");
    EXPECT_EQ(text.at(1.55, "textures", 2, 100), "") << "ten times a second at most";
    EXPECT_EQ(text.at(1.65, "textures", 3, 100), "\r\x1b[Kweft: loading a.glb: textures, 3 of 100");
    EXPECT_EQ(text.finish(), "\r\x1b[K");
    EXPECT_EQ(text.finish(), "");
}

}  // namespace
}  // namespace weft::viewer
