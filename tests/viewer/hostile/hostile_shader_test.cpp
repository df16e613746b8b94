// Tests shaders that are too expensive to compile, or that include files outside the allowed folders.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/viewer/hostile/hostile_run.h"

namespace weft::test {
namespace {

constexpr const char* kGraph = R"({ "version": 1, "imports": { "backbuffer": "output" },
  "resources": { "x": "rgba8" },
  "passes": {
    "draw": { "type": "compute", "shader": "hostile.comp", "out": ["x"] },
    "show": { "type": "copy", "in": ["x"], "out": ["backbuffer"] }
  }
})";
constexpr const char* kHead = "#version 460\nlayout(local_size_x = 1) in;\nwriteonly uniform image2D x;\n";
constexpr const char* kStore = "imageStore(x, ivec2(0), vec4(1));";

class HostileShader : public testing::Test {
 protected:
    HostileShader() {
        scratch_.write("graph/graph.json", kGraph);
        scratch_.write("outside/secret.glsl", "the words that nobody may quote\n");
        std::filesystem::create_symlink(scratch_ / "outside/secret.glsl",
                                        scratch_.path() / "graph/link.glsl");
        std::filesystem::create_directory_symlink(scratch_ / "outside", scratch_.path() / "graph/up");
    }

    [[nodiscard]] std::vector<std::string> arguments() const {
        return {"check", scratch_ / "graph/graph.json"};
    }
    [[nodiscard]] RunResult check(const std::string& glsl) const {
        scratch_.write("graph/hostile.comp", glsl);
        return run_weft(arguments(), {{"XDG_CACHE_HOME", scratch_ / "cache"}});
    }
    static std::string including(const std::string& line) {
        return std::string(kHead) + "#include " + line + "\nvoid main() { " + kStore + " }\n";
    }
    // Returns a shader with the macros A0 to A30. A0 is `core`, and each other macro expands to two copies of
    // the previous one. So A30 expands to 2^30 copies of `core`.
    static std::string bomb(const std::string& core) {
        std::string text = kHead;
        text += "#define A0 " + core + "\n";
        for (int i = 1; i <= 30; ++i)
            text += "#define A" + std::to_string(i) + " A" + std::to_string(i - 1) + " A" +
                    std::to_string(i - 1) + "\n";
        return text + "void main() { float f = 1; A30 " + kStore + " }\n";
    }

    ScratchFolder scratch_;
};

TEST_F(HostileShader, AMacroBombIsStopped) {
    const std::string text = bomb("f+=f;");
    EXPECT_LT(text.size(), 800u);
    const RunResult run = check(text);
    expect_refused_cheaply(
        run, {"hostile.comp:1:1: error[W207]: compiling the compute stage needs more than", "shader."});
    EXPECT_EQ(run.err.find("error["), run.err.rfind("error[")) << "one cause, one message\n" << run.text();
}

TEST_F(HostileShader, AMacroThatIsNeverExpandedToTheEndIsStopped) {
    expect_refused_cheaply(check(bomb("")),
                           {"hostile.comp:1:1: error[W207]: compiling the compute stage needs more than"});
}

TEST_F(HostileShader, ACompilerThatCrashesIsAMessage) {
    std::string sum = "1.0 * f";
    for (int i = 0; i < 250'000; ++i) sum += "+f";
    expect_refused_cheaply(
        check(std::string(kHead) + "void main() { float f = 1; f = " + sum + "; " + kStore + " }\n"),
        {"hostile.comp:1:1: error[W207]: compiling the compute stage crashed the compiler"});
}

TEST_F(HostileShader, LimitsCanBeLowered) {
    scratch_.write("limits.json", R"({ "shader.workerBytes": 134217728, "shader.stageMs": 30000 })");
    scratch_.write("graph/hostile.comp", bomb("f+=f;"));
    std::vector<std::string> words = arguments();
    words.insert(words.end(), {"--limits", scratch_ / "limits.json"});
    const RunResult run = run_weft(words);
    expect_refused_cheaply(run, {"error[W207]", "needs more than 128 MiB of memory", "shader.workerBytes"});
    EXPECT_LE(run.max_rss_bytes, uint64_t{160} << 20) << run.text();
}

TEST_F(HostileShader, NothingOutsideTheShaderFoldersIsOpened) {
    WatchedFolder outside(scratch_.path() / "outside");
    const std::string absolute = scratch_ / "outside/secret.glsl";
    for (const std::string& name :
         {std::string("../outside/secret.glsl"), std::string("a/../../outside/secret.glsl"), absolute,
          std::string("link.glsl"), std::string("up/secret.glsl"), std::string("/etc/passwd"),
          std::string("../../../../../../../../etc/passwd"), std::string("/proc/self/environ"),
          std::string("/dev/zero")}) {
        for (const std::string& quoted : {"\"" + name + "\"", "<" + name + ">"}) {
            const RunResult run = check(including(quoted));
            expect_refused_cheaply(run, {"hostile.comp:4:", "error[W203]"});
            EXPECT_EQ(run.err.find("nobody may quote"), std::string::npos) << run.text();
            EXPECT_EQ(run.err.find("root:"), std::string::npos) << run.text();
        }
    }
    EXPECT_FALSE(outside.was_opened());
    EXPECT_FALSE(read_text(scratch_ / "outside/secret.glsl").empty());
    EXPECT_TRUE(outside.was_opened()) << "the watch sees nothing";
}

// Records the opened files with strace, and also shows that `weft` starts no program except its own worker.
TEST_F(HostileShader, NothingOutsideTheShaderFoldersIsOpenedAsStraceSeesIt) {
    scratch_.write("graph/good.glsl", "float good;\n");
    scratch_.write("graph/hostile.comp", including("\"good.glsl\"\n#include \"up/secret.glsl\""));
    const std::filesystem::path outside = std::filesystem::canonical(scratch_.path() / "outside");
    const std::optional<TracedRun> traced = run_weft_traced(arguments(), scratch_.path());
    if (!traced)
        GTEST_SKIP() << "strace is missing or may not trace; the watched folder of the other test stands";
    expect_refused_cheaply(traced->run, {"hostile.comp:5:", "error[W203]"});
    EXPECT_TRUE(std::ranges::any_of(traced->opened, [](const std::string& path) {
        return path.ends_with("good.glsl");
    })) << "the trace sees nothing";
    for (const std::string& path : traced->opened) {
        EXPECT_FALSE(path.starts_with(outside.string())) << path;
        EXPECT_NE(path, "/etc/passwd");
    }
    ASSERT_EQ(traced->executed.size(), 2u);
    EXPECT_TRUE(traced->executed[1].ends_with("/weft-shader-worker")) << traced->executed[1];
    EXPECT_FALSE(traced->used_network);
}

TEST_F(HostileShader, IncludesWithoutEnd) {
    scratch_.write("graph/round.glsl", "#include \"round.glsl\"\n");
    expect_refused_cheaply(check(including("\"round.glsl\"")),
                           {"round.glsl:1:", "error[W203]", "more than 32 levels deep"});
    scratch_.write("graph/two.glsl", "#include \"two.glsl\"\n#include \"two.glsl\"\n");
    expect_refused_cheaply(check(including("\"two.glsl\"")), {"two.glsl:1:", "error[W203]"});
    for (int i = 0; i < 40; ++i)
        scratch_.write("graph/d" + std::to_string(i) + ".glsl",
                       "#include \"d" + std::to_string(i + 1) + ".glsl\"\n");
    scratch_.write("graph/d40.glsl", "\n");
    expect_refused_cheaply(check(including("\"d0.glsl\"")),
                           {"d31.glsl:1:", "error[W203]", "more than 32 levels deep"});
    EXPECT_EQ(check(including("\"d9.glsl\"")).exit_code, 0) << "32 levels are fine";
}

TEST_F(HostileShader, MoreFilesThanAShaderMayHave) {
    std::string lines;
    for (int i = 0; i < 1001; ++i) {
        scratch_.write("graph/f" + std::to_string(i) + ".glsl", "\n");
        lines += "#include \"f" + std::to_string(i) + ".glsl\"\n";
    }
    expect_refused_cheaply(check(std::string(kHead) + lines + "void main() { " + kStore + " }\n"),
                           {"hostile.comp:10", "error[W203]", "1000"});
    scratch_.write("graph/large.glsl", std::string(3u << 20, ' '));
    expect_refused_cheaply(check(including("\"large.glsl\"")), {"error[W203]", "larger than 1 MiB"});
}

// The compiled SPIR-V in the cache is damaged here. `weft` must not trust the cache, because another program
// may write to it.
TEST_F(HostileShader, WhatIsInTheCacheIsNotBelieved) {
    ASSERT_EQ(check(including("\"good.glsl\"")).exit_code, 3);
    scratch_.write("graph/good.glsl", "\n");
    ASSERT_EQ(check(including("\"good.glsl\"")).exit_code, 0);
    size_t touched = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch_.path() / "cache")) {
        if (!entry.is_regular_file()) continue;
        std::string bytes = read_text(entry.path());
        bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
        scratch_.write(std::filesystem::relative(entry.path(), scratch_.path()).string(), bytes);
        ++touched;
    }
    EXPECT_GE(touched, 2u);
    EXPECT_EQ(check(including("\"good.glsl\"")).exit_code, 0) << "compiled again";
}

TEST_F(HostileShader, AnEndlessShaderIsATimeOut) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    scratch_.write("graph/hostile.comp", std::string(kHead) + R"(
void main() {
    float f = 1;
    for (uint i = 0; i < 4000000000u; ++i)
        for (uint j = 0; j < 4000000000u; ++j) f = sin(f * float(i ^ j));
    imageStore(x, ivec2(gl_GlobalInvocationID.xy), vec4(f));
}
)");
    const RunResult run = run_weft({"render", "builtin:spheres", "--size", "256x256", "--timeout", "0.5",
                                    "--graph", scratch_ / "graph/graph.json", "-o", scratch_ / "a.png"});
    EXPECT_EQ(run.exit_code, 7) << run.text();
    EXPECT_NE(run.err.find("error[V407]"), std::string::npos) << run.text();
    EXPECT_FALSE(std::filesystem::exists(scratch_ / "a.png"));
}

}  // namespace
}  // namespace weft::test
