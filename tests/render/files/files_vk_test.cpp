// Purpose: tests resources with content from files on the device: the bytes that the device has, on one and
// on three queues, the passes at rest that read them, and what happens when a file changes.
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <thread>

#include "tests/render/files/picture_bytes.h"
#include "tests/render/session_fixture.h"
#include "weft/load/resource_content.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTwice = R"(#version 460
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D grain;
readonly buffer Table { vec4 items[]; } table;
layout(r32f) writeonly uniform image2D dst;
void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(dst)))) return;
    imageStore(dst, at, vec4(texelFetch(grain, at, 0).r * table.items[at.x % 2].y));
}
)";

constexpr const char* kGraph = R"({
  "version": 1, "name": "files",
  "resources": {
    "grain": { "file": "grain.png", "format": "r8", "mips": "full" },
    "fine":  { "file": "fine.png", "format": "rgba16" },
    "count": { "file": "grain.png", "format": "r8u" },
    "paint": { "file": "paint.png", "format": "rgba8_srgb", "mips": "full" },
    "light": { "file": "light.pfm", "format": "rgba32f", "mips": 2 },
    "block": { "file": "block.bin", "format": "r16u", "size": [3, 2], "kind": "3d", "depth": 2 },
    "table": { "file": "table.bin", "buffer": "vec4" },
    "part":  { "file": "table.bin", "buffer": "u32", "count": 3 },
    "dst":   { "format": "r32f", "size": [4, 2], "keep": true }
  },
  "passes": {
    "twice": { "type": "compute", "queue": "async", "shader": "twice.comp", "in": ["grain", "table"], "out": ["dst"], "rest": true },
    "read":  { "type": "readback", "in": ["dst"] }
  }
})";

class Files : public SessionTest {
 protected:
    Files() : folder_(fs::path(testing::TempDir()) / ("weft_files_" + std::to_string(getpid()))) {
        fs::create_directories(folder_);
        write("graph.json", kGraph);
        write("twice.comp", kTwice);
        write("grain.png", plain_png(4, 2, 8, 1, {0, 10, 20, 30, 100, 200, 250, 255}));
        write("fine.png", plain_png(2, 1, 16, 4, {1, 2, 3, 4, 65535, 300, 7, 40'000}));
        write("paint.png", plain_png(2, 2, 8, 3, {255, 0, 0, 0, 0, 0, 10, 20, 30, 255, 255, 255}));
        write("light.pfm", plain_pfm(2, 2, {{1, 2, 3}, {5, 6, 7}, {9, 1e6f, 0}, {-3, 0, 2}}));
        write("block.bin", raw_bytes<uint16_t>({1, 2, 3, 4, 5, 6, 70, 80, 90, 100, 110, 65535}));
        write("table.bin", raw_bytes<float>({1, 2, 3, 4, 5, 0.5f, 7, 8}));
    }
    ~Files() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;

    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
    }
    std::unique_ptr<render::Session> begin(std::vector<std::string> observed = {}) {
        return start((folder_ / "graph.json").string(), {16, 16, 1}, std::move(observed));
    }
    // Renders one frame. Returns the data read back, by the name of the resource or pass.
    static std::map<std::string, std::vector<std::byte>> frame(render::Session& session,
                                                               std::set<std::string>* woken = nullptr) {
        EXPECT_TRUE(draw_frame(session));
        EXPECT_TRUE(session.finish());
        std::map<std::string, std::vector<std::byte>> out;
        for (const vk::ReadbackData& data : session.take_readbacks())
            out[data.pass.substr(data.pass.find(':') + 1)] = data.bytes;
        if (woken != nullptr) woken->clear();
        for (const vk::FrameTiming& timing : session.take_timings())
            for (const vk::PassTiming& pass : timing.passes)
                if (woken != nullptr && !pass.woken_by.empty()) woken->insert(pass.pass);
        return out;
    }
    template <class T>
    static std::vector<T> as(const std::vector<std::byte>& bytes) {
        std::vector<T> items(bytes.size() / sizeof(T));
        std::memcpy(items.data(), bytes.data(), items.size() * sizeof(T));
        return items;
    }
    void expect_texels();

    fs::path folder_;
};

void Files::expect_texels() {
    const std::unique_ptr<render::Session> session =
        begin({"grain.mip(0)", "grain.mip(1)", "grain.mip(2)", "fine", "count", "paint.mip(0)",
               "paint.mip(1)", "light.mip(0)", "light.mip(1)", "block", "part"});
    ASSERT_TRUE(session);
    for (int i = 0; i < 3; ++i) {
        const auto found = frame(*session);
        EXPECT_EQ(as<uint8_t>(found.at("grain.mip(0)")),
                  (std::vector<uint8_t>{0, 10, 20, 30, 100, 200, 250, 255}));
        EXPECT_EQ(as<uint8_t>(found.at("grain.mip(1)")), (std::vector<uint8_t>{78, 139}));
        EXPECT_EQ(as<uint8_t>(found.at("grain.mip(2)")), (std::vector<uint8_t>{108}));
        EXPECT_EQ(as<uint8_t>(found.at("count")), as<uint8_t>(found.at("grain.mip(0)")));
        EXPECT_EQ(as<uint16_t>(found.at("fine")), (std::vector<uint16_t>{1, 2, 3, 4, 65535, 300, 7, 40'000}));
        EXPECT_EQ(as<uint8_t>(found.at("paint.mip(0)")),
                  (std::vector<uint8_t>{255, 0, 0, 255, 0, 0, 0, 255, 10, 20, 30, 255, 255, 255, 255, 255}));
        // Half of the area is white or red in linear light: 0.50 is 188 in sRGB, 0.25 is 137.
        EXPECT_NEAR(as<uint8_t>(found.at("paint.mip(1)")).at(0), 188, 1);
        EXPECT_NEAR(as<uint8_t>(found.at("paint.mip(1)")).at(1), 137, 1);
        EXPECT_EQ(as<float>(found.at("light.mip(0)")),
                  (std::vector<float>{1, 2, 3, 1, 5, 6, 7, 1, 9, 1e6f, 0, 1, -3, 0, 2, 1}));
        EXPECT_EQ(as<float>(found.at("light.mip(1)")), (std::vector<float>{3, 250'002, 3, 1}));
        EXPECT_EQ(as<uint16_t>(found.at("block")),
                  (std::vector<uint16_t>{1, 2, 3, 4, 5, 6, 70, 80, 90, 100, 110, 65535}));
        EXPECT_EQ(as<float>(found.at("part")), (std::vector<float>{1, 2, 3}));
        const std::vector<float> dst = as<float>(found.at("read"));
        const std::vector<float> wanted{0, 5, 40, 15, 200, 100, 500, 127.5f};
        ASSERT_EQ(dst.size(), wanted.size());
        for (size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(dst[k], wanted[k] / 255, 1e-5) << k;
    }
}

TEST_F(Files, TheDeviceHasTheTexelsOfTheFiles) {
    expect_texels();
}

TEST_F(Files, TheDeviceHasTheTexelsOnThreeQueues) {
    queues_ = 3;
    device_.reset();
    make_device(true);
    expect_texels();
}

TEST_F(Files, NoBarrierTouchesAFileInAFrame) {
    const std::unique_ptr<render::Session> session = begin();
    ASSERT_TRUE(session);
    const FramePlan& plan = session->plan();
    for (const PassStep& step : plan.barriers.steps)
        for (const BarrierDecl& barrier : step.barriers)
            EXPECT_TRUE(plan.graph.resources[barrier.resource].file.empty())
                << plan.graph.resources[barrier.resource].name;
}

TEST_F(Files, APassAtRestWakesOnlyWhenItsFileChanges) {
    const std::unique_ptr<render::Session> session = begin();
    ASSERT_TRUE(session);
    std::set<std::string> woken;
    frame(*session, &woken);
    EXPECT_EQ(woken, std::set<std::string>{"twice"});
    frame(*session, &woken);
    EXPECT_TRUE(woken.empty());

    const auto reload = [&]() -> render::Rebuilt {
        render::PrepareResult made = session->prepare(session->selection());
        EXPECT_TRUE(made.result) << to_text(made.result.errors());
        if (!made.result) return {};
        EXPECT_TRUE(made.files.contains(folder_ / "table.bin")) << "the file is watched";
        const render::Rebuilt rebuilt = made.result->rebuilt();
        const Result<bool> swapped = session->swap_in(std::move(*made.result));
        EXPECT_TRUE(swapped && *swapped);
        return rebuilt;
    };
    write("fine.png", plain_png(2, 1, 8, 1, {3, 4}));
    EXPECT_TRUE(reload().nothing()) << "no pass uses this file";
    write("table.bin", raw_bytes<float>({1, 4, 3, 4, 5, 1, 7, 8}));
    EXPECT_FALSE(reload().nothing());
    const auto found = frame(*session, &woken);
    EXPECT_EQ(woken, std::set<std::string>{"twice"});
    EXPECT_NEAR(as<float>(found.at("read")).at(2), 80.0f / 255, 1e-5);
    frame(*session, &woken);
    EXPECT_TRUE(woken.empty());
    // A damaged file leaves the running graph as it is.
    write("grain.png", "\x89PNG\r\n\x1a\n broken");
    render::PrepareResult made = session->prepare(session->selection());
    ASSERT_FALSE(made.result);
    EXPECT_EQ(made.result.errors().at(0).code, "W145");
    EXPECT_TRUE(made.files.contains(folder_ / "grain.png"));
    frame(*session, &woken);
    EXPECT_TRUE(woken.empty());
}

TEST_F(Files, AnUnchangedFileIsSharedByTheNextPlan) {
    const std::unique_ptr<render::Session> session = begin();
    ASSERT_TRUE(session);
    frame(*session);
    write("graph.json",
          std::string(kGraph).replace(std::string(kGraph).find("\"size\": [4, 2]"), 14, "\"size\": [4, 1]"));
    for (int i = 0; i < 3; ++i) {
        render::PrepareResult made = session->prepare(session->selection());
        ASSERT_TRUE(made.result) << to_text(made.result.errors());
        ASSERT_TRUE(session->swap_in(std::move(*made.result)));
        EXPECT_EQ(as<float>(frame(*session).at("read")).size(), i % 2 == 0 ? 4u : 8u);
        write("graph.json",
              i % 2 == 0 ? kGraph
                         : std::string(kGraph).replace(std::string(kGraph).find("[4, 2]"), 6, "[4, 1]"));
    }
}

// A program that provides all files from memory.
TEST_F(Files, ACustomReaderProvidesTheFiles) {
    LoadSettings settings;
    settings.reader = [&](const std::string& path) -> std::optional<std::string> {
        const std::string name = fs::path(path).filename().string();
        if (fs::path(path).parent_path() != "memory") return std::nullopt;
        if (name == "graph.json") return kGraph;
        return read_text((folder_ / name).string());
    };
    GraphRequest request;
    request.path = "memory/graph.json";
    const Result<ParsedGraph> parsed = parse_graph(request, settings);
    ASSERT_TRUE(parsed) << to_text(parsed.errors());
    const FileDesc& file = parsed->desc.resources.at("light").file;
    EXPECT_EQ(file.path, "memory/light.pfm");
    EXPECT_EQ(file.width_px, 2u);
    ResolvedGraph graph;
    ResourceDecl light;
    light.format = Format::rgba32f;
    light.extent = {2, 2, 1};
    light.file = file.name;
    light.file_path = file.path;
    const Result<ResourceContent> content = read_resource_content(graph, light, settings);
    ASSERT_TRUE(content) << to_text(content.errors());
    EXPECT_EQ(as<float>(content->levels.at(0)).at(9), 1e6f);
}

TEST_F(Files, FilesOverTheLimitAreRefused) {
    LoadSettings settings;
    settings.reader = read_text;
    settings.reads_disk = true;
    settings.limits.graph.file_bytes = 300;
    GraphRequest request;
    request.path = (folder_ / "graph.json").string();
    const Result<ParsedGraph> parsed = parse_graph(request, settings);
    ASSERT_FALSE(parsed);
    EXPECT_EQ(parsed.errors().at(0).code, "W145");
    EXPECT_NE(to_text(parsed.errors()).find("graph.fileBytes"), std::string::npos);
}

TEST_F(Files, LinksMustNotLeadOut) {
    const fs::path outside = fs::path(testing::TempDir()) / ("weft_outside_" + std::to_string(getpid()));
    std::ofstream(outside, std::ios::binary) << "secret bytes....";
    fs::remove(folder_ / "table.bin");
    fs::create_symlink(outside, folder_ / "table.bin");
    LoadSettings settings;
    settings.reader = read_text;
    settings.reads_disk = true;
    GraphRequest request;
    request.path = (folder_ / "graph.json").string();
    const Result<ParsedGraph> parsed = parse_graph(request, settings);
    fs::remove(outside);
    ASSERT_FALSE(parsed);
    EXPECT_EQ(parsed.errors().at(0).code, "W145");
    EXPECT_NE(parsed.errors().at(0).message.find("symbolic link"), std::string::npos);
}

}  // namespace
}  // namespace weft::test
