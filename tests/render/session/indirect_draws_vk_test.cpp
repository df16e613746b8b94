// Tests indirect draws: a shipped graph draws its opaque list with a copy of the scene's draw commands. The
// picture must be the same as with direct draws. A device without the needed feature must give an error.
// Another graph draws as many commands as a compute pass has counted.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scene/builtin/builtin_spheres.h"
#include "tests/render/session_fixture.h"
#include "weft/vulkan/native.h"

namespace weft::test {
namespace {

std::string indirect_graph() {
    const std::string path = WEFT_SOURCE_DIR "/graphs/deferred.json";
    using Json = nlohmann::ordered_json;
    Json graph = Json::parse(read_text(path).value_or("{}"), nullptr, true, true);
    graph["imports"]["opaqueCommands"] = "buffer";
    graph["resources"]["kept"] = {{"buffer", "DrawCommand"}, {"count", "opaqueDraws"}};
    graph["passes"]["keepAll"] = {{"type", "copy"}, {"in", {"opaqueCommands"}}, {"out", {"kept"}}};
    graph["passes"]["gbuffer"]["draws"] = {{"list", "opaque"}, {"indirect", "kept"}};
    return graph.dump(2);
}

class IndirectDraws : public SessionTest {
 protected:
    // Renders two frames on `device` and returns their albedo images as bytes.
    static Result<std::vector<std::vector<std::byte>>> albedo(vk::Device& device, FileReader reader,
                                                              const std::string& path = "graph.json") {
        const PassCatalog passes = registered_passes();
        const scene::Scene scene = scene::make_spheres();
        render::SessionInput input;
        input.request.path = path;
        input.load.reader = std::move(reader);
        input.load.graph_root = WEFT_SOURCE_DIR "/graphs";
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.passes = &passes;
        input.request.size = {96, 54, 1};
        input.request.observed = {"albedo"};
        input.check_plan = true;
        Diagnostics warnings;
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(device, scene, input, warnings);
        if (!session) return session.take_errors();
        Status done = Unit{};
        for (int frame = 0; frame < 2 && done; ++frame)
            done = (*session)->render_frame({.camera = scene.cameras[0]});
        if (done) done = (*session)->finish();
        if (!done) return done.take_errors();
        std::vector<std::vector<std::byte>> pictures;
        for (vk::ReadbackData& data : (*session)->take_readbacks()) pictures.push_back(std::move(data.bytes));
        return pictures;
    }

    static std::optional<std::string> read_indirect(const std::string& path) {
        return path == "graph.json" ? indirect_graph() : read_included(path);
    }
    static std::optional<std::string> read_direct(const std::string& path) {
        return read_included(path == "graph.json" ? WEFT_SOURCE_DIR "/graphs/deferred.json" : path);
    }
    static std::optional<std::string> read_included(const std::string& path) {
        if (!std::filesystem::exists(path)) return std::nullopt;
        return read_text(path);
    }
};

TEST_F(IndirectDraws, ByTheScenesOwnCommandsGiveTheSamePicture) {
    const auto direct = albedo(*device_, read_direct), indirect = albedo(*device_, read_indirect);
    ASSERT_TRUE(direct) << to_text(direct.errors());
    ASSERT_TRUE(indirect) << to_text(indirect.errors());
    ASSERT_EQ(direct->size(), 2u);
    EXPECT_EQ(*direct, *indirect);
    EXPECT_NE((*direct)[0], std::vector<std::byte>((*direct)[0].size())) << "a black picture proves nothing";
}

// The pass "surfaces" draws every object that is not in slot 0, 3, 6 and so on of the list: either with one
// command and a number of draws, or with commands whose number of instances is 0. A compute pass collects the
// commands in any order, so the pass writes only depth, which does not depend on the order.
std::string counted_graph(bool counted) {
    return std::string(R"j({"version": 1, "name": "counted",
"imports": {"opaque": "drawlist", "opaqueCommands": "buffer", "backbuffer": "output"},
"resources": {"kept": {"buffer": "DrawCommand", "count": "opaqueDraws"}, "number": {"buffer": "u32", "count": 1},
              "albedo": "d32f"},
"passes": {
  "zero": {"type": "clear", "out": ["number"]},
  "collect": {"type": "compute", "shader": ")j") +
           (counted ? "collect.comp" : "blank.comp") +
           R"j(", "threads": "opaqueDraws", "in": ["opaqueCommands"],
              "out": ["kept", "number"]},
  "surfaces": {"type": "raster", "shader": "flat", "depth": "albedo", "state": {"cull": "none"},
               "draws": {"list": "opaque", "indirect": "kept")j" +
           (counted ? R"j(, "count": "number")j" : "") + R"j(}},
  "wipe": {"type": "clear", "out": ["backbuffer"]}}})j";
}

std::string collect_shader(bool counted) {
    return std::string(R"j(#version 460
#include "shared/draw_command.glsl"
layout(local_size_x = 64) in;
readonly buffer Commands { DrawCommand items[]; } opaqueCommands;
writeonly buffer Kept { DrawCommand items[]; } kept;
buffer Number { uint draws; } number;
layout(push_constant) uniform Params { uint opaqueDraws; } params;
void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i >= params.opaqueDraws) return;
    DrawCommand command = opaqueCommands.items[i];
)j") + (counted ? "    if (i % 3 != 0) kept.items[atomicAdd(number.draws, 1)] = command;\n}\n"
                : "    if (i % 3 == 0) command.instance_count = 0;\n    kept.items[i] = command;\n"
                  "    atomicAdd(number.draws, 1);\n}\n");
}

// Writes the graph and its shaders to a folder, and returns the path of the graph.
std::string write_counted_files(const std::filesystem::path& folder, bool counted) {
    std::filesystem::create_directories(folder / "flat");
    const auto write = [&](const char* name, const std::string& text) {
        std::ofstream(folder / name, std::ios::binary) << text;
    };
    write("graph.json", counted_graph(counted));
    write(counted ? "collect.comp" : "blank.comp", collect_shader(counted));
    write("flat/flat.frag", "#version 460\nvoid main() {}\n");
    write("flat/flat.vert", R"j(#version 460
#include "frame_set.glsl"
#include "shared/instance.glsl"
layout(location = 0) in vec4 position;
layout(set = 3, binding = 0, std430) readonly buffer Instances { Instance instances[]; };
void main() {
    gl_Position = view.view_projection * (instances[gl_InstanceIndex].object_to_world * vec4(position.xyz, 1.0));
}
)j");
    return (folder / "graph.json").string();
}

TEST_F(IndirectDraws, AsManyAsABufferSaysGiveTheSameDepth) {
    if (!device_->optional().draw_indirect_count) GTEST_SKIP() << "the device lacks drawIndirectCount";
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("weft_counted_" + std::to_string(::getpid()));
    const auto blanked = albedo(*device_, read_included, write_counted_files(folder / "blanked", false));
    const auto counted = albedo(*device_, read_included, write_counted_files(folder / "counted", true));
    std::filesystem::remove_all(folder);
    ASSERT_TRUE(blanked) << to_text(blanked.errors());
    ASSERT_TRUE(counted) << to_text(counted.errors());
    EXPECT_EQ(*blanked, *counted);
    EXPECT_NE((*counted)[0], std::vector<std::byte>((*counted)[0].size()))
        << "a black picture proves nothing";
}

TEST_F(IndirectDraws, AreRefusedWithoutTheFeatureThatTellsInstancesApart) {
    const vk::NativeDevice own = vk::native(*device_);
    vk::FeatureChain enabled;
    vk::required_features(enabled);
    enabled.v10().shaderUniformBufferArrayDynamicIndexing = enabled.v10().imageCubeArray = VK_TRUE;
    const Result<std::unique_ptr<vk::Device>> plain =
        vk::Device::adopt({own.instance, own.physical, own.device, {own.queue}, &enabled});
    ASSERT_TRUE(plain) << to_text(plain.errors());
    EXPECT_TRUE(albedo(**plain, read_direct));
    const auto refused = albedo(**plain, read_indirect);
    ASSERT_FALSE(refused);
    ASSERT_EQ(refused.errors().size(), 1u);
    EXPECT_EQ(refused.errors()[0].code, "V417");
    EXPECT_TRUE(refused.errors()[0].file.ends_with("gbuffer.json")) << refused.errors()[0].file;
    EXPECT_NE(refused.errors()[0].message.find("pass \"gbuffer\""), std::string::npos);
    ASSERT_EQ(refused.errors()[0].help.size(), 1u);
    EXPECT_NE(refused.errors()[0].help[0].find("\"draws\": [\"opaque\"]"), std::string::npos);
}

}  // namespace
}  // namespace weft::test
