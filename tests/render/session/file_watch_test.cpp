// Tests FileWatch with changes of files as editors, compilers and version control make them, and with changes
// that it must ignore.
#include "render/file_watch.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <future>

#include "file/write_file.h"
#include "tests/render/session/live_folder.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class FileWatching : public ::testing::Test {
 protected:
    void SetUp() override {
        Result<std::unique_ptr<render::FileWatch>> made = render::FileWatch::create(20ms);
        ASSERT_TRUE(made) << to_text(made.errors());
        watch_ = std::move(*made);
    }
    bool watch(const std::set<std::string>& names) {
        std::set<fs::path> files;
        for (const std::string& name : names) files.insert(folder_.path(name));
        return watch_->watch(files);
    }
    // The limit of 600 s is long, so that it is reached only if a bug makes wait() wait forever.
    bool notices(const std::function<void()>& change) { return changes_within(600s, change); }
    // A call that changes a file returns only after the kernel has queued the event. So it is enough to wait
    // one second for a report.
    bool ignores(const std::function<void()>& change) { return !changes_within(1s, change); }

    bool changes_within(std::chrono::seconds most, const std::function<void()>& change) {
        std::future<bool> noticed = std::async(std::launch::async, [this] { return watch_->wait(); });
        change();
        if (noticed.wait_for(most) != std::future_status::ready) watch_->wake();
        return noticed.get();
    }

    LiveFolder folder_;
    std::unique_ptr<render::FileWatch> watch_;
};

TEST_F(FileWatching, EveryWayOfSavingIsSeen) {
    EXPECT_TRUE(watch({"live.json", "tint.glsl"}));
    EXPECT_FALSE(watch({"live.json", "tint.glsl"})) << "nothing new";
    for (const LiveFolder::Way way : {LiveFolder::Way::rename, LiveFolder::Way::in_place})
        for (const char* name : {"live.json", "tint.glsl"})
            for (int time = 0; time < 2; ++time)
                EXPECT_TRUE(notices([&] { folder_.set(name, "x", way); })) << name;
    EXPECT_TRUE(notices([&] { folder_.remove("tint.glsl"); }));
    EXPECT_TRUE(notices([&] { folder_.restore(); }));
    EXPECT_TRUE(notices([&] {
        fs::create_symlink(folder_.path("live.json"), folder_.path("link"));
        fs::rename(folder_.path("link"), folder_.path("tint.glsl"));
    }));
}

// Tests a file that was written under another name and then linked to its place, so that it appears there
// with its complete content.
TEST_F(FileWatching, AFileThatIsLinkedIntoItsPlaceIsSeen) {
    static_cast<void>(watch({"linked.json"}));
    folder_.set("draft", "x");
    EXPECT_TRUE(notices([&] {
        fs::create_hard_link(folder_.path("draft"), folder_.path("linked.json"));
        fs::remove(folder_.path("draft"));
    }));
    fs::remove(folder_.path("linked.json"));
    EXPECT_TRUE(notices([] {})) << "the removal";
    EXPECT_TRUE(notices([&] { EXPECT_TRUE(write_file(folder_.path("linked.json").string(), "x")); }));
}

TEST_F(FileWatching, OtherFilesDoNotCount) {
    static_cast<void>(watch({"live.json"}));
    EXPECT_TRUE(ignores([&] {
        folder_.set("other.json", "x", LiveFolder::Way::in_place);
        std::ifstream(folder_.path("live.json")).get();
    }));
}

TEST_F(FileWatching, AFileThatIsNotThereYetIsWaitedFor) {
    EXPECT_TRUE(watch({"new/deeper/module.json"}));
    EXPECT_TRUE(notices([&] { fs::create_directory(folder_.path("new")); }));
    EXPECT_TRUE(watch({"new/deeper/module.json"})) << "there is a folder more";
    EXPECT_TRUE(notices([&] { fs::create_directory(folder_.path("new/deeper")); }));
    EXPECT_TRUE(watch({"new/deeper/module.json"}));
    EXPECT_TRUE(notices([&] { folder_.set("new/deeper/module.json", "x", LiveFolder::Way::in_place); }));
}

TEST_F(FileWatching, AFolderMayGoAndComeBack) {
    fs::create_directories(folder_.path("sub"));
    folder_.set("sub/a.glsl", "a");
    static_cast<void>(watch({"sub/a.glsl"}));
    EXPECT_TRUE(notices([&] { fs::remove_all(folder_.path("sub")); }));
    static_cast<void>(watch({"sub/a.glsl"}));
    EXPECT_TRUE(notices([&] {
        fs::create_directory(folder_.path("sub"));
        folder_.restore();
    }));
    EXPECT_TRUE(watch({"sub/a.glsl"})) << "a folder of the same name is another one";
    EXPECT_TRUE(notices([&] { folder_.set("sub/a.glsl", "b"); }));
    EXPECT_TRUE(notices([&] { fs::rename(folder_.path("sub"), folder_.path("away")); }));
}

// All changes are made before wait() begins, so the result does not depend on pauses between them on a slow
// machine.
TEST_F(FileWatching, SavesInARowAreOneChange) {
    static_cast<void>(watch({"live.json"}));
    for (int i = 0; i < 20; ++i) folder_.set("live.json", std::to_string(i), LiveFolder::Way::in_place);
    EXPECT_TRUE(notices([] {}));
    EXPECT_TRUE(ignores([] {}));
}

// On a busy machine, pauses between the saves may be long enough that wait() reports several changes. The
// last save must be reported in any case.
TEST_F(FileWatching, TheLastOfManySavesIsSeen) {
    static_cast<void>(watch({"live.json"}));
    std::future<int> changes = std::async(std::launch::async, [this] {
        int count = 0;
        for (std::string text; text != "19";) {
            if (!watch_->wait()) return -1;
            std::ifstream(folder_.path("live.json")) >> text;
            ++count;
        }
        return count;
    });
    for (int i = 0; i < 20; ++i) folder_.set("live.json", std::to_string(i), LiveFolder::Way::in_place);
    if (changes.wait_for(600s) != std::future_status::ready) watch_->wake();
    const int count = changes.get();
    EXPECT_GE(count, 1);
    EXPECT_LE(count, 20);
}

}  // namespace
}  // namespace weft::test
