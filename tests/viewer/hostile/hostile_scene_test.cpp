// Tests scenes that refer to files outside their folder, give wrong sizes, or expand to far more data than
// their own size. tests/viewer/commands/bad_scene_test.cpp tests ordinary faults.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "tests/scene/gltf/hostile_scenes.h"
#include "tests/viewer/gltf_file.h"
#include "tests/viewer/hostile/hostile_run.h"
#include "tests/viewer/pictures/bit_png.h"

namespace weft::test {
namespace {

constexpr const char* kData = "\"uri\": \"data:application/octet-stream;base64,";

class HostileScene : public testing::Test {
 protected:
    HostileScene() {
        // The secret file is large enough for the scene's buffer of 60 bytes. So only a check of the path can
        // stop `weft` from reading it.
        scratch_.write("outside/secret.bin", std::string(64, 's'));
        scratch_.write("outside/secret.png", black_png(4, 4));
        scratch_.write("scene/a/keep", "");
        std::filesystem::create_symlink(scratch_ / "outside/secret.bin", scratch_.path() / "scene/link.bin");
        std::filesystem::create_directory_symlink(scratch_ / "outside", scratch_.path() / "scene/up");
    }

    static std::string with_buffer(const std::string& uri) {
        return replaced(square_gltf(), kData, "\"uri\": \"" + uri + "\", \"rest\": \"");
    }
    // Returns a scene whose material uses these images, at most three, as textures.
    static std::string with_images(const std::vector<std::string>& uris) {
        static constexpr std::array kSlots{"normalTexture", "occlusionTexture", "emissiveTexture"};
        std::string images, textures, slots;
        for (size_t i = 0; i < uris.size(); ++i) {
            const std::string n = std::to_string(i), comma = i == 0 ? "" : ", ";
            images += comma + "{ \"uri\": \"" + uris[i] + "\" }";
            textures += comma + "{ \"source\": " + n + " }";
            slots += std::string("\"") + kSlots.at(i) + "\": { \"index\": " + n + " }, ";
        }
        return replaced(
            square_gltf(), "\"materials\": [ { ",
            "\"images\": [" + images + "], \"textures\": [" + textures + "], \"materials\": [ { " + slots);
    }
    [[nodiscard]] std::vector<std::string> arguments() const {
        return {"render", scratch_ / "scene/scene.gltf", "--size", "16x16", "-o", scratch_ / "out.png"};
    }
    [[nodiscard]] RunResult render(const std::string& gltf) const {
        scratch_.write("scene/scene.gltf", gltf);
        return run_weft(arguments());
    }

    ScratchFolder scratch_;
};

TEST_F(HostileScene, NothingOutsideItsFolderIsOpened) {
    WatchedFolder outside(scratch_.path() / "outside");
    const std::string absolute = scratch_ / "outside/secret.bin";
    for (const std::string& uri :
         {std::string("../outside/secret.bin"), std::string("a/../../outside/secret.bin"),
          std::string("%2e%2e/outside/secret.bin"), std::string("..\\\\outside\\\\secret.bin"), absolute,
          "file://" + absolute, std::string("http://127.0.0.1/secret.bin"), std::string("link.bin"),
          std::string("up/secret.bin"), std::string("/etc/passwd"), std::string("/proc/self/environ")}) {
        const RunResult run = render(with_buffer(uri));
        expect_refused_cheaply(run, {"scene.gltf: error[S103]", "at /buffers/0/uri"});
        EXPECT_EQ(run.err.find("root:"), std::string::npos) << run.text();
        expect_refused_cheaply(render(with_images({uri})), {"error[S103]", "at /images/0/uri"});
    }
    EXPECT_FALSE(outside.was_opened());
    EXPECT_FALSE(read_text(scratch_ / "outside/secret.bin").empty());
    EXPECT_TRUE(outside.was_opened()) << "the watch sees nothing";
}

TEST_F(HostileScene, NothingOutsideItsFolderIsOpenedAsStraceSeesIt) {
    const std::filesystem::path outside = std::filesystem::canonical(scratch_.path() / "outside");
    for (const char* uri : {"link.bin", "../outside/secret.bin", "up/secret.bin"}) {
        scratch_.write("scene/scene.gltf", with_buffer(uri));
        const std::optional<TracedRun> traced = run_weft_traced(arguments(), scratch_.path());
        if (!traced)
            GTEST_SKIP() << "strace is missing or may not trace; the watched folder of the other test stands";
        expect_refused_cheaply(traced->run, {"error[S103]"});
        EXPECT_TRUE(std::ranges::any_of(traced->opened, [](const std::string& path) {
            return path.ends_with("scene.gltf");
        })) << "the trace sees nothing";
        for (const std::string& path : traced->opened)
            EXPECT_FALSE(path.starts_with(outside.string())) << path;
        EXPECT_EQ(traced->executed, std::vector<std::string>{WEFT_PROGRAM});
        EXPECT_FALSE(traced->used_network);
    }
}

TEST_F(HostileScene, CountsThatTheBytesDoNotHold) {
    for (const char* count : {"4000000000", "9007199254740992"})
        expect_refused_cheaply(
            render(replaced(square_gltf(), "\"count\": 4,", std::string("\"count\": ") + count + ",")),
            {"error[S104]", "at /accessors/0/count"});
    const auto sparse = [&](const std::string& count, const std::string& offset) {
        return render(replaced(
            square_gltf(), "\"count\": 4,",
            "\"count\": 4, \"sparse\": { \"count\": " + count +
                ", \"indices\": { \"bufferView\": 1, \"componentType\": 5123, \"byteOffset\": " + offset +
                " }, \"values\": { \"bufferView\": 0 } },"));
    };
    expect_refused_cheaply(sparse("4000000000", "0"), {"error[S108]", "at /accessors/0/sparse/count"});
    expect_refused_cheaply(sparse("4", "9007199254740990"), {"at /accessors/0/sparse/indices"});
    expect_refused_cheaply(sparse("4", "2147483646"), {"at /accessors/0/sparse/indices"});
    // An accessor without a buffer view consists of zeros, so a huge count costs no bytes in the file.
    expect_refused_cheaply(
        render(replaced(square_gltf(), "\"bufferView\": 0, \"componentType\": 5126, \"count\": 4",
                        "\"componentType\": 5126, \"count\": 4000000000")),
        {"error[S107]", "at /accessors/0/count"});
}

TEST_F(HostileScene, TreesThatAreNone) {
    std::string chain, ring;
    for (int i = 0; i < 100'000; ++i) {
        chain += ", { \"children\": [" + std::to_string(i + 3) + "] }";
        ring += ", { \"children\": [" + std::to_string(i == 99'999 ? 2 : i + 3) + "] }";
    }
    const auto nodes = [&](const std::string& more, const char* root) {
        std::string text = replaced(square_gltf(), "0.9876883] }", "0.9876883] }" + more);
        return render(replaced(text, "\"nodes\": [0, 1] }", std::string("\"nodes\": [0, 1") + root + "] }"));
    };
    expect_refused_cheaply(nodes(ring, ""), {"error[S109]", "at /nodes/"});
    expect_refused_cheaply(nodes(chain + ", { \"mesh\": 0 }", ", 2"), {"error[S109]", "at /nodes/", "512"});
}

TEST_F(HostileScene, DeepAndWideJson) {
    const auto with_extras = [](const std::string& extras) {
        return replaced(square_gltf(), "\"scene\": 0,", "\"scene\": 0, \"extras\": " + extras + ",");
    };
    expect_refused_cheaply(render(with_extras(std::string(200'000, '[') + std::string(200'000, ']'))),
                           {"scene.gltf:", "error[S107]", "nested deeper than 64"});
    std::string wide = "[0";
    for (int i = 0; i < 1'000'001; ++i) wide += ",0";
    expect_refused_cheaply(render(with_extras(wide + "]")), {"error[S107]", "more than 1000000 values"});
}

TEST_F(HostileScene, PicturesThatUnfold) {
    const std::string large = black_png(20'000, 20'000);
    EXPECT_LT(large.size(), 400u << 10) << "1.5 GiB once decoded to RGBA";
    scratch_.write("scene/large.png", large);
    const RunResult one = render(with_images({"large.png"}));
    expect_refused_cheaply(one, {"error[S106]", "at /images/0", "20000×20000"});
    EXPECT_LE(one.max_rss_bytes, uint64_t{128} << 20);
    // Each of the three pictures is below the limit, but together they exceed it.
    for (const char* name : {"a.png", "b.png", "c.png"})
        scratch_.write(std::string("scene/") + name, black_png(7'000, 7'000));
    const RunResult three = render(with_images({"a.png", "b.png", "c.png"}));
    expect_refused_cheaply(three, {"error[S106]", "scene.memoryBytes with --limits"});
    EXPECT_LE(three.max_rss_bytes, uint64_t{128} << 20);
}

// Each picture has one texel, but inflates to 500 MB. Several worker threads decode pictures at the same time
// and would need this memory together. So `weft` must refuse a picture with more data than its size needs.
TEST_F(HostileScene, APictureOfOneTexelWithHundredsOfMegabytesBehindIt) {
    std::vector<std::string> names;
    for (const char* name : {"a.png", "b.png", "c.png"}) {
        scratch_.write(std::string("scene/") + name, swollen_png(500'000'000));
        names.emplace_back(name);
    }
    const RunResult run = render(with_images(names));
    expect_refused_cheaply(run,
                           {"error[S112]", "at /images/0", "more data than a picture of its size can need"});
    EXPECT_LE(run.max_rss_bytes, uint64_t{128} << 20);
}

// A small JSON text describes millions of vertices: an accessor without a buffer view consists of zeros. The
// limit scene.vertices is 4,000,000.
TEST_F(HostileScene, VerticesThatNoBytesStandBehind) {
    const auto zeros = [&](const std::string& count) {
        return render(
            R"({"asset":{"version":"2.0"},"accessors":[{"componentType":5126,"count":)" + count +
            R"(,"type":"VEC3"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}]})");
    };
    expect_refused_cheaply(zeros("16000000"),
                           {"error[S107]", "at /accessors/0/count", "scene.vertices with --limits"});
    const RunResult run = zeros("3999999");
    if (run.exit_code == 4) GTEST_SKIP() << "no Vulkan device";
    EXPECT_LE(run.max_rss_bytes, uint64_t{1} << 30) << run.text();
    if (run.exit_code == 0) return;
    expect_refused_cheaply(run, {"error[S107]", "scene.memoryBytes with --limits"});
}

// The scene has as many nodes with a mesh as the limit scene.instances allows, all with the same mesh.
// Consecutive instances of a mesh become one draw command.
TEST_F(HostileScene, AQuarterOfAMillionNodesAreDrawn) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    std::string gltf =
        R"({"asset":{"version":"2.0"},"accessors":[{"componentType":5126,"count":3,"type":"VEC3"}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[)";
    for (int i = 0; i < 262'144; ++i) gltf += i > 0 ? R"(,{"mesh":0})" : R"({"mesh":0})";
    scratch_.write("scene/scene.gltf", gltf + "]}");
    std::vector<std::string> words = arguments();
    for (const char* word : {"--graph", WEFT_SOURCE_DIR "/docs/examples/ink.json"}) words.emplace_back(word);
    const RunResult run = run_weft(words);
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_LE(run.cpu_s, 5.0) << run.text();
    EXPECT_LE(run.max_rss_bytes, uint64_t{1} << 30) << run.text();
}

// The limit scene.memoryBytes counts the textures and their copies in GPU memory. A software driver keeps
// these copies in the memory of the process. All memory of the process must stay below 1 GiB.
TEST_F(HostileScene, TexturesWithinTheLimitsStayBelowAGigabyte) {
    if (!extended()) GTEST_SKIP() << "takes seconds: WEFT_EXTENDED=1 runs it";
    std::vector<std::string> names;
    for (const char* name : {"a.png", "b.png", "c.png"}) {
        scratch_.write(std::string("scene/") + name, black_png(5'000, 5'000));
        names.emplace_back(name);
    }
    const RunResult run = render(with_images(names));
    if (run.exit_code == 4) GTEST_SKIP() << "no Vulkan device";
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_LE(run.max_rss_bytes, uint64_t{1} << 30) << run.text();
    EXPECT_GE(run.max_rss_bytes, uint64_t{400} << 20) << "the textures were not loaded";
}

// Renders random hostile scenes. tests/scene loads such scenes in every run, without rendering. The message
// of a failure contains the seed of the scene.
TEST_F(HostileScene, RandomOnesAreDrawnOrRefused) {
    if (!extended()) GTEST_SKIP() << "takes minutes: WEFT_EXTENDED=1 runs it";
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    std::vector<std::string> words = arguments();
    for (const char* word : {"--graph", WEFT_SOURCE_DIR "/docs/examples/ink.json", "--timeout", "20"})
        words.emplace_back(word);
    for (uint32_t seed = 1; seed <= 220; ++seed) {
        scratch_.write("scene/scene.gltf", hostile_scene(seed));
        const RunResult run = run_weft(words);
        EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 3) << "seed " << seed << "\n" << run.text();
        EXPECT_LE(run.max_rss_bytes, uint64_t{1} << 30) << "seed " << seed;
    }
}

// Limits the address space to sizes that suffice for the program alone, but not for the scene. So memory runs
// out at various places, and the program must always end with error X571.
TEST_F(HostileScene, MemoryThatRunsOutIsAnErrorOfItsOwn) {
    std::string extras;
    for (int i = 0; i < 400'000; ++i) extras += std::string(i > 0 ? "," : "") + R"({"a":0})";
    scratch_.write("scene/scene.gltf", R"({"asset":{"version":"2.0"},"extras":[)" + extras + "]}");
    int located = 0;
    for (int limit_kib = 80'000; limit_kib <= 120'000; limit_kib += 2'500) {
        SCOPED_TRACE("ulimit -v " + std::to_string(limit_kib));
        std::vector<std::string> words{
            "sh", "-c", "ulimit -v " + std::to_string(limit_kib) + "; exec \"$0\" \"$@\"", WEFT_PROGRAM};
        for (const std::string& word : arguments()) words.push_back(word);
        const RunResult run = run_program(words);
        if (run.err.find("ERROR: AddressSanitizer") != std::string::npos || run.exit_code == 127)
            GTEST_SKIP() << "a sanitizer needs more address space";
        EXPECT_EQ(run.exit_code, 1) << run.text();
        EXPECT_NE(run.err.find("error[X571]: memory ran out"), std::string::npos) << run.text();
        EXPECT_NE(run.err.find("\n  help: "), std::string::npos) << run.text();
        located += run.err.find("memory ran out while the scene was loaded") != std::string::npos ? 1 : 0;
    }
    EXPECT_GT(located, 8);
}

TEST_F(HostileScene, DecodersAreQuotedInPrintableCharacters) {
    std::string bad = black_png(8, 8);
    bad.replace(bad.find("IDAT"), 4, "\x1b[\xffz");
    scratch_.write("scene/bad.png", bad);
    const RunResult run = render(with_images({"bad.png"}));
    expect_refused_cheaply(run, {"error[S112]", "at /images/0"});
    for (const char c : run.err)
        EXPECT_TRUE(c == '\n' || (c >= ' ' && c <= '~') || (c & 0x80) != 0) << static_cast<int>(c);
    EXPECT_EQ(run.err.find('\xff'), std::string::npos) << run.text();
}

TEST_F(HostileScene, PositionsThatAreNotNumbersAreLeftOutWithAWarning) {
    std::array<float, 12> positions{-1,
                                    0,
                                    -1,
                                    1,
                                    0,
                                    -1,
                                    1,
                                    0,
                                    1,
                                    std::numeric_limits<float>::quiet_NaN(),
                                    std::numeric_limits<float>::infinity(),
                                    1};
    const std::array<uint16_t, 6> indices{0, 1, 2, 0, 2, 3};
    std::string bytes(60, '\0');
    std::memcpy(bytes.data(), positions.data(), 48);
    std::memcpy(bytes.data() + 48, indices.data(), 12);
    scratch_.write("scene/square.bin", bytes);
    const RunResult run = render(with_buffer("square.bin"));
    EXPECT_NE(run.err.find("warning[S152]"), std::string::npos) << run.text();
    if (run.exit_code == 4) GTEST_SKIP() << "no Vulkan device";
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_LE(run.max_rss_bytes, uint64_t{1} << 30);
}

}  // namespace
}  // namespace weft::test
