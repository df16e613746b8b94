// Tests views whose constants a pass has written to a buffer. The buffer gets copies of views that the CPU
// knows. So the pictures of the copies must have the same bytes as the pictures of the originals.
#include "render/views/view_matrices.h"
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kPictureSize_px{40, 30, 1};
constexpr uint32_t kPortalViews = 3;

using Readbacks = std::map<std::string, vk::ReadbackData>;

class BufferViews : public SessionTest {
 protected:
    void SetUp() override {}
    // `graph` is the text of the graph without its first keys.
    std::unique_ptr<render::Session> open(const std::string& graph, std::vector<std::string> observed,
                                          uint32_t queues = 1) {
        queues_ = queues;
        make_device(true);
        Result<scene::Scene> scene = scene::make_builtin("spheres");
        EXPECT_TRUE(scene);
        if (!scene || !device_) return nullptr;
        scene_ = std::move(*scene);
        passes_ = registered_passes();
        render::SessionInput input;
        input.adds_parts = false;
        input.request.path = WEFT_SOURCE_DIR "/tests/render/views/graph.json";
        input.request.size = kPictureSize_px;
        input.request.observed = std::move(observed);
        input.load.reader = [text = "{ \"version\": 1, " + graph + "}"](const std::string& path) {
            return path.ends_with("graph.json") ? std::optional(text) : read_text(path);
        };
        input.load.graph_root = WEFT_SOURCE_DIR "/graphs";
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.load.shader_cache = WEFT_TEST_CACHE;
        input.load.reads_disk = true;
        input.passes = &passes_;
        input.check_plan = true;
        input.queues = queues;
        input.views = {{"mine", kPortalViews}};
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, scene_, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        return session ? std::move(*session) : nullptr;
    }
    // The camera and the views of the program move with `step`.
    void draw(render::Session& session, int step) {
        render::FrameInput frame{.camera = scene_.cameras.at(0)};
        frame.camera.transform[3].x += 0.1f * static_cast<float>(step);
        for (uint32_t i = 0; i < kPortalViews; ++i) {
            frame.views["mine"].push_back(render::cube_face({0.1 * step, 1.5, 4.0 - i}, 4 + i % 2, 0.02));
            // Without this factor, the view would be a mirror image, and a view in a buffer never is.
            for (int column = 0; column < 4; ++column) frame.views["mine"].back().projection[column].x *= -1;
        }
        const Status done = session.render_frame(frame);
        EXPECT_TRUE(done) << to_text(done.errors());
    }
    // Returns the readbacks of each frame by the name of the resource.
    static std::vector<Readbacks> read(render::Session& session, size_t frames) {
        EXPECT_TRUE(session.finish());
        std::vector<Readbacks> read(frames);
        for (vk::ReadbackData& data : session.take_readbacks())
            if (data.frame_index < frames)
                read[data.frame_index][data.pass.substr(std::string("observe:").size())] = std::move(data);
        return read;
    }
    static void expect_same(const Readbacks& a, const std::string& name_a, const Readbacks& b,
                            const std::string& name_b) {
        EXPECT_GT(a.at(name_a).bytes.size(), 0u);
        EXPECT_TRUE(a.at(name_a).bytes == b.at(name_b).bytes) << name_a << " and " << name_b;
    }
    // Expects that the picture shows something: the colour `look` writes to a pixel is the position in the
    // world, and 1 or 2.
    static void expect_drawn(const vk::ReadbackData& picture) {
        size_t drawn = 0;
        for (const glm::vec4& texel : render::decode_texels(picture.format, picture.bytes))
            drawn += texel.a > 0 ? 1 : 0;
        EXPECT_GT(drawn, 20u) << picture.pass;
    }

    scene::Scene scene_;
};

constexpr const char* kDrawLook =
    R"json("type": "raster", "draws": ["opaque"], "shader": "look", "state": { "cull": "material" })json";

std::string camera_graph() {
    return std::string(R"json("imports": { "opaque": "drawlist" },
      "views": { "copies": { "buffer": "matrices", "count": 4 } },
      "resources": { "matrices": { "buffer": "ViewConstants", "count": 4 }, "depth": "d32f",
                     "color": "rgba32f", "past": "rgba32f", "copyDepth": "d32f", "copyColor": "rgba32f", "copyPast": "rgba32f" },
      "passes": {
        "copy": { "type": "compute", "queue": "async", "shader": "copy_view.comp", "threads": 1,
                  "out": { "matrices": "matrices.range(3)" } },
        "direct": { "depth": "depth", "out": ["color", "past"], )json") +
           kDrawLook + R"json( },
        "copied": { "view": "copies(3)", "depth": "copyDepth", "out": { "color": "copyColor", "past": "copyPast" }, )json" +
           kDrawLook + " } }";
}

TEST_F(BufferViews, OfTheCameraGiveThePictureOfTheCamera) {
    for (const uint32_t queues : {1u, 3u}) {
        const auto session =
            open(camera_graph(), {"color", "past", "depth", "copyColor", "copyPast", "copyDepth"}, queues);
        ASSERT_TRUE(session);
        for (int step = 0; step < 3; ++step) draw(*session, step);
        const std::vector<Readbacks> frames = read(*session, 3);
        for (const Readbacks& frame : frames) {
            expect_drawn(frame.at("color"));
            expect_same(frame, "color", frame, "copyColor");
            expect_same(frame, "past", frame, "copyPast");
            expect_same(frame, "depth", frame, "copyDepth");
        }
        EXPECT_FALSE(frames[0].at("color").bytes == frames[1].at("color").bytes);
        TearDown();  // Reports the messages of this device.
    }
}

std::string lists_graph() {
    const auto images = [](const std::string& prefix, const std::string& shape) {
        return "\"" + prefix + "Depth\": { \"format\": \"d32f\", " + shape + " }, \"" + prefix +
               "Color\": { \"format\": \"rgba32f\", " + shape + " }, \"" + prefix +
               "Past\": { \"format\": \"rgba32f\", " + shape + " }";
    };
    const auto pass = [](const std::string& prefix, const std::string& views) {
        return "\"" + prefix + "\": { " + views + ", \"depth\": \"" + prefix +
               "Depth\", \"out\": { \"color\": \"" + prefix + "Color\", \"past\": \"" + prefix +
               "Past\" }, " + kDrawLook + " }";
    };
    const std::string layers = "\"size\": 24, \"layers\": 3", atlas = "\"size\": [48, 40]";
    return R"json("imports": { "opaque": "drawlist", "mine": "views" },
      "views": { "copies": { "buffer": "matrices", "count": "mineViews", "rect": ["view * 16", 4, 16, 20] },
                 "rects": { "of": "mine", "rect": ["view * 16", 4, 16, 20] } },
      "resources": { "matrices": { "buffer": "ViewConstants", "count": "mineViews" }, )json" +
           images("layered", layers) + ", " + images("copiedLayered", layers) + ", " +
           images("atlas", atlas) + ", " + images("copiedAtlas", atlas) + R"json( },
      "passes": {
        "copy": { "type": "compute", "queue": "async", "shader": "copy_view.comp", "repeat": { "i": "0..mineViews-1" },
                  "view": "mine(i)", "threads": 1, "out": { "matrices": "matrices.range(i)" } }, )json" +
           pass("layered", "\"views\": \"mine\"") + ", " + pass("copiedLayered", "\"views\": \"copies\"") +
           ", " + pass("atlas", "\"views\": \"rects\", \"into\": \"rects\"") + ", " +
           pass("copiedAtlas", "\"views\": \"copies\", \"into\": \"rects\"") + " }";
}

TEST_F(BufferViews, OfAListGiveThePicturesOfTheList) {
    for (const uint32_t queues : {1u, 3u}) {
        const auto session = open(lists_graph(),
                                  {"layeredColor", "layeredPast", "copiedLayeredColor", "copiedLayeredPast",
                                   "atlasColor", "atlasPast", "copiedAtlasColor", "copiedAtlasPast"},
                                  queues);
        ASSERT_TRUE(session);
        for (int step = 0; step < 2; ++step) draw(*session, step);
        for (const Readbacks& frame : read(*session, 2)) {
            expect_drawn(frame.at("layeredColor"));
            expect_same(frame, "layeredColor", frame, "copiedLayeredColor");
            expect_same(frame, "layeredPast", frame, "copiedLayeredPast");
            expect_drawn(frame.at("atlasColor"));
            expect_same(frame, "atlasColor", frame, "copiedAtlasColor");
            expect_same(frame, "atlasPast", frame, "copiedAtlasPast");
        }
        TearDown();
    }
}

// The buffer is a ring of two copies, which change their roles in every frame.
TEST_F(BufferViews, OfTheLastFrameGiveItsPicture) {
    const std::string graph = std::string(R"json("imports": { "opaque": "drawlist" },
      "views": { "old": { "buffer": "matrices[-1]", "count": 1 } },
      "resources": { "matrices": { "buffer": "ViewConstants", "count": 1, "history": 1 }, "depth": "d32f",
                     "color": "rgba32f", "past": "rgba32f", "oldDepth": "d32f", "oldColor": "rgba32f", "oldPast": "rgba32f" },
      "passes": {
        "copy": { "type": "compute", "shader": "copy_view.comp", "threads": 1, "out": ["matrices"] },
        "direct": { "depth": "depth", "out": ["color", "past"], )json") +
                              kDrawLook + R"json( },
        "late": { "view": "old", "depth": "oldDepth", "out": { "color": "oldColor", "past": "oldPast" }, )json" +
                              kDrawLook + " } }";
    const auto session = open(graph, {"color", "past", "oldColor", "oldPast"});
    ASSERT_TRUE(session);
    for (int step = 0; step < 4; ++step) draw(*session, step * step);
    const std::vector<Readbacks> frames = read(*session, 4);
    for (size_t frame = 1; frame < 4; ++frame) {
        expect_drawn(frames[frame].at("oldColor"));
        expect_same(frames[frame], "oldColor", frames[frame - 1], "color");
        expect_same(frames[frame], "oldPast", frames[frame - 1], "past");
        EXPECT_FALSE(frames[frame].at("oldColor").bytes == frames[frame].at("color").bytes);
    }
}

// Returns a graph with two resting passes: "copy" writes a view to the buffer, and "draw" draws it.
std::string resting_graph(const std::string& view) {
    return std::string(R"json("imports": { "opaque": "drawlist" },
      "views": { "copies": { "buffer": "matrices", "count": 1 }, "probe": { "cube": { "at": [0.4, 1.3, 0.2] } } },
      "resources": { "matrices": { "buffer": "ViewConstants", "count": 1, "keep": true }, "depth": "d32f",
                     "color": { "format": "rgba32f", "keep": true }, "past": { "format": "rgba32f", "keep": true } },
      "passes": {
        "copy": { "type": "compute", "rest": true, "view": ")json") +
           view + R"json(", "shader": "copy_view.comp", "threads": 1, "out": ["matrices"] },
        "draw": { "rest": true, "view": "copies", "clear": 0, "out": ["color", "past"],
                  "depth": { "ref": "depth", "clear": 0 }, )json" +
           kDrawLook + " } }";
}

// Returns, for each frame, the first letters of the resting passes that ran.
std::vector<std::string> runs(render::Session& session) {
    EXPECT_TRUE(session.finish());
    std::vector<std::string> frames;
    for (const vk::FrameTiming& timing : session.take_timings()) {
        frames.emplace_back();
        for (const vk::PassTiming& pass : timing.passes)
            if ((pass.pass == "copy" || pass.pass == "draw") && !pass.rested)
                frames.back() += pass.pass.front();
    }
    return frames;
}

TEST_F(BufferViews, WakeThePassesThatDrawThem) {
    const auto session = open(resting_graph("camera"), {"color"});
    ASSERT_TRUE(session);
    // The previous matrix is a constant of the view, so it changes in the frame after a movement, too.
    for (const int step : {0, 0, 1, 1, 1}) draw(*session, step);
    EXPECT_EQ(runs(*session), (std::vector<std::string>{"cd", "", "cd", "cd", ""}));
}

TEST_F(BufferViews, DoNotWakeThePassesWhenOnlyTheCameraMoves) {
    const auto session = open(resting_graph("probe(0)"), {"color"});
    ASSERT_TRUE(session);
    for (const int step : {0, 1, 2}) draw(*session, step);
    EXPECT_EQ(runs(*session), (std::vector<std::string>{"cd", "", ""}));
}

}  // namespace
}  // namespace weft::test
