// Tests that `weft` refuses faulty and hostile scenes with exit code 3, within 5 s of processor time and
// 1 GiB of memory. For a faulty value, the message must name the file, the JSON pointer and a remedy. No
// device is needed, because `weft` reads the scene before it opens a device.
#include <gtest/gtest.h>

#include <ostream>

#include "tests/viewer/gltf_file.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

struct BadScene {
    const char* name;
    // Text in a valid scene that the test replaces.
    const char* from;
    // Text that replaces `from`, so that the scene becomes faulty.
    const char* to;
    const char* code;
    // JSON pointer that the message must name, or the line and column if the JSON itself is invalid.
    const char* pointer;
    const char* help;
};

void PrintTo(const BadScene& bad, std::ostream* out) {
    *out << bad.name;
}

constexpr const char* kData = "\"uri\": \"data:application/octet-stream;base64,";

constexpr BadScene kBadScenes[] = {
    {"AParentFolder", kData, "\"uri\": \"../secret.bin\", \"rest\": \"", "S103", "/buffers/0/uri",
     "copy the file into the scene's folder"},
    {"AHiddenParentFolder", kData, "\"uri\": \"a/../../secret.bin\", \"rest\": \"", "S103", "/buffers/0/uri",
     "relative URI"},
    {"AnEncodedParentFolder", kData, "\"uri\": \"%2e%2e/secret.bin\", \"rest\": \"", "S103", "/buffers/0/uri",
     "relative URI"},
    {"AnAbsolutePath", kData, "\"uri\": \"/etc/passwd\", \"rest\": \"", "S103", "/buffers/0/uri",
     "relative URI"},
    {"AFileUri", kData, "\"uri\": \"file:///etc/passwd\", \"rest\": \"", "S103", "/buffers/0/uri",
     "relative URI"},
    {"ANetworkUri", kData, "\"uri\": \"https://example.com/a.bin\", \"rest\": \"", "S103", "/buffers/0/uri",
     "relative URI"},
    {"ALinkThatLeadsOut", kData, "\"uri\": \"link.bin\", \"rest\": \"", "S103", "/buffers/0/uri",
     "relative URI"},
    {"AMissingBuffer", kData, "\"uri\": \"none.bin\", \"rest\": \"", "S101", "/buffers/0/uri",
     "put the file beside the scene"},
    {"ACountPastTheBuffer", "\"count\": 4,", "\"count\": 4000000000,", "S104", "/accessors/0", ""},
    {"ACountOfTheIndices", "\"count\": 6,", "\"count\": 7,", "S104", "/accessors/1", ""},
    {"AViewPastTheBuffer", "\"byteOffset\": 48, \"byteLength\": 12", "\"byteOffset\": 48, \"byteLength\": 13",
     "S104", "/bufferViews/1", "shorten the view"},
    {"ABufferPastItsData", "\"byteLength\": 60", "\"byteLength\": 61", "S104", "/buffers/0/byteLength",
     "truncated"},
    {"AnIndexThatPointsAtNothing", "{ \"mesh\": 0 }", "{ \"mesh\": 7 }", "S110", "/nodes/0/mesh",
     "use an index"},
    {"ACycleOfNodes", "{ \"mesh\": 0 }", "{ \"mesh\": 0, \"children\": [0] }", "S109", "/nodes/0",
     "remove the child"},
    {"ARequiredExtension", "\"scene\": 0,",
     "\"scene\": 0, \"extensionsRequired\": [\"KHR_draco_mesh_compression\"],", "S105",
     "/extensionsRequired/0", "export without"},
    {"AValueOfTheWrongType", "\"type\": \"VEC3\"", "\"type\": 3", "S108", "/accessors/0/type", ""},
    {"AnOldVersion", "\"version\": \"2.0\"", "\"version\": \"1.0\"", "S113", "/asset/version",
     "export the scene as glTF 2.0"},
};

void expect_scene_refused(const RunResult& run, const std::vector<std::string>& wanted) {
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_LE(run.cpu_s, kMostInputCpu_s);
    EXPECT_LE(run.max_rss_bytes, kMostInputMemory_bytes);
    for (const std::string& part : wanted)
        EXPECT_NE(run.err.find(part), std::string::npos) << "wanted: " << part << "\n" << run.text();
}

RunResult render(const std::string& scene, const ScratchFolder& scratch) {
    return run_weft({"render", scene, "--size", "16x16", "-o", scratch / "out.png"});
}

class BadSceneTest : public testing::TestWithParam<BadScene> {};

TEST_P(BadSceneTest, IsRefusedByFileAndPointer) {
    const BadScene& bad = GetParam();
    const ScratchFolder scratch;
    // The secret file is large enough for the scene's buffer of 60 bytes. So only a check of the path can
    // stop `weft` from reading the file.
    scratch.write("secret.bin", std::string(64, 's'));
    scratch.write("scene/a/keep", "");
    scratch.write("scene/scene.gltf", replaced(square_gltf(), bad.from, bad.to));
    std::filesystem::create_symlink(scratch / "secret.bin", scratch.path() / "scene" / "link.bin");
    const RunResult run = render(scratch / "scene/scene.gltf", scratch);
    expect_scene_refused(run, {std::string("scene.gltf: error[") + bad.code + "]: ",
                               std::string("\n  at ") + bad.pointer, "\n  help: ", bad.help});
    EXPECT_FALSE(std::filesystem::exists(scratch / "out.png"));
}

INSTANTIATE_TEST_SUITE_P(All, BadSceneTest, testing::ValuesIn(kBadScenes),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(BadScene, AMissingFileIsNamed) {
    const ScratchFolder scratch;
    expect_scene_refused(render(scratch / "none.gltf", scratch),
                         {"none.gltf: error[S101]", "help: check the path"});
}

TEST(BadScene, ATruncatedFileIsRefusedWhereItEnds) {
    const ScratchFolder scratch;
    const std::string good = square_gltf();
    scratch.write("cut.gltf", good.substr(0, good.find("\"meshes\"")));
    scratch.write("cut.glb", std::string("glTF\2\0\0\0\xff\0\0\0\x10\0\0\0JSON", 20));
    scratch.write("empty.gltf", "");
    expect_scene_refused(render(scratch / "cut.gltf", scratch), {"cut.gltf:10:", "error[S102]", "truncated"});
    expect_scene_refused(render(scratch / "cut.glb", scratch), {"cut.glb", "error[S102]", "help: "});
    expect_scene_refused(render(scratch / "empty.gltf", scratch), {"empty.gltf", "error[S102]", "help: "});
}

TEST(BadScene, DeepNestingIsRefusedQuickly) {
    const ScratchFolder scratch;
    scratch.write("deep.gltf", "{ \"asset\": " + std::string(200'000, '[') + "}");
    expect_scene_refused(render(scratch / "deep.gltf", scratch), {"deep.gltf", "error[S1", "help: "});
}

TEST(BadScene, AnEnvironmentIsJudgedByItsHeader) {
    const ScratchFolder scratch;
    const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
    scratch.write("huge.hdr", header + "-Y 16384 +X 16384\n");
    // The file ends inside a run-length-coded row. A decoder that does not check for the end of the file
    // would never return.
    scratch.write("cut.hdr", header + "-Y 512 +X 1024\n" + std::string("\2\2\4\0\377", 5));
    scratch.write("text.hdr", "no picture");
    const auto with = [&](const std::string& env) {
        return run_weft(
            {"render", "builtin:spheres", "--size", "16x16", "--env", env, "-o", scratch / "a.png"});
    };
    expect_scene_refused(with(scratch / "huge.hdr"), {"huge.hdr: error[S181]", "16384x16384", "help: "});
    expect_scene_refused(with(scratch / "cut.hdr"), {"cut.hdr: error[S180]", "in row 1 of 512", "help: "});
    expect_scene_refused(with(scratch / "text.hdr"), {"text.hdr: error[S180]", "#?RADIANCE", "help: "});
    expect_scene_refused(with(scratch / "none.hdr"), {"none.hdr: error[S180]", "help: "});
}

TEST(BadScene, UnknownNamesAreGuessed) {
    const ScratchFolder scratch;
    expect_scene_refused(render("builtin:atrum", scratch), {"error[S120]", "did you mean \"atrium\"?"});
    const RunResult run = run_weft(
        {"render", "builtin:spheres", "--size", "16x16", "--camera", "nowhere", "-o", scratch / "a.png"});
    expect_scene_refused(run, {"error[S130]", "no camera \"nowhere\"", "help: "});
}

}  // namespace
}  // namespace weft::test
