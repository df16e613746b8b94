// Tests that every file written by `weft` is either complete or absent, and that an old file stays until the
// new one is complete. Tests each kind of file with each cause of failure. If a test would render a frame, it
// runs only with WEFT_EXTENDED, except for kinds marked as quick.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <ostream>

#include "tests/viewer/output/full_disk.h"
#include "tests/viewer/pictures/picture_files.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;
constexpr const char* kGraph = WEFT_SOURCE_DIR "/docs/examples/ink.json";
constexpr const char* kTinyGraph = WEFT_SOURCE_DIR "/tests/render/reload/live.json";
constexpr const char* kOld = "the old file";

struct Writer {
    const char* name;
    const char* extension;
    // Arguments of `weft`. The word "OUT" is replaced by the path of the file.
    std::vector<std::string> arguments;
    bool needs_device = false;
    // True if the kind is also tested without WEFT_EXTENDED, although it needs a device.
    bool quick = false;
    // Expected end of the file, for a file whose content differs in each run; otherwise null.
    const char* end = nullptr;
};

void PrintTo(const Writer& writer, std::ostream* out) {
    *out << writer.name;
}

std::vector<std::string> tiny_render(std::vector<std::string> more) {
    std::vector<std::string> all{"render", "builtin:spheres", "--graph", kTinyGraph, "--size", "16x16"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

const std::vector<Writer>& writers() {
    static const std::vector<Writer> all{
        {"Schema", ".json", {"schema", "-o", "OUT"}},
        {"PlanPage", ".html", {"plan", kGraph, "--format", "html", "-o", "OUT"}},
        {"HeatMap", ".png", {"compare", "a.png", "b.png", "-o", "OUT"}},
        {"Probes", ".png", {"scene", "builtin:cornell", "-o", "OUT"}},
        {"Png", ".png", tiny_render({"-o", "OUT"}), true},
        {"Exr", ".exr", tiny_render({"-o", "OUT"}), true, true},
        {"Pfm", ".pfm", tiny_render({"--resource", "paint", "-o", "OUT"}), true},
        {"Stats", ".json", tiny_render({"-o", "/dev/null", "--stats", "OUT"}), true, false, "\n}\n"},
        {"Plot",
         ".svg",
         {"bench", "frame", "builtin:spheres", "--graphs", "forward,deferred", "--lights", "1", "--size",
          "16x16", "--rounds", "1", "--plot", "OUT"},
         true,
         false,
         "</svg>\n"},
    };
    return all;
}

class Written : public testing::TestWithParam<Writer> {
 protected:
    void SetUp() override {
        for (const char* name : {"a.png", "b.png"})
            scratch_.write(name, png_file(2, 1, std::vector<Texel>{{0, 0, 4}, {1, 1, float(name[0] - 'a')}}));
    }
    [[nodiscard]] std::string out() const { return scratch_ / (std::string("out") + GetParam().extension); }
    [[nodiscard]] std::string command(const std::string& file) const {
        std::vector<std::string> words = GetParam().arguments;
        for (std::string& word : words) {
            if (word == "OUT") word = file;
            if (word == "a.png" || word == "b.png") word = scratch_ / word;
        }
        return weft_in_shell(words);
    }
    [[nodiscard]] static RunResult shell(const std::string& script) {
        return run_program({"sh", "-c", script});
    }
    [[nodiscard]] bool needs_extended_run() const {
        if (!GetParam().needs_device) return false;
        return (!GetParam().quick && !extended()) || !has_device();
    }
    [[nodiscard]] bool is_whole(const std::string& file) const {
        const std::string found = read_text(file);
        if (GetParam().end != nullptr) return found.ends_with(GetParam().end);
        const std::string fresh = scratch_ / (std::string("fresh") + GetParam().extension);
        EXPECT_EQ(shell(command(fresh)).exit_code, 0);
        return !found.empty() && found == read_text(fresh);
    }
    // Expects that the command left no temporary file, whose name would begin with ".weft-".
    void expect_no_drafts() const {
        for (const auto& entry : fs::directory_iterator(scratch_.path()))
            EXPECT_FALSE(entry.path().filename().string().starts_with(".weft-")) << entry.path();
    }
    static void expect_refused(const RunResult& run) {
        EXPECT_EQ(run.exit_code, 1) << run.text();
        EXPECT_NE(run.err.find("error[X510]: the file cannot be written"), std::string::npos) << run.text();
        EXPECT_EQ(run.err.find("weft: wrote"), std::string::npos) << run.text();
    }

    ScratchFolder scratch_;
};

TEST_P(Written, OntoAFullDevice) {
    if (needs_extended_run()) GTEST_SKIP() << "only with WEFT_EXTENDED and a Vulkan device";
    fs::create_symlink("/dev/full", out());
    const RunResult run = shell(command(out()));
    expect_refused(run);
    EXPECT_NE(run.err.find("No space left"), std::string::npos) << run.text();
    EXPECT_TRUE(fs::is_symlink(out())) << "the link was replaced";
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_P(Written, OntoAFullDiskTheOldFileStays) {
    if (needs_extended_run()) GTEST_SKIP() << "only with WEFT_EXTENDED and a Vulkan device";
    if (!can_mount()) GTEST_SKIP() << "this user may not mount a file system";
    const std::string file = std::string("$DISK/out") + GetParam().extension;
    // The file name contains $DISK, which the shell must expand. So the name is quoted with " instead of '.
    std::string write = command("OUT_ON_DISK");
    const size_t at = write.find("'OUT_ON_DISK'");
    ASSERT_NE(at, std::string::npos);
    write.replace(at, std::string("'OUT_ON_DISK'").size(), "\"" + file + "\"");
    const RunResult run =
        run_on_small_disk("64k", std::string("printf '") + kOld + "' >\"" + file + "\"\nfill_disk\n" + write +
                                     "\ncode=$?\ncat \"" + file + "\"; ls -A \"$DISK\"\nexit $code");
    expect_refused(run);
    const std::string left = std::string(kOld) + "fill\nout" + GetParam().extension + "\n";
    EXPECT_TRUE(run.out.ends_with(left)) << run.text();
}

TEST_P(Written, WithoutRights) {
    scratch_.write(fs::path(out()).filename(), kOld);
    const std::string folder = scratch_.path().string();
    const RunResult read_only_file = run_without_privileges("chmod 444 " + out() + "; " + command(out()));
    expect_refused(read_only_file);
    EXPECT_NE(read_only_file.err.find("Permission denied"), std::string::npos) << read_only_file.text();
    expect_refused(run_without_privileges("chmod 644 " + out() + "; chmod 555 " + folder + "; " +
                                          command(out()) + "; code=$?; chmod 755 " + folder +
                                          "; exit $code"));
    EXPECT_EQ(read_text(out()), kOld);
}

TEST_P(Written, WhereAFolderIs) {
    fs::create_directory(out());
    const RunResult run = shell(command(out()));
    expect_refused(run);
    EXPECT_NE(run.err.find("name a file in this folder"), std::string::npos) << run.text();
    EXPECT_TRUE(fs::is_empty(out()));
}

TEST_P(Written, WhereTheFolderIsMissing) {
    const RunResult run = shell(command(scratch_ / (std::string("no/folder/x") + GetParam().extension)));
    expect_refused(run);
    EXPECT_NE(run.err.find("mkdir -p"), std::string::npos) << run.text();
}

TEST_P(Written, ThroughALinkTheTargetIsReplaced) {
    if (needs_extended_run()) GTEST_SKIP() << "only with WEFT_EXTENDED and a Vulkan device";
    const std::string target = scratch_ / "target";
    scratch_.write("target", kOld);
    ASSERT_EQ(chmod(target.c_str(), 0640), 0);
    fs::create_symlink("target", out());
    const RunResult run = shell(command(out()));
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_TRUE(fs::is_symlink(out()));
    EXPECT_FALSE(fs::is_symlink(target));
    EXPECT_TRUE(is_whole(target));
    EXPECT_EQ(fs::status(target).permissions(), fs::perms(0640)) << "the old file's permissions stay";
    expect_no_drafts();
}

TEST_P(Written, ThroughADanglingLinkTheTargetIsMade) {
    if (needs_extended_run()) GTEST_SKIP() << "only with WEFT_EXTENDED and a Vulkan device";
    fs::create_symlink("target", out());
    const RunResult run = shell("umask 027; " + command(out()));
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_TRUE(fs::is_symlink(out()));
    EXPECT_TRUE(is_whole(scratch_ / "target"));
    EXPECT_EQ(fs::status(scratch_ / "target").permissions(), fs::perms(0640));
    fs::remove(out());
    fs::create_symlink("no/folder/target", out());
    expect_refused(shell(command(out())));
}

TEST_P(Written, IntoAPipe) {
    if (needs_extended_run()) GTEST_SKIP() << "only with WEFT_EXTENDED and a Vulkan device";
    const std::string got = scratch_ / "got";
    const RunResult run = shell("mkfifo " + out() + "; cat " + out() + " >" + got + " & " + command(out()) +
                                "; code=$?; wait; exit $code");
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_TRUE(fs::is_fifo(out()));
    EXPECT_TRUE(is_whole(got));
}

// Kills the program after it has written the data, when it calls fsync. write_signals_test.cpp has further
// cases.
TEST_P(Written, KilledWhileItWritesTheOldFileStays) {
    if (needs_extended_run()) GTEST_SKIP() << "only with WEFT_EXTENDED and a Vulkan device";
    scratch_.write(fs::path(out()).filename(), kOld);
    const std::string strace =
        "strace -f -qq -o " + (scratch_ / "trace") + " -e trace=fsync -e inject=fsync:";
    if (shell(strace + "error=EIO true").exit_code != 0) GTEST_SKIP() << "strace is missing or may not trace";
    // If the program is killed, strace kills itself with the same signal. So the shell reports 128 + 9, where
    // 9 is SIGKILL.
    const RunResult run = shell(strace + "signal=KILL " + command(out()));
    EXPECT_EQ(run.exit_code, 128 + 9) << run.text();
    EXPECT_EQ(read_text(out()), kOld);
}

INSTANTIATE_TEST_SUITE_P(All, Written, testing::ValuesIn(writers()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(WrittenFirst, WhatCanBeKnownIsSaidBeforeAnythingIsRead) {
    const RunResult run = run_weft({"render", "builtin:none", "--graph", "none.json", "-o", "no/folder/a.png",
                                    "--stats", "no/folder/b.json"});
    EXPECT_EQ(run.exit_code, 1) << run.text();
    EXPECT_NE(run.err.find("no/folder/a.png: error[X510]"), std::string::npos) << run.text();
    EXPECT_NE(run.err.find("no/folder/b.json: error[X510]"), std::string::npos) << run.text();
    EXPECT_EQ(run.err.find("none.json:"), std::string::npos) << run.text();
}

// No output file may replace an input file or another output file of the same command. The program must
// refuse such names before it writes anything.
TEST(WrittenFirst, NoFileIsWrittenOverAnInputOrAnotherOutput) {
    const ScratchFolder scratch;
    const std::string graph =
        R"({ "version": 1, "imports": { "backbuffer": "output" },
             "passes": { "end": { "type": "clear", "out": ["backbuffer"] } } })";
    scratch.write("g.json", graph);
    scratch.write("a.png", kOld);
    fs::create_symlink("g.json", scratch / "link.json");
    const std::vector<std::vector<std::string>> commands{
        {"plan", scratch / "g.json", "-o", scratch / "g.json"},
        {"plan", scratch / "g.json", "-o", scratch / "g.json", "--sandbox"},
        {"plan", scratch / "g.json", "-o", scratch / "link.json"},
        {"schema", scratch / "g.json", "-o", scratch / "./g.json"},
        {"compare", scratch / "b.png", scratch / "a.png", "-o", scratch / "a.png"},
        tiny_render({"-o", scratch / "new.png", "--stats", scratch / "new.png"}),
        tiny_render({"-o", scratch / "new.png", "--stats", scratch / "new.png", "--sandbox"}),
        {"render", "--graph", scratch / "g.json", "-o", scratch / "new.png", "--stats", scratch / "g.json"}};
    for (const std::vector<std::string>& command : commands) {
        const RunResult run = run_weft(command);
        EXPECT_EQ(run.exit_code, 1) << run.text();
        EXPECT_NE(run.err.find("error[X510]: the file cannot be written: it is also an"), std::string::npos)
            << run.text();
    }
    EXPECT_EQ(read_text(scratch / "g.json"), graph);
    EXPECT_EQ(read_text(scratch / "a.png"), kOld);
    EXPECT_FALSE(fs::exists(scratch / "new.png"));
    const RunResult shared = run_weft({"plan", kGraph, "-o", "/dev/null"});
    EXPECT_EQ(shared.exit_code, 0) << shared.text();
}

// A check after rendering would take hours here, because the command asks for a million frames.
TEST(WrittenFirst, AnUnknownExtensionIsRefusedBeforeAFrameIsRendered) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder scratch;
    std::vector<std::string> arguments =
        tiny_render({"--frames", "1000000", "--resource", "paint", "-o", scratch / "a.gif"});
    const RunResult run = run_weft(arguments);
    EXPECT_EQ(run.exit_code, 2) << run.text();
    EXPECT_NE(run.err.find("error[X511]"), std::string::npos) << run.text();
}

TEST(WrittenFirst, ADescriptorIsWrittenWhereItStands) {
    const ScratchFolder scratch;
    const std::string schema = weft_in_shell({"schema"});
    const RunResult whole = run_weft({"schema"});
    for (const char* name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
        const RunResult run =
            run_program({"sh", "-c", "echo before; " + schema + " -o " + name + "; echo after"});
        EXPECT_EQ(run.out, "before\n" + whole.out + "after\n") << name;
    }
    const RunResult read_only = run_program({"sh", "-c", schema + " -o /dev/fd/0"});
    EXPECT_EQ(read_only.exit_code, 1) << read_only.text();
}

}  // namespace
}  // namespace weft::test
