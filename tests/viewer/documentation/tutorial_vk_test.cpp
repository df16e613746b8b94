// Follows the tutorial step by step in an empty folder: writes its files, runs its commands, makes its
// mistakes. To save time, pictures are small and show builtin:spheres; with WEFT_EXTENDED they show the
// tutorial's own scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>

#include "tests/viewer/gltf_file.h"
#include "tests/viewer/page/page_walk.h"
#include "tests/viewer/pictures/pfm_image.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

constexpr const char* kTutorialPage = "tutorial.md";
constexpr const char* kGraph = "tutorial/my.json";

std::string substituted(std::string text, const std::string& from, const std::string& to) {
    for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

// Returns the tutorial's command with three changes: a small picture size, the validation layer, and a PFM
// file instead of PNG, so that the test can read raw values. `weft view` also gets a number of frames.
// Without WEFT_EXTENDED, the commands show builtin:spheres.
std::string as_tested(std::string command) {
    command = substituted(command, "--size 480x270", "--size 64x36 --validate");
    command = substituted(command, "--headless", "--headless --frames 3");
    command = substituted(command, ".png", ".pfm");
    if (extended()) return command;
    command = substituted(command, " --time 22", "");
    command = substituted(command, "./weft view", "./weft view builtin:spheres");
    return substituted(command, "./weft render", "./weft render builtin:spheres --frames 2");
}

// Returns the difference between the smallest and the greatest value, for the channel with the largest
// difference.
float contrast(const PfmImage& image) {
    float most = 0;
    for (size_t c = 0; c < 3; ++c) {
        const auto [least, greatest] = std::ranges::minmax_element(
            image.texels, {}, [c](const std::array<float, 3>& texel) { return texel[c]; });
        most = std::max(most, (*greatest)[c] - (*least)[c]);
    }
    return most;
}

class Tutorial : public testing::Test {
 protected:
    void SetUp() override {
        if (!has_device()) GTEST_SKIP() << "no Vulkan device";
        folder_.write("weft", "#!/bin/sh\nexec '" WEFT_PROGRAM "' \"$@\"\n");
        std::filesystem::permissions(folder_.path() / "weft", std::filesystem::perms::owner_all);
    }

    [[nodiscard]] RunResult run(const std::string& command) const {
        return run_program({"sh", "-c", command + " 2>&1"}, {}, folder_.path());
    }

    // Expects that the picture which the command writes has contrast. The picture of the tutorial's first
    // step has none, so it is not checked.
    void expect_picture(const std::string& command) {
        const size_t at = command.find("-o ") + 3;
        const std::string file = command.substr(at, command.find(' ', at) - at);
        if (file == "tutorial/01.pfm") return;
        const auto image = read_pfm(folder_ / file);
        ASSERT_TRUE(image) << file;
        EXPECT_GT(contrast(*image), 0.05f) << file;
        ++pictures_;
    }

    void run_commands(const PageEvent& event) {
        for (const std::string& line : event.lines) {
            const std::string command = as_tested(line);
            const RunResult result = run(command);
            ASSERT_EQ(result.exit_code, 0) << command << "\n" << result.text();
            if (command.starts_with("./weft render")) expect_picture(command);
        }
    }

    void expect_printed(const PageEvent& event) {
        const PageMistake& mistake = event.mistake;
        const std::string right = mistake.file.empty() ? "" : read_text(folder_ / mistake.file);
        if (!mistake.file.empty()) {
            ASSERT_NE(right.find(mistake.right), std::string::npos) << mistake.right;
            folder_.write(mistake.file, substituted(right, mistake.right, mistake.wrong));
        }
        ASSERT_TRUE(event.lines.front().starts_with("$ "));
        const RunResult result = run(event.lines.front().substr(2));
        EXPECT_EQ(result.out, joined({event.lines.begin() + 1, event.lines.end()}));
        if (!mistake.file.empty()) folder_.write(mistake.file, right);
        ++printed_;
    }

    ScratchFolder folder_;
    size_t pictures_ = 0;
    size_t printed_ = 0;
};

// The file names in "<!-- file: NAME -->" are comments, which readers of the page do not see. So the page
// must also show each name above its file.
TEST(TutorialPage, NamesEachFileAboveIt) {
    std::istringstream page(read_text(WEFT_SOURCE_DIR "/docs/tutorial.md"));
    size_t files = 0;
    std::array<std::string, 3> last;
    while (std::getline(page, last[2])) {
        if (last[2].starts_with("<!-- file: ")) {
            const std::string name = last[2].substr(11, last[2].find(" -->") - 11);
            EXPECT_EQ(last[0], "**`" + name + "`**");
            EXPECT_EQ(last[1], "");
            ++files;
        }
        std::rotate(last.begin(), last.begin() + 1, last.end());
    }
    EXPECT_GE(files, 20u);
}

TEST_F(Tutorial, FollowedLiterallyDrawsAndPrintsWhatThePageSays) {
    size_t steps = 0;
    for (const PageEvent& event : events_of(kTutorialPage)) {
        const testing::ScopedTrace trace(WEFT_SOURCE_DIR "/docs/tutorial.md", event.line, "this fence");
        switch (event.kind) {
            case PageEvent::Kind::file:
                folder_.write(event.name, joined(event.lines));
                steps += event.name == kGraph;
                EXPECT_LE(event.lines.size(), 40u) << event.name;
                break;
            case PageEvent::Kind::commands:
                run_commands(event);
                break;
            case PageEvent::Kind::console:
                expect_printed(event);
                break;
        }
        if (HasFatalFailure()) return;
    }
    EXPECT_EQ(steps, 10u);
    EXPECT_GE(pictures_, 9u) << "one of each step but the first";
    EXPECT_EQ(printed_, 12u) << "the empty file, a mistake in each step, the graph's own tests";
}

}  // namespace
}  // namespace weft::test
