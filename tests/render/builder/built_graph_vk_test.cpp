// Tests a session that renders a graph made in C++, and changes to another one while it runs.
#include "tests/render/session_fixture.h"
#include "weft/graph_builder.h"
#include "weft/memory_files.h"
#include "weft/render/reloader.h"

namespace weft::test {
namespace {

constexpr Extent3D kFilled_px{8, 4, 1};

class BuiltGraphs : public SessionTest {
 protected:
    // Makes a graph that fills the output.
    static weft::GraphBuilder fill(double red) {
        weft::GraphBuilder graph("fill");
        graph.import("backbuffer", "output");
        graph.param("red", red);
        graph.fullscreen("fill", "fill.frag").out("color", "backbuffer");
        return graph;
    }
    // Renders two frames and returns the bytes of the picture.
    static std::vector<int> picture(render::Session& session) {
        for (int frame = 0; frame < 2; ++frame) {
            const Status done = draw_frame(session);
            EXPECT_TRUE(done) << to_text(done.errors());
        }
        EXPECT_TRUE(session.finish());
        const Result<vk::ReadbackData> read = session.read_output();
        EXPECT_TRUE(read) << to_text(read.errors());
        std::vector<int> bytes;
        if (read)
            for (const std::byte byte : read->bytes) bytes.push_back(std::to_integer<int>(byte));
        return bytes;
    }
    // Returns the picture that the shader computes.
    static std::vector<int> expected(int red) {
        std::vector<int> bytes;
        for (uint32_t y = 0; y < kFilled_px.height; ++y)
            for (uint32_t x = 0; x < kFilled_px.width; ++x)
                bytes.insert(bytes.end(), {red, static_cast<int>(x), static_cast<int>(y), 255});
        return bytes;
    }

    // Starts a session with the graph `fill(1)`.
    std::unique_ptr<render::Session> start() {
        put(fill(1));
        passes_ = registered_passes();
        render::SessionInput input;
        input.request.path = path_;
        input.request.size = kFilled_px;
        input.load.reader = files_.reader(read_text);
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.passes = &passes_;
        input.check_plan = true;
        const Result<scene::Scene> scene = scene::make_builtin("spheres");
        EXPECT_TRUE(scene);
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, *scene, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        if (!session) return nullptr;
        frame_of(**session) = {.camera = scene::framing_camera(*scene, 1)};
        return std::move(*session);
    }
    // Replaces the text of the graph.
    void put(const weft::GraphBuilder& graph) { files_.put(path_, graph.to_json()); }

    const std::string path_ =
        WEFT_SOURCE_DIR "/tests/render/builder/" + weft::GraphBuilder("fill").file_name();
    MemoryFiles files_;
};

TEST_F(BuiltGraphs, AreRenderedAndReplaced) {
    const std::unique_ptr<render::Session> session = start();
    ASSERT_TRUE(session);
    EXPECT_EQ(picture(*session), expected(255));

    weft::GraphBuilder faulty = fill(0);
    faulty.fullscreen("more", "none.frag").out("color", "backbuffer");
    put(faulty);
    const render::PrepareResult refused = session->prepare(session->selection());
    ASSERT_FALSE(refused.result);
    EXPECT_EQ(refused.result.errors().front().file, path_);
    EXPECT_EQ(refused.result.errors().front().source_line, "      \"shader\": \"none.frag\",");
    EXPECT_EQ(picture(*session), expected(255)) << "the old graph continues";

    put(fill(0.2));
    render::PrepareResult prepared = session->prepare(session->selection());
    ASSERT_TRUE(prepared.result) << to_text(prepared.result.errors());
    ASSERT_TRUE(session->swap_in(std::move(*prepared.result)));
    EXPECT_EQ(picture(*session), expected(51));
}

TEST_F(BuiltGraphs, AreReplacedByAReloader) {
    const std::unique_ptr<render::Session> session = start();
    ASSERT_TRUE(session);
    const Result<std::unique_ptr<render::Reloader>> reloader = render::Reloader::start(*session);
    ASSERT_TRUE(reloader) << to_text(reloader.errors());
    put(fill(0.2));
    (*reloader)->select(session->selection());
    std::optional<render::Reload> reload;
    while (!reload) {
        ASSERT_TRUE(draw_frame(*session));
        reload = (*reloader)->update();
    }
    EXPECT_TRUE(reload->good()) << to_text(reload->errors);
    EXPECT_TRUE(reload->warnings.empty()) << to_text(reload->warnings);
    EXPECT_EQ(picture(*session), expected(51));
}

}  // namespace
}  // namespace weft::test
