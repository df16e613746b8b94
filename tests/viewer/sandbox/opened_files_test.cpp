// Tests which files `weft` opens, as observed with strace. `weft` may open files in the folders of the graph,
// the scene and the output, its own files, and files of the system. It must refuse a link that leads to
// another folder, and must not open the target of the link.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "tests/viewer/gltf_file.h"
#include "tests/viewer/hostile/hostile_run.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGraph = R"({ "version": 1, "name": "opens", "include": ["part.json"],
  "imports": { "backbuffer": "output" },
  "passes": { "show": { "type": "fullscreen", "shader": "show.frag", "in": ["x"], "out": ["backbuffer"] } }
})";
constexpr const char* kPart = R"({ "resources": { "x": "rgba8" },
  "passes": { "draw": { "type": "compute", "shader": "draw.comp", "out": ["x"] } }
})";
constexpr const char* kDraw = R"(#version 460
#include "value.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
writeonly uniform image2D x;
void main() { imageStore(x, ivec2(gl_GlobalInvocationID.xy), vec4(value)); }
)";
constexpr const char* kShow = R"(#version 460
uniform sampler2D x;
layout(location = 0) out vec4 backbuffer;
void main() { backbuffer = texelFetch(x, ivec2(gl_FragCoord.xy), 0); }
)";
constexpr const char* kValue = "const float value = 0.5;\n";

// Prefixes of system paths that `weft` may open: libraries, the Vulkan loader and drivers, devices, time
// zones and others.
constexpr std::array kSystem{"/usr/",       "/lib/",      "/lib64/",        "/etc/ld.so",
                             "/etc/vulkan", "/etc/drirc", "/etc/localtime", "/etc/ssl/",
                             "/proc/",      "/sys/",      "/dev/"};

class Opens : public testing::Test {
 protected:
    Opens() {
        scratch_.write("graph/graph.json", kGraph);
        scratch_.write("graph/part.json", kPart);
        scratch_.write("graph/draw.comp", kDraw);
        scratch_.write("graph/show.frag", kShow);
        scratch_.write("graph/value.glsl", kValue);
        scratch_.write("scene/scene.gltf", square_gltf());
        scratch_.write("out/keep", "");
        scratch_.write("elsewhere/keep", "");
        root_ = fs::canonical(scratch_.path());
    }
    [[nodiscard]] std::vector<std::string> check() const { return {"check", scratch_ / "graph/graph.json"}; }
    [[nodiscard]] std::vector<std::string> render() const {
        return {"render",  scratch_ / "scene/scene.gltf",
                "--graph", scratch_ / "graph/graph.json",
                "--size",  "16x16",
                "-o",      scratch_ / "out/a.png",
                "--stats", scratch_ / "out/a.json"};
    }
    // Returns the prefixes of the paths that `weft` may open in every run: shipped files, the folder of the
    // program, its cache, hidden files in the home folder, and kSystem.
    [[nodiscard]] static std::vector<std::string> of_the_tool() {
        const std::string source = WEFT_SOURCE_DIR;
        std::vector<std::string> all{source + "/graphs/",
                                     source + "/shaders/",
                                     source + "/framework/profiles/",
                                     source + "/docs/diagnostics.md",
                                     fs::path(WEFT_PROGRAM).parent_path().string() + "/",
                                     fs::weakly_canonical(WEFT_TEST_CACHE).string()};
        // Drivers read settings from hidden files and folders in the user's home folder, such as ~/.drirc.
        if (const char* home = std::getenv("HOME")) all.push_back(std::string(home) + "/.");
        all.insert(all.end(), kSystem.begin(), kSystem.end());
        return all;
    }
    void expect_only(const TracedRun& traced, const std::vector<std::string>& folders) const {
        std::vector<std::string> allowed = of_the_tool();
        for (const std::string& folder : folders) allowed.push_back((root_ / folder).string());
        for (const std::string& path : traced.opened)
            EXPECT_TRUE(std::ranges::any_of(
                allowed, [&](const std::string& start) { return (path + "/").starts_with(start); }))
                << path << " is none of its business";
        EXPECT_FALSE(traced.used_network);
        for (const std::string& program : traced.executed)
            EXPECT_EQ(fs::path(program).parent_path(), fs::path(WEFT_PROGRAM).parent_path()) << program;
    }
    // Moves a file to another folder and puts a link to it in the old place.
    void link_away(const std::string& name) const {
        fs::rename(root_ / name, root_ / "elsewhere" / fs::path(name).filename());
        fs::create_symlink(root_ / "elsewhere" / fs::path(name).filename(), root_ / name);
    }

    ScratchFolder scratch_;
    fs::path root_;
};

TEST_F(Opens, CheckReadsTheGraphsFolderAndItsOwnFiles) {
    const std::optional<TracedRun> traced = run_weft_traced(check(), scratch_.path());
    if (!traced) GTEST_SKIP() << "strace is missing or may not trace";
    EXPECT_EQ(traced->run.exit_code, 0) << traced->run.text();
    for (const char* read : {"graph.json", "part.json", "draw.comp", "show.frag", "value.glsl"})
        EXPECT_NE(std::ranges::find(traced->opened, (root_ / "graph" / read).string()), traced->opened.end())
            << "the trace does not see " << read;
    expect_only(*traced, {"graph"});
}

TEST_F(Opens, RenderReadsTheSceneToo) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const std::optional<TracedRun> traced = run_weft_traced(render(), scratch_.path());
    if (!traced) GTEST_SKIP() << "strace is missing or may not trace";
    EXPECT_EQ(traced->run.exit_code, 0) << traced->run.text();
    expect_only(*traced, {"graph", "scene", "out"});
}

struct Link {
    const char* name;
    // The file that the test moves away and replaces by a link.
    const char* file;
    // The error that `weft` must report.
    const char* error;
};

void PrintTo(const Link& link, std::ostream* out) {
    *out << link.name;
}

class OpensLink : public Opens, public testing::WithParamInterface<Link> {};

TEST_P(OpensLink, ThatLeadsElsewhereIsRefusedUnopened) {
    link_away(GetParam().file);
    const std::optional<TracedRun> traced = run_weft_traced(check(), scratch_.path());
    if (!traced) GTEST_SKIP() << "strace is missing or may not trace";
    EXPECT_EQ(traced->run.exit_code, 3) << traced->run.text();
    EXPECT_NE(traced->run.err.find(GetParam().error), std::string::npos) << traced->run.text();
    expect_only(*traced, {"graph"});
}

// Each of these files is replaced by a link that leads out of the graph's folder. The graph file itself is
// not in this list, because a file named on the command line may be a link.
INSTANTIATE_TEST_SUITE_P(All, OpensLink,
                         testing::Values(Link{"Shader", "graph/draw.comp", "error[W20"},
                                         Link{"ShaderInclude", "graph/value.glsl", "error[W203]"},
                                         Link{"Include", "graph/part.json", "error[W126]"}),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace weft::test
