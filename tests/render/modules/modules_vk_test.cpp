// Tests instances of a module on a device: each instance has its own values, resources and group, and an edit
// of the files of the module is noticed.
#include <stdlib.h>  // mkdtemp

#include <cstring>
#include <filesystem>
#include <fstream>

#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kSize_px{16, 16, 1};

// Adds `step` to the source, and then multiplies the sum by the number of the round in a group.
constexpr const char* kModule = R"json({
  "version": 1,
  "ports": { "source": "an image of one channel", "factor": "" },
  "params": { "step": 1, "factor": 1 },
  "consts": { "last": 1 },
  "resources": {
    "sum": "r32f",
    "rounds": { "format": "r32f", "size": "output", "layers": "last + 1", "keep": true }
  },
  "passes": { "add": { "type": "compute", "shader": "add.comp", "in": ["source"], "out": ["sum"] } },
  "groups": {
    "scale": {
      "repeat": { "m": "0..last" },
      "resources": { "raw": "r32f" },
      "passes": {
        "multiply": { "type": "compute", "shader": "multiply.comp", "in": ["sum"], "out": ["raw"] },
        "put": { "type": "copy", "in": ["raw@multiply"], "out": { "dst": "rounds.layer(m)" } }
      }
    }
  }
})json";
constexpr const char* kAdd = R"(#version 460
#include "shape.glsl"
uniform sampler2D source;
layout(r32f) writeonly uniform image2D sum;
layout(push_constant) uniform Params { float step; } params;
void main() { imageStore(sum, AT, texelFetch(source, AT, 0) + params.step); }
)";
constexpr const char* kMultiply = R"(#version 460
#include "shape.glsl"
uniform sampler2D sum;
layout(r32f) writeonly uniform image2D raw;
layout(push_constant) uniform Params { int m; float factor; } params;
void main() { imageStore(raw, AT, texelFetch(sum, AT, 0) * params.factor * float(params.m + 1)); }
)";
constexpr const char* kShape =
    "layout(local_size_x = 8, local_size_y = 8) in;\n#define AT ivec2(gl_GlobalInvocationID.xy)\n";
constexpr const char* kGraph = R"({
  "version": 1,
  "imports": { "backbuffer": "output" },
  "include": [
    { "file": "steps/steps.json", "as": "a", "with": { "source": "start" } },
    { "file": "steps/steps.json", "as": "b", "with": { "source": "a::sum", "factor": "ten" } }
  ],
  "params": { "step": 100, "b::step": 5 },
  "consts": { "ten": 10 },
  "resources": { "start": "r32f" },
  "passes": {
    "begin": { "type": "clear", "out": ["start"], "clear": 2 },
    "b::add": { "queue": "async" },
    "end": { "type": "clear", "out": ["backbuffer"], "clear": 0, "after": ["b::scale::put"] }
  }
})";

std::string with_replaced(std::string text, const std::string& from, const std::string& to) {
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

// A temporary folder.
class EditedFolder {
 public:
    EditedFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "weft_modules_XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    ~EditedFolder() {
        std::error_code failed;
        std::filesystem::remove_all(path_, failed);
    }
    EditedFolder(const EditedFolder&) = delete;
    EditedFolder& operator=(const EditedFolder&) = delete;

    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << text;
    }
    [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
    std::filesystem::path path_;
};

class Modules : public SessionTest {
 protected:
    Modules() {
        folder_.write("lib/steps/steps.json", kModule);
        folder_.write("lib/steps/add.comp", kAdd);
        folder_.write("lib/steps/multiply.comp", kMultiply);
        folder_.write("lib/steps/shape.glsl", kShape);
        folder_.write("graph/graph.json", kGraph);
    }

    std::unique_ptr<render::Session> begin() {
        const Result<scene::Scene> scene = scene::make_builtin("spheres");
        passes_ = registered_passes();
        render::SessionInput input;
        input.adds_parts = false;
        input.request.path = folder_ / "graph/graph.json";
        input.request.size = kSize_px;
        input.request.observed = {"a::sum", "b::sum", "a::rounds", "b::rounds"};
        input.load.reader = read_text;
        input.load.reads_disk = true;
        input.load.graph_root = WEFT_SOURCE_DIR "/graphs";
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.load.shader_cache = WEFT_TEST_CACHE;
        input.load.graph_path = {folder_ / "lib"};
        input.passes = &passes_;
        input.check_plan = true;
        input.queues = queues_;
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, *scene, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        if (!session) return nullptr;
        frame_of(**session) = {.camera = scene::framing_camera(*scene, 1)};
        return std::move(*session);
    }

    // Renders a frame. Returns the first texel of each layer of each observed resource.
    std::map<std::string, std::vector<float>> frame(render::Session& session) {
        EXPECT_TRUE(draw_frame(session));
        EXPECT_TRUE(session.finish());
        std::map<std::string, std::vector<float>> texels;
        for (const vk::ReadbackData& data : session.take_readbacks()) {
            constexpr size_t kLayerBytes = sizeof(float) * kSize_px.width * kSize_px.height;
            std::vector<float>& layers = texels[data.pass.substr(std::string("observe:").size())];
            for (size_t at = 0; at < data.bytes.size(); at += kLayerBytes)
                std::memcpy(&layers.emplace_back(), &data.bytes[at], sizeof(float));
        }
        return texels;
    }

    void reload(render::Session& session) {
        render::PrepareResult made = session.prepare(session.selection());
        ASSERT_TRUE(made.result) << to_text(made.result.errors());
        ASSERT_TRUE(session.swap_in(std::move(*made.result)));
    }

    EditedFolder folder_;
};

using Texels = std::vector<float>;

TEST_F(Modules, EachInstanceHasItsOwnValuesAndResources) {
    for (const uint32_t queues : {1u, 3u}) {
        queues_ = queues;
        make_device(true);
        const std::unique_ptr<render::Session> session = begin();
        ASSERT_TRUE(session);
        for (int i = 0; i < 2; ++i) {
            auto texels = frame(*session);
            EXPECT_EQ(texels["a::sum"], Texels{3});
            EXPECT_EQ(texels["b::sum"], Texels{8});
            EXPECT_EQ(texels["a::rounds"], (Texels{3, 6}));
            EXPECT_EQ(texels["b::rounds"], (Texels{80, 160}));
        }
    }
}

TEST_F(Modules, AnEditOfAModuleIsNoticed) {
    const std::unique_ptr<render::Session> session = begin();
    ASSERT_TRUE(session);
    EXPECT_EQ(frame(*session)["b::sum"], Texels{8});
    folder_.write("lib/steps/steps.json", with_replaced(kModule, "\"step\": 1", "\"step\": 2"));
    reload(*session);
    EXPECT_EQ(frame(*session)["b::sum"], Texels{9}) << "the graph gives b::step another value";
    folder_.write("lib/steps/add.comp", with_replaced(kAdd, "+ params.step", "- params.step"));
    reload(*session);
    EXPECT_EQ(frame(*session)["b::sum"], Texels{-5});
    folder_.write("graph/steps/steps.json", with_replaced(kModule, "\"step\": 1", "\"step\": 3"));
    for (const auto& [name, text] :
         {std::pair{"add.comp", kAdd}, {"multiply.comp", kMultiply}, {"shape.glsl", kShape}})
        folder_.write(std::string("graph/steps/") + name, text);
    reload(*session);
    EXPECT_EQ(frame(*session)["b::sum"], Texels{10}) << "a copy beside the graph comes before the graph path";
}

}  // namespace
}  // namespace weft::test
