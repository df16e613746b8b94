// Tests --sandbox: a command renders the same picture inside the sandbox as outside. Inside, it can access
// only what it needs for its work. If the kernel does not support the sandbox, the command must not run.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/landlock.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;

bool has_landlock() {
    return syscall(SYS_landlock_create_ruleset, nullptr, size_t{0}, LANDLOCK_CREATE_RULESET_VERSION) > 0;
}

class Sandbox : public testing::Test {
 protected:
    void SetUp() override {
        if (!has_landlock()) GTEST_SKIP() << "the kernel has no Landlock";
        scratch_.write("out/keep.txt", "as it was");
        scratch_.write("elsewhere/secret.txt", "secret");
        scratch_.write("elsewhere/victim.txt", "content");
        scratch_.write("driver.json",
                       std::string(R"({ "file_format_version": "1.0.0", "ICD": { "library_path": ")") +
                           WEFT_HOSTILE_DRIVER + R"(", "api_version": "1.3.0" } })");
    }

    [[nodiscard]] std::vector<std::string> render(const std::string& output, bool sandbox) const {
        std::vector<std::string> words{"render", "builtin:spheres", "--size", "64x36", "-o", output};
        if (sandbox) words.emplace_back("--sandbox");
        return words;
    }
    // Runs `weft` with a driver that attacks when it is loaded. `weft` also inherits an open file, to which
    // the driver tries to write.
    [[nodiscard]] RunResult attack(bool sandbox, const Environment& more = {}) const {
        const int left_open =
            open((scratch_ / "elsewhere/open.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        Environment environment{{"VK_DRIVER_FILES", scratch_ / "driver.json"},
                                {"VK_ICD_FILENAMES", scratch_ / "driver.json"},
                                {"WEFT_HOSTILE_FOLDER", scratch_ / "elsewhere"},
                                {"WEFT_HOSTILE_DESCRIPTOR", std::to_string(left_open)}};
        environment.insert(environment.end(), more.begin(), more.end());
        RunResult run = run_weft(render(scratch_ / "out/frame.png", sandbox), environment);
        close(left_open);
        return run;
    }
    void expect_only(const std::vector<std::string>& names) const {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(scratch_ / "out"))
            found.push_back(entry.path().filename().string());
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, names);
    }

    ScratchFolder scratch_;
};

constexpr const char* kAttacks[] = {
    "reads a file",          "reads /etc/passwd",          "lists the folder",
    "makes a file",          "truncates a file",           "removes a file",
    "changes rights",        "makes a network socket",     "makes a local socket",
    "makes a datagram pair", "owns signals of its parent", "writes to a file left open"};

// Without the sandbox each attack must succeed. This proves that the tests with the sandbox can detect a
// successful attack.
TEST_F(Sandbox, CodeOutsideReachesEverything) {
    const RunResult run = attack(false);
    for (const char* what : kAttacks)
        EXPECT_NE(run.err.find(std::string("hostile: ") + what + " done"), std::string::npos) << what << "\n"
                                                                                              << run.text();
    EXPECT_FALSE(fs::exists(scratch_ / "elsewhere/victim.txt"));
}

TEST_F(Sandbox, CodeInsideReachesNothing) {
    const RunResult run = attack(true);
    for (const char* what : kAttacks)
        EXPECT_NE(run.err.find(std::string("hostile: ") + what + " refused"), std::string::npos)
            << what << "\n"
            << run.text();
    for (const char* what : {"signals its parent", "traces its parent"})
        EXPECT_NE(run.err.find(std::string("hostile: ") + what + " refused"), std::string::npos)
            << run.text();
    EXPECT_NE(run.err.find("makes memory that runs done"), std::string::npos) << "drivers compile\n"
                                                                              << run.text();
    EXPECT_EQ(read_text(scratch_ / "elsewhere/victim.txt"), "content");
    EXPECT_EQ(read_text(scratch_ / "elsewhere/secret.txt"), "secret");
    EXPECT_FALSE(fs::exists(scratch_ / "elsewhere/new.txt"));
    expect_only({"keep.txt"});
}

// The folder of the output file contains other files, which the driver must not reach.
TEST_F(Sandbox, CodeInsideReachesNoFileBesideTheOutput) {
    const RunResult run = attack(true, {{"WEFT_HOSTILE_FOLDER", scratch_ / "out"}});
    EXPECT_NE(run.err.find("hostile: makes a file refused"), std::string::npos) << run.text();
    EXPECT_NE(run.err.find("hostile: lists the folder refused"), std::string::npos) << run.text();
    expect_only({"keep.txt"});
}

TEST_F(Sandbox, NoProcessOutlivesIt) {
    const RunResult run = attack(true, {{"WEFT_HOSTILE_CHILD", "1"}});
    const std::string words = "hostile: left ";
    const size_t at = run.err.find(words);
    ASSERT_NE(at, std::string::npos) << run.text();
    const pid_t left = std::stoi(run.err.substr(at + words.size()));
    ASSERT_GT(left, 1) << run.text();
    EXPECT_NE(kill(left, 0), 0) << left << " still runs";
    kill(left, SIGKILL);
}

// The output is /dev/fd/N, as in a process substitution of the shell.
TEST_F(Sandbox, AnOutputMayBeAnOpenDescriptor) {
    const int file = open((scratch_ / "elsewhere/plan.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const RunResult plan = run_weft({"plan", WEFT_SOURCE_DIR "/graphs/deferred.json", "--sandbox", "-o",
                                     "/dev/fd/" + std::to_string(file)});
    close(file);
    EXPECT_EQ(plan.exit_code, 0) << plan.text();
    EXPECT_NE(read_text(scratch_ / "elsewhere/plan.txt").find("plan of deferred"), std::string::npos);
}

TEST_F(Sandbox, ACrashInsideIsAMessageAndLeavesNothing) {
    const RunResult run = attack(true, {{"WEFT_HOSTILE_CRASH", "1"}});
    EXPECT_EQ(run.exit_code, 1) << run.text();
    EXPECT_NE(run.err.find("error[X596]"), std::string::npos) << run.text();
    expect_only({"keep.txt"});
}

TEST_F(Sandbox, ThePictureIsTheSame) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const RunResult outside = run_weft(render(scratch_ / "outside.png", false));
    ASSERT_EQ(outside.exit_code, 0) << outside.text();
    scratch_.write("out/frame.png", "an old picture");
    const RunResult inside = run_weft(render(scratch_ / "out/frame.png", true));
    ASSERT_EQ(inside.exit_code, 0) << inside.text();
    EXPECT_EQ(read_text(scratch_ / "out/frame.png"), read_text(scratch_ / "outside.png"));
    EXPECT_NE(inside.err.find("weft: wrote " + (scratch_ / "out/frame.png")), std::string::npos)
        << inside.text();
    expect_only({"frame.png", "keep.txt"});
}

constexpr const char* kSandboxGraph = R"({ "version": 1, "imports": { "backbuffer": "output" },
  "resources": { "x": "rgba8" },
  "passes": {
    "draw": { "type": "compute", "shader": "own.comp", "out": ["x"] },
    "show": { "type": "copy", "in": ["x"], "out": ["backbuffer"] }
  },
  "tests": [{ "size": [32, 32], "expect": { "finite": ["x"] } }]
})";

// The shader file is in the folder of the graph. A worker process of `weft` compiles the shader, in the same
// sandbox as `weft`.
TEST_F(Sandbox, AGraphBesideItsShadersIsCheckedAndRun) {
    scratch_.write("graph/graph.json", kSandboxGraph);
    scratch_.write("graph/own.comp",
                   "#version 460\nlayout(local_size_x = 8) in;\nwriteonly uniform image2D x;\n"
                   "void main() { imageStore(x, ivec2(gl_GlobalInvocationID.xy), vec4(1)); }\n");
    const RunResult checked = run_weft({"check", scratch_ / "graph/graph.json", "--sandbox"},
                                       {{"XDG_CACHE_HOME", scratch_ / "cache"}});
    EXPECT_EQ(checked.exit_code, 0) << checked.text();
    EXPECT_FALSE(fs::exists(scratch_ / "cache/weft")) << "caches are only read";
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const RunResult run = run_weft({"check", "--run", scratch_ / "graph/graph.json", "--sandbox"},
                                   {{"XDG_CACHE_HOME", scratch_ / "cache"}});
    EXPECT_EQ(run.exit_code, 0) << run.text();
}

TEST_F(Sandbox, FaultsKeepTheirExitCodes) {
    scratch_.write("graph/graph.json", "{ \"version\": 1, \"pases\": {} }");
    const RunResult run = run_weft({"check", scratch_ / "graph/graph.json", "--sandbox"});
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_NE(run.err.find("error[W101]"), std::string::npos) << run.text();
    const RunResult plan = run_weft(
        {"plan", WEFT_SOURCE_DIR "/graphs/deferred.json", "--sandbox", "-o", scratch_ / "out/plan.txt"});
    EXPECT_EQ(plan.exit_code, 0) << plan.text();
    expect_only({"keep.txt", "plan.txt"});
}

// If the sandbox is not available, `weft` must refuse the command instead of running it without protection.
TEST_F(Sandbox, WithoutLandlockNothingRuns) {
    std::vector<std::string> words{WEFT_WITHOUT_LANDLOCK, WEFT_PROGRAM};
    for (const std::string& word : render(scratch_ / "out/frame.png", true)) words.push_back(word);
    const RunResult run = run_program(words);
    EXPECT_EQ(run.exit_code, 1) << run.text();
    EXPECT_NE(run.err.find("error[X595]: the sandbox is not available, so the command was not run"),
              std::string::npos)
        << run.text();
    expect_only({"keep.txt"});
}

}  // namespace
}  // namespace weft::test
