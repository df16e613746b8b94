// Purpose: tests every limit on scenes. An expensive scene that just meets the limit must load within 5 s of
// CPU time and within the allowed memory. A scene that exceeds the limit by 1 (for example by one node) must
// be refused. The error must name the place in the file and the limit. Every limit must have a test case.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>

#include "tests/scene/gltf/gltf_fixture.h"
#include "tests/scene/measured_child.h"
#include "tests/viewer/pictures/bit_png.h"

namespace weft::scene::test {
namespace {

namespace fs = std::filesystem;
using weft::test::Cost;
using weft::test::cost_of;

constexpr double kMostCpu_s = 5;
// Memory in addition to the scene: code, stacks, and the overhead of the allocator.
constexpr uint64_t kAllowance_bytes = 96 << 20;

bool is_extended() {
    const char* value = std::getenv("WEFT_EXTENDED");
    return value != nullptr && *value != '\0' && std::string(value) != "0";
}

std::string repeated(const std::string& item, uint64_t count) {
    std::string text;
    text.reserve((item.size() + 1) * count);
    for (uint64_t i = 0; i < count; ++i) {
        if (i > 0) text += ',';
        text += item;
    }
    return text;
}

std::string with_members(const std::string& members) {
    return R"({"asset":{"version":"2.0"},)" + members + "}";
}

// Returns a glTF file that has a triangle as mesh 0, and the given further members.
std::string with_triangle(const std::string& members,
                          const std::string& primitives = R"({"attributes":{"POSITION":0}})") {
    return with_members(
        R"("accessors":[{"componentType":5126,"count":3,"type":"VEC3"}],"meshes":[{"primitives":[)" +
        primitives + "]}]," + members);
}

// A function that writes scene.gltf and the files that it uses. The scene contains `count` of the things that
// the limit counts, for example nodes.
using Write = std::function<void(const fs::path& folder, uint64_t count)>;

void write_text(const fs::path& folder, const std::string& text) {
    std::ofstream(folder / "scene.gltf", std::ios::binary) << text;
}

void write_png(const fs::path& folder, const std::string& name, uint32_t width_px, uint32_t height_px) {
    std::ofstream(folder / name, std::ios::binary) << weft::test::black_png(width_px, height_px);
}

void json_bytes(const fs::path& folder, uint64_t count) {
    std::string text = with_members(R"("extras":"","nodes":[])");
    text.insert(text.find(R"("")") + 1, std::string(count - text.size(), 'a'));
    write_text(folder, text);
}

// Writes nested objects that have one member each. The test must also measure the time that tinygltf needs
// for them. So they are in a known extension: the loader removes unknown extensions and extras before
// tinygltf reads the file.
void json_values(const fs::path& folder, uint64_t count) {
    constexpr uint64_t kDeep = 50;
    std::string chain, end;
    for (uint64_t i = 0; i < kDeep; ++i) {
        chain += R"({"a":)";
        end += '}';
    }
    chain += "0" + end;
    // The loader counts each "{", each "[" and each comma as one value. The parts of the file outside the
    // chains have 10 of these characters. Each chain adds kDeep brackets, and a comma if it is not the first
    // chain. So the sum is 9 + chains × (kDeep + 1).
    const uint64_t chains = (count - 9) / (kDeep + 1), rest = (count - 9) % (kDeep + 1);
    std::string numbers;
    for (uint64_t i = 0; i < rest; ++i) numbers += ",0";
    write_text(folder, with_members(R"("extensions":{"KHR_lights_punctual":{"lights":[],"a":[)" +
                                    repeated(chain, chains) + numbers + R"(]}},"nodes":[])"));
}

void json_depth(const fs::path& folder, uint64_t count) {
    write_text(folder, with_members(R"("nodes":[],"extras":)" + std::string(count - 1, '[') +
                                    std::string(count - 1, ']')));
}

void resource_bytes(const fs::path& folder, uint64_t count) {
    std::ofstream(folder / "zeros.bin", std::ios::binary).put(0);
    // The file is sparse: it has this size but occupies no disk space.
    fs::resize_file(folder / "zeros.bin", count);
    write_text(folder, with_members(R"("buffers":[{"byteLength":)" + std::to_string(count) +
                                    R"(,"uri":"zeros.bin"}])"));
}

// Writes many nodes. Each node has a name, so that the names count for the memory too.
void array_items(const fs::path& folder, uint64_t count) {
    write_text(folder, with_triangle(R"("nodes":[)" + repeated(R"({"mesh":0,"name":"n"})", count) + "]"));
}

// Writes one image and many materials with different alpha cutoffs, so that each material needs its own
// texture.
void materials(const fs::path& folder, uint64_t count) {
    write_png(folder, "a.png", 64, 64);
    std::string all;
    for (uint64_t i = 0; i < count; ++i)
        all += std::string(i > 0 ? "," : "") + R"({"alphaMode":"MASK","alphaCutoff":)" +
               std::to_string(static_cast<double>(i + 1) / static_cast<double>(count + 1)) +
               R"(,"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
    write_text(folder, with_members(R"("images":[{"uri":"a.png"}],"textures":[{"source":0}],"materials":[)" +
                                    all + "]"));
}

void node_depth(const fs::path& folder, uint64_t count) {
    std::string nodes;
    for (uint64_t i = 1; i < count; ++i) nodes += R"({"children":[)" + std::to_string(i) + "]},";
    write_text(folder, with_triangle(R"("nodes":[)" + nodes + R"({"mesh":0}])"));
}

// Writes nodes whose mesh has two primitives, so that each node becomes two instances.
void instances(const fs::path& folder, uint64_t count) {
    const std::string two = repeated(R"({"attributes":{"POSITION":0}})", 2);
    write_text(folder, with_triangle(R"("nodes":[)" + repeated(R"({"mesh":0})", (count + 1) / 2) + "]", two));
}

// Writes one triangle strip whose vertices are all zero. An accessor without a buffer view needs no bytes in
// the file.
void vertices(const fs::path& folder, uint64_t count) {
    write_text(
        folder,
        with_members(
            R"("accessors":[{"componentType":5126,"count":)" + std::to_string(count) +
            R"(,"type":"VEC3"}],"meshes":[{"primitives":[{"mode":5,"attributes":{"POSITION":0,"NORMAL":0}}]}],)" +
            R"("nodes":[{"mesh":0}])"));
}

// Writes a strip over three vertices. The uvs are mirrored in every second triangle, so that vertices must be
// split.
void triangles(const fs::path& folder, uint64_t count) {
    Bytes bytes;
    append<float>(bytes, {0, 0, 0, 1, 0, 0, 0, 1, 0});
    append<float>(bytes, {0, 1, 1, 1, 0, 0});
    const uint64_t corners = count + 2;
    for (uint64_t i = 0; i < corners; ++i) bytes.push_back(static_cast<uint8_t>(i % 3));
    std::ofstream(folder / "strip.bin", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    const std::string size = std::to_string(corners), all = std::to_string(bytes.size());
    write_text(
        folder,
        with_members(
            R"("buffers":[{"uri":"strip.bin","byteLength":)" + all +
            R"(}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24},)" +
            R"({"buffer":0,"byteOffset":60,"byteLength":)" + size +
            R"(}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)" +
            R"({"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"},)" +
            R"({"bufferView":2,"componentType":5121,"count":)" + size + R"(,"type":"SCALAR"}],)" +
            R"("meshes":[{"primitives":[{"mode":5,"indices":2,"attributes":{"POSITION":0,"NORMAL":0,)" +
            R"("TEXCOORD_0":1}}]}],"nodes":[{"mesh":0}])"));
}

void image_side(const fs::path& folder, uint64_t count) {
    write_png(folder, "a.png", static_cast<uint32_t>(count), 1);
    write_text(folder, with_members(R"("images":[{"uri":"a.png"}],"textures":[{"source":0}],)"
                                    R"("materials":[{"normalTexture":{"index":0}}])"));
}

// Writes as many textures of 2048 × 2048 texels as the memory limit allows; one more if `count` exceeds the
// limit. kEach: bytes of a texture with its mips (22'369'620) and of its other data. kBeside: an estimate of
// the other memory, mostly temporary memory of the decoders.
void memory_bytes(const fs::path& folder, uint64_t count) {
    constexpr uint64_t kEach = 22'369'620 + 2048, kLimit = 640ull << 20, kBeside = 68ull << 20;
    const uint64_t fitting = (kLimit - kBeside) / kEach;
    const uint64_t images = count > kLimit ? fitting + 1 : fitting;
    std::string names, textures, slots;
    for (uint64_t i = 0; i < images; ++i) {
        const std::string n = std::to_string(i), comma = i > 0 ? "," : "";
        write_png(folder, n + ".png", 2048, 2048);
        names += comma + R"({"uri":")" + n + R"(.png"})";
        textures += comma + R"({"source":)" + n + "}";
        slots += comma + R"({"normalTexture":{"index":)" + n + "}}";
    }
    write_text(folder, with_members(R"("images":[)" + names + R"(],"textures":[)" + textures +
                                    R"(],"materials":[)" + slots + "]"));
}

struct Edge {
    const char* limit;
    bool is_quick;  // True if the case runs in every test run. The other cases run only with WEFT_EXTENDED=1.
    Write write;
    const char* code;   // Code of the expected error.
    const char* place;  // Beginning of the JSON pointer of the expected error.
};

void PrintTo(const Edge& edge, std::ostream* out) {
    *out << edge.limit;
}

const std::vector<Edge>& edges() {
    static const std::vector<Edge> all{
        {"scene.jsonBytes", false, json_bytes, "S107", ""},
        {"scene.jsonValues", false, json_values, "S107", ""},
        {"scene.jsonDepth", true, json_depth, "S107", ""},
        {"scene.resourceBytes", false, resource_bytes, "S107", "/buffers/0"},
        {"scene.arrayItems", false, array_items, "S107", "/nodes"},
        {"scene.materials", true, materials, "S107", "/materials"},
        {"scene.nodeDepth", true, node_depth, "S109", "/nodes/"},
        {"scene.instances", true, instances, "S107", "/nodes/"},
        {"scene.vertices", false, vertices, "S107", "/accessors/0/count"},
        {"scene.triangles", false, triangles, "S107", "/meshes/0/primitives/0"},
        {"scene.imageSidePx", true, image_side, "S106", "/images/0"},
        {"scene.memoryBytes", false, memory_bytes, "S106", "/images/"},
    };
    return all;
}

TEST(SceneLimits, EachHoldsAtItsEdge) {
    for (const LimitRow& row : limit_table()) {
        const std::string name = row.name;
        if (!name.starts_with("scene.")) continue;
        EXPECT_TRUE(std::ranges::any_of(edges(), [&](const Edge& edge) { return name == edge.limit; }))
            << name;
    }
}

class SceneLimitEdge : public GltfTest, public ::testing::WithParamInterface<Edge> {
 protected:
    [[nodiscard]] static uint64_t limit() {
        Limits defaults;
        for (const LimitRow& row : limit_table())
            if (std::string(row.name) == GetParam().limit) return row.of(defaults);
        return 0;
    }
    // Loads the scene in a child process. The answer is 0 if the scene was loaded, 1 if it was refused with
    // the expected error, 2 if it was refused with another error.
    [[nodiscard]] Cost load_cost() const {
        return cost_of([&] {
            Diagnostics warnings;
            const Result<Scene> scene = load_gltf(folder_ / "scene.gltf", warnings);
            if (scene) return 0;
            const Diagnostic& first = scene.errors().front();
            const bool named = first.code == GetParam().code && first.pointer.starts_with(GetParam().place) &&
                               !first.help.empty() &&
                               first.help.back().find(GetParam().limit) != std::string::npos &&
                               first.help.back().find("--limits") != std::string::npos;
            if (!named) ADD_FAILURE() << to_text(first);
            return named ? 1 : 2;
        });
    }
};

TEST_P(SceneLimitEdge, IsLoadedCheaplyAndRefusedBeyond) {
    if (!GetParam().is_quick && !is_extended()) GTEST_SKIP() << "takes seconds: WEFT_EXTENDED=1 runs it";
    GetParam().write(folder_, limit());
    const Cost at = load_cost();
    EXPECT_TRUE(at.finished);
    EXPECT_EQ(at.answer, 0);
    EXPECT_LE(at.cpu_s, kMostCpu_s);
    EXPECT_LE(at.grown_bytes, SceneLimits{}.memory_bytes + kAllowance_bytes);
    std::printf("%s at %llu: %.2f s, %llu MiB\n", GetParam().limit, static_cast<unsigned long long>(limit()),
                at.cpu_s, static_cast<unsigned long long>(at.grown_bytes >> 20));
    GetParam().write(folder_, limit() + 1);
    const Cost beyond = load_cost();
    EXPECT_TRUE(beyond.finished);
    EXPECT_EQ(beyond.answer, 1);
    EXPECT_LE(beyond.cpu_s, kMostCpu_s);
    EXPECT_LE(beyond.grown_bytes, SceneLimits{}.memory_bytes + kAllowance_bytes);
}

INSTANTIATE_TEST_SUITE_P(All, SceneLimitEdge, ::testing::ValuesIn(edges()), [](const auto& row) {
    return std::string(row.param.limit).substr(std::string("scene.").size());
});

}  // namespace
}  // namespace weft::scene::test
