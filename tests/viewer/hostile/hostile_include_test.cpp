// Tests includes that lead out of the graph's folder through links or "..", and includes of pipes, devices
// and folders. `weft` must not open a file outside the folder, and no message may quote its content.
// hostile_scene_test.cpp has similar tests for scenes, hostile_shader_test.cpp for shaders.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "tests/viewer/hostile/hostile_run.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSecret = "password-of-root";

class HostileInclude : public testing::Test {
 protected:
    HostileInclude() {
        scratch_.write("outside/secret.json", std::string(kSecret) + "\n{}");
        scratch_.write("outside/good.json", "{ \"consts\": { \"c\": 1 } }");
        scratch_.write("graphs/parts/good.json", "{ \"consts\": { \"c\": 1 } }");
        fs::create_symlink(scratch_ / "outside/secret.json", scratch_.path() / "graphs/link.json");
        fs::create_symlink("../outside/good.json", scratch_.path() / "graphs/climbing.json");
        fs::create_directory_symlink(scratch_ / "outside", scratch_.path() / "graphs/folder");
        fs::create_symlink("parts/good.json", scratch_.path() / "graphs/inside.json");
        fs::create_symlink("loop.json", scratch_.path() / "graphs/loop.json");
    }

    static std::string including(const std::string& name) {
        return "{ \"version\": 1, \"include\": [\"" + name + R"("],
  "imports": { "backbuffer": "output" },
  "passes": { "show": { "type": "clear", "out": ["backbuffer"] } } })";
    }
    [[nodiscard]] RunResult check(const std::string& name) const {
        scratch_.write("graphs/graph.json", including(name));
        return run_weft({"check", scratch_ / "graphs/graph.json"});
    }
    void expect_refused(const std::string& name, const std::string& message) const {
        WatchedFolder outside(scratch_.path() / "outside");
        const RunResult run = check(name);
        expect_refused_cheaply(run, {"graph.json:1:29: error[W126]", message});
        EXPECT_EQ(run.text().find(kSecret), std::string::npos) << run.text();
        EXPECT_FALSE(outside.was_opened()) << name;
    }

    ScratchFolder scratch_;
};

TEST_F(HostileInclude, LinksThatLeadOutAreRefused) {
    for (const char* name : {"link.json", "climbing.json", "folder/secret.json", "folder/good.json"})
        expect_refused(name, "is a symbolic link that leads out of the folder of the graph");
}

TEST_F(HostileInclude, PathsThatLeadOutAreRefused) {
    for (const std::string& name : {scratch_ / "outside/secret.json", std::string("../outside/secret.json"),
                                    std::string("parts/../../outside/secret.json"), std::string("/dev/zero")})
        expect_refused(name, "is not a path inside the folder of the graph");
}

TEST_F(HostileInclude, PipesDevicesAndFoldersAreNotRead) {
    ASSERT_EQ(mkfifo((scratch_ / "graphs/pipe.json").c_str(), 0600), 0);
    fs::create_symlink("/dev/zero", scratch_.path() / "graphs/zero.json");
    expect_refused("pipe.json", "does not exist or cannot be read");
    expect_refused("parts", "does not exist or cannot be read");
    expect_refused("loop.json", "does not exist or cannot be read");
    expect_refused("zero.json", "is a symbolic link that leads out of the folder of the graph");
}

TEST_F(HostileInclude, LinksInsideAndTheGraphItselfMayBeLinks) {
    EXPECT_EQ(check("inside.json").exit_code, 0);
    EXPECT_EQ(check("parts/good.json").exit_code, 0);
    // The user named the link on the command line, so `weft` searches for includes beside the link, not
    // beside its target.
    scratch_.write("elsewhere/graph.json", including("parts/good.json"));
    fs::create_symlink(scratch_ / "elsewhere/graph.json", scratch_.path() / "graphs/named.json");
    const RunResult named = run_weft({"check", scratch_ / "graphs/named.json"});
    EXPECT_EQ(named.exit_code, 0) << named.text();
    fs::create_directory_symlink(scratch_ / "graphs", scratch_.path() / "alias");
    scratch_.write("graphs/graph.json", including("parts/good.json"));
    const RunResult aliased = run_weft({"check", scratch_ / "alias/graph.json"});
    EXPECT_EQ(aliased.exit_code, 0) << aliased.text();
}

}  // namespace
}  // namespace weft::test
