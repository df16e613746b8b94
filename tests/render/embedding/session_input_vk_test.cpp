// Tests the first steps of a program with Weft: members of SessionInput that are not set or wrong, draw lists
// and descriptor sets of the program, an exchanged output image, and the sky of a session without a scene.
#include <algorithm>
#include <array>

#include "tests/render/engine/engine_fixture.h"
#include "tests/render/engine/triangle_list.h"
#include "weft/graph_builder.h"
#include "weft/memory_files.h"
#include "weft/render/import_catalog.h"

namespace weft::test {
namespace {

const std::string kSky = WEFT_SOURCE_DIR "/tests/render/embedding/sky.json";

// The triangle of TriangleList, with tight vectors of three floats.
class TightList final : public render::DrawList {
 public:
    TightList(vk::Device& device, const TriangleList& paint) : paint_(paint) {
        const std::array<glm::vec3, 3> corners{glm::vec3(-1, -1, 0), {1, -1, 0}, {0, 2, 0}};
        Result<vk::Buffer> buffer = vk::Buffer::create(
            device, sizeof corners, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, vk::Buffer::Memory::upload, "tight");
        EXPECT_TRUE(buffer);
        std::ranges::copy(std::as_bytes(std::span(corners)), buffer->mapped().begin());
        vertices_ = std::move(*buffer);
    }
    uint32_t record(const vk::DrawContext& draw, const render::DrawView& /*view*/) const override {
        paint_.bind_material(draw);
        const VkBuffer vertices = vertices_.handle();
        const VkDeviceSize offset = 0;
        draw.fn->vkCmdBindVertexBuffers(draw.commands, 0, 1, &vertices, &offset);
        draw.fn->vkCmdDraw(draw.commands, 3, 1, 0, 0);
        return 0;
    }

 private:
    const TriangleList& paint_;
    vk::Buffer vertices_;
};

class SessionInputs : public EngineTest {
 protected:
    // A pass draws the list `list` of the program, with a material set of the program.
    render::SessionInput input_with(const TriangleList& triangle, const std::string& list = "triangles") {
        weft::GraphBuilder graph("one list");
        graph.import(list, "drawlist");
        graph.import("backbuffer", "output");
        graph.image("drawn", "rgba8");
        graph.raster("draw", "own").draws({list}).out("color", "drawn");
        graph.pass("show", "blit").in("drawn").out("backbuffer");
        render::SessionInput input =
            input_for(WEFT_SOURCE_DIR "/tests/render/engine/one_list.json", {"drawn"});
        files_.put(input.request.path, graph.to_json());
        input.load.reader = files_.reader({});
        input.load.reads_disk = false;
        input.draw_lists[list] = {&triangle, {{16}, {{"corner", Format::rgba32f, 0, 0}}}};
        input.draw_sets[2] = {triangle.layout(),
                              {{2, 0, BindingKind::uniform_buffer, stage_bit(ShaderStage::fragment), 16}}};
        return input;
    }
    Diagnostic fault_of(const render::SessionInput& input) {
        const auto session = render::Session::create(*device_, input, warnings_);
        EXPECT_FALSE(session);
        if (session) return {};
        EXPECT_EQ(session.errors().size(), 1u) << to_text(session.errors());
        EXPECT_FALSE(session.errors().front().help.empty());
        return session.errors().front();
    }
    std::unique_ptr<render::Session> open_without_scene(const render::SessionInput& input) {
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        if (!session) return nullptr;
        frame_of(**session).camera.transform = moved(0, 0, 6);
        return std::move(*session);
    }
    // Renders one frame and returns the texels of the resource `name`.
    static std::vector<glm::vec4> rendered(render::Session& session, const std::string& name, Format format) {
        return render::decode_texels(format, render_one(session).images.at(name));
    }
    vk::Image output_image(const render::Session& session) {
        const ResolvedGraph& graph = session.plan().graph;
        Result<vk::Image> image = vk::Image::create(*device_, graph.resources[graph.output]);
        EXPECT_TRUE(image);
        return std::move(*image);
    }

    MemoryFiles files_;
};

TEST_F(SessionInputs, WithoutAReaderTheFilesAreReadFromDisk) {
    render::SessionInput input = input_for(kSky, {"dome"});
    input.load.reader = {};
    input.load.reads_disk = false;
    const auto session = open_without_scene(input);
    ASSERT_TRUE(session);
    EXPECT_EQ(render_one(*session).images.size(), 1u);
    input.request.path = WEFT_SOURCE_DIR "/tests/render/embedding/none.json";
    EXPECT_EQ(fault_of(input).code, "W002") << "there is no such file";
}

TEST_F(SessionInputs, APassCatalogueIsNeeded) {
    render::SessionInput input = input_for(kSky, {});
    input.passes = nullptr;
    EXPECT_EQ(fault_of(input).code, "W254");
}

TEST_F(SessionInputs, EachAttributeLiesInItsStream) {
    const TriangleList triangle(*device_);
    render::SessionInput input = input_with(triangle);
    VertexFormat& format = input.draw_lists.at("triangles").vertex_format;
    format.stride_bytes.clear();
    EXPECT_EQ(fault_of(input).code, "W255");
    format.stride_bytes = {12};
    const Diagnostic beyond = fault_of(input);
    EXPECT_EQ(beyond.code, "W255");
    EXPECT_NE(beyond.message.find("ends at byte 16"), std::string::npos) << beyond.message;
    EXPECT_NE(to_text(beyond).find("help: correct the offset, the format or the stride; three floats"),
              std::string::npos)
        << to_text(beyond);
    format.stride_bytes = {16};
    for (const Format impossible : {Format::undefined, Format::d32f, Format::rgba8_srgb}) {
        format.attributes.front().format = impossible;
        EXPECT_EQ(fault_of(input).code, "W255") << format_info(impossible).name;
    }
    format.attributes.front().format = Format::rgba32u;
    const Diagnostic other = fault_of(input);
    EXPECT_EQ(other.code, "W167");
    EXPECT_NE(other.message.find("rgba32u"), std::string::npos) << other.message;
}

TEST_F(SessionInputs, TightPositionsGiveTheSamePicture) {
    const TriangleList triangle(*device_, 1);
    const TightList tight(*device_, triangle);
    render::SessionInput input = input_with(triangle);
    const auto wanted = open_without_scene(input);
    input.draw_lists["triangles"] = {&tight, {{12}, {{"corner", Format::rgb32f, 0, 0}}}};
    const auto session = open_without_scene(input);
    ASSERT_TRUE(wanted && session);
    const std::vector<glm::vec4> picture = rendered(*wanted, "drawn", Format::rgba8);
    EXPECT_LT(glm::length(picture[kEngineSize.height / 2 * kEngineSize.width + kEngineSize.width / 2] -
                          TriangleList::kTint),
              0.01f);
    EXPECT_EQ(picture.front(), glm::vec4(0));
    EXPECT_EQ(rendered(*session, "drawn", Format::rgba8), picture);
}

TEST_F(SessionInputs, AListReplacesAnEmptyOneOfTheScene) {
    const TriangleList triangle(*device_, 1);
    const auto wanted = open_without_scene(input_with(triangle));
    ASSERT_TRUE(wanted);
    const std::vector<glm::vec4> picture = rendered(*wanted, "drawn", Format::rgba8);
    for (const char* list : render::kDrawLists) {
        const render::SessionInput input = input_with(triangle, list);
        const auto session = open_without_scene(input);
        ASSERT_TRUE(session) << list;
        EXPECT_EQ(rendered(*session, "drawn", Format::rgba8), picture) << list;
        // A scene of lights alone has empty lists, too.
        scene::Scene lights = squares({});
        const auto lit = open(lights, input);
        ASSERT_TRUE(lit) << list;
        frame_of(*lit).camera.transform = moved(0, 0, 6);
        EXPECT_EQ(rendered(*lit, "drawn", Format::rgba8), picture) << list;
    }
}

TEST_F(SessionInputs, AShaderNeedsTheSetsOfTheProgram) {
    const TriangleList triangle(*device_);
    render::SessionInput input = input_with(triangle);
    input.draw_sets.clear();
    const Diagnostic missing = fault_of(input);
    EXPECT_EQ(missing.code, "W256");
    EXPECT_GT(missing.line, 0u) << "the place in the graph";
    EXPECT_NE(missing.message.find("\"triangles\""), std::string::npos) << missing.message;
    input = input_with(triangle);
    input.draw_sets.at(2).bindings.front().binding = 1;
    const Diagnostic other = fault_of(input);
    EXPECT_EQ(other.code, "W185");
    ASSERT_FALSE(other.help.empty());
    EXPECT_EQ(other.help.back(),
              "the program binds in set 2: 1: uniform block of 16 bytes in fragment shaders");
}

TEST_F(SessionInputs, APartNeedsTheSetsOfWeft) {
    const TriangleList triangle(*device_);
    const auto session = open_without_scene(input_with(triangle));
    ASSERT_TRUE(session);
    Result<render::ScenePart> part = session->prepare_part(squares({{"a", 0, 0, glm::mat4(1)}}));
    ASSERT_TRUE(part);
    const Result<render::PartId> added = session->add_part(std::move(*part));
    ASSERT_FALSE(added);
    EXPECT_EQ(added.errors().front().code, "W246");
}

TEST_F(SessionInputs, WithoutPartsOnlyThePipelinesOfTheSceneAreCreated) {
    // The squares are opaque. The graph also draws masked and transparent surfaces.
    const scene::Scene scene = squares({{"a", 0, 0, glm::mat4(1)}});
    const auto open_with = [&](bool adds_parts) {
        render::SessionInput input = input_for(kDeferredGraph, {"hdr"});
        input.load.graph_root = WEFT_SOURCE_DIR "/graphs";
        input.adds_parts = adds_parts;
        return open(scene, input);
    };
    const auto all = open_with(true), fewer = open_with(false);
    ASSERT_TRUE(all && fewer);
    const auto pipelines = [](const render::Session& session) {
        return session.parts().frames.executor().pipelines().made;
    };
    EXPECT_EQ(pipelines(*fewer) + 3, pipelines(*all)) << "\"masked\", \"maskedStill\" and \"transparent\"";
    EXPECT_EQ(render_one(*fewer).images, render_one(*all).images);
    Result<render::ScenePart> part = fewer->prepare_part(squares({{"b", 0, 0, glm::mat4(1)}}));
    ASSERT_TRUE(part);
    const Result<render::PartId> added = fewer->add_part(std::move(*part));
    ASSERT_FALSE(added);
    EXPECT_EQ(added.errors().front().code, "W246");
    EXPECT_NE(to_text(added.errors()).find("adds_parts"), std::string::npos) << to_text(added.errors());
}

TEST_F(SessionInputs, ResizingExchangesTheImageAlsoAtTheSameSize) {
    const auto session = open_without_scene(input_for(kSky, {"dome"}));
    ASSERT_TRUE(session);
    vk::Image first = output_image(*session), second = output_image(*session);
    const auto resize = [&](VkImage image) {
        const Status done = session->resize(kEngineSize, warnings_, image);
        EXPECT_TRUE(done) << to_text(done.errors());
    };
    const auto draw_red = [&](float red) {
        frame_of(*session).sky = {{.zenith = {red, 0, 0}, .horizon = {red, 0, 0}}};
        render_one(*session);
        const Result<vk::ReadbackData> read = session->read_output();
        EXPECT_TRUE(read);
        return read ? render::decode_texels(Format::rgba8, read->bytes).front().x : 0.0f;
    };
    resize(first.handle());
    EXPECT_EQ(session->selection().output, first.handle());
    EXPECT_EQ(draw_red(1), 1);
    resize(second.handle());
    EXPECT_EQ(session->selection().output, second.handle());
    for (int i = 0; i < 2; ++i) draw_red(1);
    // The validation layer reports a frame that uses the old image.
    first = vk::Image();
    EXPECT_EQ(draw_red(0), 0);
    const FramePlan* plan = &session->plan();
    resize(second.handle());
    EXPECT_EQ(&session->plan(), plan) << "the same size and image: nothing happens";
    EXPECT_TRUE(session->finish());
    frame_of(*session).sky = {};
}

TEST_F(SessionInputs, AFrameHasItsSky) {
    const auto session = open_without_scene(input_for(kSky, {"dome"}));
    ASSERT_TRUE(session);
    const auto dome = [&] { return rendered(*session, "dome", Format::rgba32f); };
    const glm::vec4 black(0, 0, 0, 1);
    EXPECT_EQ(dome(), (std::vector<glm::vec4>{black, black, black, black}));
    render::FrameInput& frame = frame_of(*session);
    frame.sky = {{.zenith = {1, 2, 4}, .horizon = {4, 8, 16}}};
    const std::vector<glm::vec4> reflected{{1, 2, 4, 1}, {4, 8, 16, 1}, {1, 2, 4, 1}, black};
    EXPECT_EQ(dome(), reflected) << "the pass at rest wakes";
    EXPECT_EQ(render_one(*session).woken, std::set<std::string>()) << "the sky is the same";
    frame.sky->ground = glm::vec3(0.5f, 0, 0);
    EXPECT_EQ(dome()[2], glm::vec4(0.5f, 0, 0, 1));
    frame.sky.reset();
    EXPECT_EQ(dome()[1], black) << "the sky of the scene again";
}

TEST_F(SessionInputs, AParameterThatCannotHaveItsValueIsNamed) {
    const auto session = open_without_scene(input_for(kSky, {"dome"}));
    ASSERT_TRUE(session);
    frame_of(*session).parameters = {{"gain", 2}, {"lift", 3}};
    const Status refused = draw_frame(*session);
    EXPECT_EQ(code_of(refused), "W242");
    EXPECT_NE(to_text(refused.errors()).find("lift = 3"), std::string::npos) << to_text(refused.errors());
    EXPECT_EQ(to_text(refused.errors()).find("gain"), std::string::npos) << to_text(refused.errors());
    frame_of(*session).parameters = {{"gain", 2}, {"lift", 1}};
    EXPECT_EQ(rendered(*session, "dome", Format::rgba32f)[3], glm::vec4(1));
}

TEST_F(SessionInputs, WithoutASceneTheLightsOfAFrameMayContainASun) {
    render::SessionInput input = input_for(kDeferredGraph, {});
    input.load.graph_root = WEFT_SOURCE_DIR "/graphs";
    const auto session = open_without_scene(input);
    ASSERT_TRUE(session);
    EXPECT_TRUE(std::ranges::any_of(session->plan().schedule.order, [&](PassId pass) {
        return session->plan().graph.passes[pass].view == "sun(0)";
    }));
    frame_of(*session).lights = squares({}).lights;
    render_one(*session);
    EXPECT_GT(session->parts().frames.sun().constants.count, 0u);
    frame_of(*session).lights = std::vector<scene::Light>();
    render_one(*session);
}

}  // namespace
}  // namespace weft::test
