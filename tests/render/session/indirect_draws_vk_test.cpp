// Tests indirect draws: a shipped graph draws its opaque list with a copy of the scene's draw commands. The
// picture must be the same as with direct draws. A device without the needed feature must give an error.
#include <filesystem>
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
    static Result<std::vector<std::vector<std::byte>>> albedo(vk::Device& device, FileReader reader) {
        const PassCatalog passes = registered_passes();
        const scene::Scene scene = scene::make_spheres();
        render::SessionInput input;
        input.request.path = "graph.json";
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

TEST_F(IndirectDraws, AreRefusedWithoutTheFeatureThatTellsInstancesApart) {
    const vk::NativeDevice own = vk::native(*device_);
    vk::FeatureChain enabled;
    vk::required_features(enabled);
    enabled.v10().shaderUniformBufferArrayDynamicIndexing = VK_TRUE;
    const Result<std::unique_ptr<vk::Device>> plain =
        vk::Device::adopt({own.instance, own.physical, own.device, {own.queue}, &enabled});
    ASSERT_TRUE(plain) << to_text(plain.errors());
    EXPECT_TRUE(albedo(**plain, read_direct));
    const auto refused = albedo(**plain, read_indirect);
    ASSERT_FALSE(refused);
    ASSERT_EQ(refused.errors().size(), 1u);
    EXPECT_EQ(refused.errors()[0].code, "V417");
    EXPECT_EQ(refused.errors()[0].file, "graph.json");
    EXPECT_NE(refused.errors()[0].message.find("pass \"gbuffer\""), std::string::npos);
    ASSERT_EQ(refused.errors()[0].help.size(), 1u);
    EXPECT_NE(refused.errors()[0].help[0].find("\"draws\": [\"opaque\"]"), std::string::npos);
}

}  // namespace
}  // namespace weft::test
