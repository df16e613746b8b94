// Tests that the old file stays if the program is killed while it writes, and that the data is stored on the
// disk before the new file takes the place of the old one.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;
constexpr const char* kOldContent = "the old file";

class Interrupted : public testing::Test {
 protected:
    void SetUp() override {
        scratch_.write("folder/out.json", kOldContent);
        if (write_under_strace({}).exit_code != 0) GTEST_SKIP() << "strace is missing or may not trace";
        whole_ = read_text(out());
        scratch_.write("folder/out.json", kOldContent);
    }
    // Runs `weft schema` under strace, which injects faults such as "fsync:signal=KILL" into system calls.
    [[nodiscard]] RunResult write_under_strace(const std::vector<std::string>& faults) const {
        std::vector<std::string> words{"strace",
                                       "-f",
                                       "-qq",
                                       "-o",
                                       scratch_ / "trace",
                                       "-e",
                                       "trace=openat,write,fsync,linkat,renameat,renameat2,close"};
        for (const std::string& fault : faults) words.insert(words.end(), {"-e", "inject=" + fault});
        words.insert(words.end(), {WEFT_PROGRAM, "schema", "-o", out()});
        return run_program(words, {{"ASAN_OPTIONS", "detect_leaks=0"}});
    }
    [[nodiscard]] std::string out() const { return scratch_ / "folder/out.json"; }
    [[nodiscard]] size_t files() const {
        const fs::directory_iterator folder(scratch_.path() / "folder");
        return static_cast<size_t>(std::distance(begin(folder), end(folder)));
    }
    // Returns true if the file system supports files without names (O_TMPFILE).
    [[nodiscard]] bool has_nameless_files() const {
        const int file = open((scratch_ / "folder").c_str(), O_TMPFILE | O_WRONLY, 0600);
        if (file >= 0) close(file);
        return file >= 0;
    }

    ScratchFolder scratch_;
    std::string whole_;
};

TEST_F(Interrupted, KilledWhileWritingTheOldFileStays) {
    EXPECT_EQ(write_under_strace({"fsync:signal=KILL"}).exit_code, 128 + 9);
    EXPECT_EQ(read_text(out()), kOldContent);
    EXPECT_EQ(files(), has_nameless_files() ? 1u : 2u) << "a draft was left";
}

TEST_F(Interrupted, KilledBeforeTheFirstFileIsThereNothingIsThere) {
    fs::remove(out());
    EXPECT_EQ(write_under_strace({"fsync:signal=KILL"}).exit_code, 128 + 9);
    EXPECT_FALSE(fs::exists(out()));
    EXPECT_EQ(files(), has_nameless_files() ? 0u : 1u) << "a draft was left";
}

// `weft` normally writes an unnamed temporary file and gives it a name with linkat. If this is impossible (no
// /proc, or no unnamed files), it writes a temporary file with a name. The injected error causes this case.
TEST_F(Interrupted, ADraftWithANameTakesThePlaceAsWell) {
    const RunResult run = write_under_strace({"linkat:error=ENOENT"});
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_EQ(read_text(out()), whole_);
    EXPECT_EQ(files(), 1u);
}

TEST_F(Interrupted, KilledOverADraftWithANameTheOldFileStays) {
    // The first fsync is that of the unnamed file, if such files exist. The next one is that of the file with
    // a name.
    const std::string second = has_nameless_files() ? ":when=2" : "";
    EXPECT_EQ(write_under_strace({"linkat:error=ENOENT", "fsync:signal=KILL" + second}).exit_code, 128 + 9);
    EXPECT_EQ(read_text(out()), kOldContent);
}

TEST_F(Interrupted, ASignalThatEndsTheProgramLeavesNoDraft) {
    const std::string second = has_nameless_files() ? ":when=2" : "";
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        scratch_.write("folder/out.json", kOldContent);
        const RunResult run =
            write_under_strace({"linkat:error=ENOENT", "fsync:signal=" + std::to_string(signal) + second});
        EXPECT_EQ(run.exit_code, 128 + signal) << run.text();
        EXPECT_EQ(read_text(out()), whole_) << "the file was about to be complete";
        EXPECT_EQ(files(), 1u);
    }
}

TEST_F(Interrupted, AnErrorOfTheDiskLeavesTheOldFileAndNoDraft) {
    for (const char* fault : {"fsync:error=EIO", "renameat:error=EIO"}) {
        const RunResult run = write_under_strace({fault});
        EXPECT_EQ(run.exit_code, 1) << run.text();
        EXPECT_NE(run.err.find("error[X510]"), std::string::npos) << run.text();
        EXPECT_EQ(read_text(out()), kOldContent);
        EXPECT_EQ(files(), 1u) << fault;
    }
}

// The program must call fsync before it renames the file. Otherwise a power failure could leave an empty file
// in place of the old one. After the renaming, it must call fsync for the folder.
TEST_F(Interrupted, TheDataIsOnTheDiskBeforeItTakesItsPlace) {
    ASSERT_EQ(write_under_strace({}).exit_code, 0);
    const std::string trace = read_text(scratch_ / "trace");
    const size_t sync = trace.find("fsync("), placed = trace.find("renameat");
    ASSERT_NE(sync, std::string::npos) << trace;
    ASSERT_NE(placed, std::string::npos) << trace;
    EXPECT_LT(sync, placed);
    EXPECT_NE(trace.find("fsync(", placed), std::string::npos) << "the folder is not on the disk";
}

}  // namespace
}  // namespace weft::test
