// Tests that the pictures of all views of a list have the same bytes, whether one pass draws them (with
// multiview or layer output) or one pass for each view.
#include <map>

#include "render/views/view_matrices.h"
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kFrameSize{32, 24, 1};
constexpr uint32_t kProgramViews = 3;

// The faces of a probe, seen directly, in a mirror and without culling; the cascades of the sun; the views of
// the program, which only layer output can draw by one pass, because their windings may differ.
std::string graph_with(const std::string& lowering, const std::string& own, const std::string& more = "") {
    const std::string how = "\"lowering\": \"" + lowering + "\", ";
    const std::string look =
        R"json("type": "raster", "draws": ["opaque", "masked"], "shader": "look", "state": { "cull": "material" })json";
    return R"json({ "version": 1,
  "imports": { "opaque": "drawlist", "masked": "drawlist", "mine": "views", "opaqueCommands": "buffer" },
  "views": { "probe": { "cube": { "at": [0.4, 1.3, 0.2], "near": 0.01 } }, "late": { "of": "sun", "first": 1 },
             "pond": { "of": "probe", "plane": [0, 1, 0, 0.25] } },
  "resources": {
    "cube": { "format": "rgba32f", "cube": 24 }, "cubePast": { "format": "rgba32f", "cube": 24 },
    "cubeDepth": { "format": "d32f_s8|d24_s8", "cube": 24 },
    "pond": { "format": "rgba32f", "size": 24, "layers": 8 }, "pondPast": { "format": "rgba32f", "size": 24, "layers": 8 },
    "pondDepth": { "format": "d32f", "size": 24, "layers": 6 },
    "shadow": { "format": "d16", "size": 40, "layers": 4 },
    "own": { "format": "rgba32f", "size": 16, "layers": "mineViews" }, "ownPast": { "format": "rgba32f", "size": 16, "layers": "mineViews" },
    "ownDepth": { "format": "d32f", "size": 16, "layers": "mineViews" },
    "roof": { "format": "rgba8", "cube": 24 },
    "told": { "format": "rgba32f", "cube": 24 }, "toldPast": { "format": "rgba32f", "cube": 24 }, "toldDepth": { "format": "d32f", "cube": 24 }
  }, "passes": {
    "cube": { "views": "probe", )json" +
           how +
           R"json("depth": "cubeDepth", "out": { "color": "cube", "past": "cubePast" },
              "type": "raster", "draws": ["opaque", "masked"], "shader": "look",
              "state": { "cull": "material", "stencil": { "pass": "replace", "reference": 3 } } },
    "sky": { "type": "fullscreen", "views": "probe", )json" +
           how + R"json("shader": "sight.frag", "depth": "cubeDepth", "out": { "color": "cube" },
             "state": { "depth": "none", "blend": "add", "stencil": { "compare": "not_equal", "reference": 3, "writeMask": 0 } } },
    "pond": { "views": "pond", )json" +
           how +
           R"json("frustum": false, "clear": [0.5, 0.25, 0, 0], "depth": { "ref": "pondDepth", "clear": 0.001 },
              "out": { "color": "pond.layer(2 + view)", "past": "pondPast.layer(view + 1)" }, )json" +
           look + R"json( },
    "shadow": { "type": "raster", "views": "late", )json" +
           how +
           R"json("draws": ["masked", "opaque"], "shader": "depth", "depth": { "ref": "shadow.layer(view)", "clear": 0.125 },
                "state": { "cull": "material", "depthBias": { "slope": 1 } } },
    "own": { "views": "mine", "lowering": ")json" +
           own + R"json(", "depth": "ownDepth", "out": { "color": "own", "past": "ownPast" }, )json" + look +
           R"json( },
    "roof": { "type": "raster", "views": "probe", )json" +
           how +
           R"json("draws": { "vertices": 3, "instances": 1 }, "shader": "roof", "out": { "color": "roof" },
              "state": { "cull": "back", "frontFace": "ccw" } },
    "told": { "type": "raster", "views": "probe", )json" +
           how +
           R"json("draws": { "list": "opaque", "indirect": "opaqueCommands" }, "shader": "look", "depth": "toldDepth",
              "out": { "color": "told", "past": "toldPast" }, "state": { "cull": "none" } })json" +
           more + " } }";
}

const std::vector<std::string> kObserved{
    "cube",    "cubePast", "cubeDepth", "pond.layer(2..7)", "shadow.layer(0..2)",  "own",
    "ownPast", "roof",     "told",      "toldPast",         "pondPast.layer(1..6)"};

struct Rendered {
    std::vector<vk::ReadbackData> readbacks;        // Of all frames.
    std::map<std::string, uint64_t> left_out;       // Number of draws, by the name of the pass in the graph.
    std::map<std::string, uint64_t> view_left_out;  // The same for each view: "cube#2".
    uint32_t passes = 0, barriers = 0;
};

class Lowerings : public SessionTest {
 protected:
    void SetUp() override {
        SessionTest::SetUp();
        Result<scene::Scene> scene = scene::make_builtin("spheres");
        ASSERT_TRUE(scene);
        scene_ = std::move(*scene);
        profile_ = &device_->profile();
    }
    std::unique_ptr<render::Session> open(const std::string& graph,
                                          std::vector<std::string> observed = kObserved) {
        passes_ = registered_passes();
        render::SessionInput input;
        input.adds_parts = false;
        input.request.path = WEFT_SOURCE_DIR "/tests/render/views/graph.json";
        input.request.size = kFrameSize;
        input.request.observed = std::move(observed);
        input.load.reader = [graph](const std::string& path) {
            return path.ends_with("graph.json") ? std::optional(graph) : read_text(path);
        };
        input.load.graph_root = WEFT_SOURCE_DIR "/graphs";
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.load.shader_cache = WEFT_TEST_CACHE;
        input.load.reads_disk = true;
        input.passes = &passes_;
        input.check_plan = true;
        input.views = {{"mine", kProgramViews}};
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, scene_, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        return session ? std::move(*session) : nullptr;
    }
    // The views of the program: two faces of a cube, which are mirror images, and the first of them in a
    // mirror, which is none. With each frame they move.
    [[nodiscard]] render::FrameInput input(int frame) const {
        render::FrameInput input{.camera = scene_.cameras.at(0)};
        input.camera.transform[3].x += 0.1f * static_cast<float>(frame);
        for (uint32_t i = 0; i < kProgramViews; ++i)
            input.views["mine"].push_back(render::cube_face({0.1 * frame, 1.5, 5.0 - i}, i + 3, 0.02));
        input.views["mine"][1].projection[0] *= -1.0f;
        return input;
    }
    // Counts the draws that a pass left out, also for each view: view 2 of a pass that draws several views is
    // that of the pass "name#2" otherwise.
    static void add_left_out(const vk::PassTiming& pass, Rendered& rendered) {
        const size_t mark = pass.pass.find('#');
        rendered.left_out[pass.pass.substr(0, mark)] += pass.draws_left_out;
        if (mark != std::string::npos) rendered.view_left_out[pass.pass] += pass.draws_left_out;
        for (size_t view = 0; view < pass.view_draws_left_out.size(); ++view)
            rendered.view_left_out[pass.pass + "#" + std::to_string(view)] += pass.view_draws_left_out[view];
    }
    Rendered render(const std::string& graph, bool culls = true) {
        const std::unique_ptr<render::Session> session = open(graph);
        if (!session) return {};
        const_cast<render::SessionParts&>(session->parts()).scene.gpu().set_culling(culls);
        for (int frame = 0; frame < 2; ++frame) {
            const Status done = session->render_frame(input(frame));
            EXPECT_TRUE(done) << to_text(done.errors());
        }
        EXPECT_TRUE(session->finish());
        Rendered rendered;
        rendered.readbacks = session->take_readbacks();
        for (const vk::FrameTiming& frame : session->take_timings())
            for (const vk::PassTiming& pass : frame.passes) add_left_out(pass, rendered);
        rendered.passes = static_cast<uint32_t>(session->plan().schedule.order.size());
        rendered.barriers = session->plan().barriers.emitted;
        return rendered;
    }
    // The plans may read back in different orders.
    static void expect_same(const Rendered& one, const Rendered& many, const std::string& what) {
        std::map<std::pair<uint64_t, std::string>, const std::vector<std::byte>*> others;
        for (const vk::ReadbackData& data : many.readbacks)
            others[{data.frame_index, data.pass}] = &data.bytes;
        ASSERT_EQ(one.readbacks.size(), 2 * kObserved.size()) << what;
        ASSERT_EQ(others.size(), one.readbacks.size()) << what;
        for (const vk::ReadbackData& data : one.readbacks) {
            EXPECT_TRUE(data.bytes == *others.at({data.frame_index, data.pass})) << what << ": " << data.pass;
            EXPECT_NE(data.bytes, std::vector<std::byte>(data.bytes.size()))
                << data.pass << " is empty, which proves nothing";
        }
    }
    [[nodiscard]] bool has_multiview() const { return profile_->max_multiview_views >= 6; }
    [[nodiscard]] bool has_layer_output() const { return profile_->max_output_layers > 1; }

    scene::Scene scene_;
    const DeviceProfile* profile_ = nullptr;
};

// Five passes draw six views each, and one pass draws three cascades of the sun.
constexpr uint32_t kSavedPasses = 5 * 5 + 2;

TEST_F(Lowerings, GiveTheSameBytesWithMultiview) {
    if (!has_multiview()) GTEST_SKIP() << "the device has no multiview that Weft can use";
    const Rendered many = render(graph_with("passes", "passes"));
    const Rendered one = render(graph_with("multiview", "passes"));
    expect_same(one, many, "multiview");
    EXPECT_EQ(many.passes, one.passes + kSavedPasses);
    EXPECT_LT(one.barriers, many.barriers);
    EXPECT_GT(many.left_out.at("cube"), 0u);
    EXPECT_EQ(one.left_out.at("cube"), 0u) << "no object is outside of all faces of a cube";
    expect_same(one, render(graph_with("multiview", "passes"), false), "without culling");
}

TEST_F(Lowerings, GiveTheSameBytesWithLayerOutput) {
    if (!has_layer_output()) GTEST_SKIP() << "the device lacks shaderOutputLayer";
    const Rendered many = render(graph_with("passes", "passes"));
    const Rendered one = render(graph_with("layerOutput", "layerOutput"));
    expect_same(one, many, "layerOutput");
    EXPECT_EQ(many.passes, one.passes + kSavedPasses + kProgramViews - 1);
    EXPECT_LT(one.barriers, many.barriers);
    EXPECT_GT(many.left_out.at("cube"), 0u);
    EXPECT_EQ(many.left_out.at("pond"), 0u) << "\"frustum\" is false";
    EXPECT_EQ(one.left_out, many.left_out) << "draws are left out for each view";
    EXPECT_EQ(one.view_left_out, many.view_left_out);
    expect_same(one, render(graph_with("layerOutput", "layerOutput"), false), "without culling");
}

TEST_F(Lowerings, AreChosenForTheDevice) {
    std::string graph = graph_with("?", "?");
    const std::string key = "\"lowering\": \"?\", ";
    for (size_t at = graph.find(key); at != std::string::npos; at = graph.find(key))
        graph.erase(at, key.size());
    const auto session = open(graph);
    ASSERT_TRUE(session);
    std::map<std::string, ViewLowering> chosen;
    for (const PassDecl& pass : session->plan().graph.passes)
        chosen[pass.name.substr(0, pass.name.find('#'))] = pass.lowering;
    const ViewLowering whole = has_multiview() ? ViewLowering::multiview : ViewLowering::none;
    EXPECT_EQ(chosen.at("cube"), has_layer_output() ? ViewLowering::layer_output : whole);
    EXPECT_EQ(chosen.at("own"), has_layer_output() ? ViewLowering::layer_output : ViewLowering::none);
    EXPECT_EQ(chosen.at("sky"), whole);
    EXPECT_EQ(chosen.at("pond"), whole);
}

// A pass at rest that draws all views is one unit: it runs if one of its views has changed.
TEST_F(Lowerings, AtRestRunWhenOneOfTheirViewsChanges) {
    if (!has_layer_output()) GTEST_SKIP() << "the device lacks shaderOutputLayer";
    std::string graph = graph_with("passes", "layerOutput");
    const auto insert = [&](const std::string& before, const std::string& text) {
        ASSERT_NE(graph.find(before), std::string::npos) << before;
        graph.insert(graph.find(before) + before.size(), text);
    };
    for (const char* image : {"own", "ownPast", "ownDepth"})
        insert(std::string("\"") + image + "\": { ", "\"keep\": true, ");
    insert("\"own\": { \"views\": \"mine\", ", "\"rest\": true, \"clear\": 0, ");
    graph.replace(graph.find("\"depth\": \"ownDepth\""), 19,
                  "\"depth\": { \"ref\": \"ownDepth\", \"clear\": 0 }");
    const auto session = open(graph);
    ASSERT_TRUE(session);
    const std::vector<glm::vec3> moves{{0, 0, 0}, {0, 0, 0}, {0, 0.5f, 0}, {0, 0.5f, 0}, {0, 0.5f, 0}};
    for (const glm::vec3& move : moves) {
        render::FrameInput frame = input(0);
        frame.camera.transform[3].x += 0.1f;
        frame.views["mine"].back().view[3] += glm::vec4(move, 0);
        const Status done = session->render_frame(frame);
        ASSERT_TRUE(done) << to_text(done.errors());
    }
    ASSERT_TRUE(session->finish());
    std::string own;
    for (const vk::FrameTiming& timing : session->take_timings())
        for (const vk::PassTiming& pass : timing.passes)
            if (pass.pass == "own") own += pass.rested ? '-' : 'r';
    // The previous matrix of a view is one of its constants, so a change wakes the pass twice.
    EXPECT_EQ(own, "r-rr-");
}

}  // namespace
}  // namespace weft::test
