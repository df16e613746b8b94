// Tests that draws outside of the frustum are left out, and that this changes no byte of any picture.
#include <cstdlib>
#include <random>

#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kSize{40, 30, 1};

struct Pictures {
    std::vector<std::byte> output;
    std::vector<vk::ReadbackData> readbacks;
    uint64_t left_out = 0;
};

class Culling : public SessionTest {
 protected:
    void SetUp() override {
        SessionTest::SetUp();
        Result<scene::Scene> scene = scene::make_builtin("spheres");
        ASSERT_TRUE(scene);
        scene_ = std::move(*scene);
    }
    // Renders a frame for each camera.
    Pictures draw(const std::string& graph, const std::vector<scene::Camera>& cameras, bool culls,
                  std::vector<std::string> observed = {}, const FileReader& reader = read_text) {
        const std::unique_ptr<render::Session> session =
            start(scene_, cameras.front(), graph, kSize, std::move(observed), 0, reader);
        if (!session) return {};
        const_cast<render::SessionParts&>(session->parts()).scene.gpu().set_culling(culls);
        for (const scene::Camera& camera : cameras) {
            const Status done = session->render_frame({.camera = camera});
            EXPECT_TRUE(done) << to_text(done.errors());
        }
        EXPECT_TRUE(session->finish());
        Pictures pictures;
        if (session->has_output()) {
            Result<vk::ReadbackData> output = session->read_output();
            EXPECT_TRUE(output);
            if (output) pictures.output = std::move(output->bytes);
        }
        pictures.readbacks = session->take_readbacks();
        for (const vk::FrameTiming& frame : session->take_timings())
            for (const vk::PassTiming& pass : frame.passes) pictures.left_out += pass.draws_left_out;
        return pictures;
    }
    // Returns cameras at random places that look at random points of the scene, or past it.
    std::vector<scene::Camera> cameras(uint32_t seed, int count) const {
        std::mt19937 random(seed);
        const auto point = [&] {
            glm::vec3 p;
            for (int axis = 0; axis < 3; ++axis) {
                const float size = scene_.bounds.max[axis] - scene_.bounds.min[axis];
                p[axis] = scene_.bounds.min[axis] +
                          size * std::uniform_real_distribution<float>(-0.1f, 1.1f)(random);
            }
            return p;
        };
        std::vector<scene::Camera> made;
        for (int i = 0; i < count; ++i) {
            scene::Camera camera = scene_.cameras.at(0);
            const glm::vec3 at = point(), back = glm::normalize(at - point());
            const glm::vec3 side = glm::normalize(glm::cross(glm::vec3(0, 1, 0.01f), back));
            camera.transform = {glm::vec4(side, 0), glm::vec4(glm::cross(back, side), 0), glm::vec4(back, 0),
                                glm::vec4(at, 1)};
            camera.fov_y_rad = 0.5f;
            made.push_back(camera);
        }
        return made;
    }
    static void expect_same(const Pictures& culled, const Pictures& whole, const std::string& what) {
        EXPECT_TRUE(culled.output == whole.output) << what;
        ASSERT_EQ(culled.readbacks.size(), whole.readbacks.size()) << what;
        for (size_t i = 0; i < whole.readbacks.size(); ++i)
            EXPECT_TRUE(culled.readbacks[i].bytes == whole.readbacks[i].bytes)
                << what << ": " << whole.readbacks[i].pass;
        EXPECT_EQ(whole.left_out, 0u) << what;
    }

    scene::Scene scene_;
};

TEST_F(Culling, ChangesNoShippedPicture) {
    uint64_t left_out = 0;
    const bool extended = std::getenv("WEFT_EXTENDED") != nullptr;
    // All shipped graphs that draw the scene; the extended test draws the others too, which are based on
    // these.
    std::vector<std::string> graphs{"deferred", "forward", "forward_plus"};
    if (extended)
        graphs.insert(graphs.end(),
                      {"bloom", "dof", "edges", "light_indexed", "light_volumes", "taa", "tiled_deferred"});
    for (const std::string& name : graphs) {
        const std::vector<scene::Camera> path = cameras(17, extended ? 12 : 3);
        const Pictures culled = draw(graph_path(name), path, true),
                       whole = draw(graph_path(name), path, false);
        expect_same(culled, whole, name);
        left_out += culled.left_out;
    }
    EXPECT_GT(left_out, 10u);
}

// Returns a graph with one raster pass "a", which draws a picture of 40 x 30 px or the faces of a cube.
std::string graph_of(const std::string& keys, bool cube = false) {
    const std::string size = cube ? "\"cube\": 16" : "\"size\": [40, 30]";
    return R"json({ "version": 1, "imports": { "opaque": "drawlist" },
      "views": { "mirror": { "of": "camera", "plane": [0, 1, 0, 0.1] }, "probe": { "cube": { "at": [0.5, 1.5, 0.5] } } },
      "resources": { "color": { "format": "rgba32f", )json" +
           size + R"json( }, "past": { "format": "rgba32f", )json" + size +
           R"json( }, "depth": { "format": "d32f", )json" + size +
           R"json( } },
      "passes": { "a": { "type": "raster", "draws": ["opaque"], "depth": "depth", )json" +
           keys + " } } }";
}

FileReader reader_of(const std::string& graph) {
    return [graph](const std::string& path) {
        return path.ends_with("views/graph.json") ? std::optional(graph) : read_text(path);
    };
}

constexpr const char* kLook = R"json("shader": "look", "out": { "color": "color", "past": "past" })json";

TEST_F(Culling, ChangesNoPictureOfAnyView) {
    const std::string path = WEFT_SOURCE_DIR "/tests/render/views/graph.json";
    const std::vector<scene::Camera> walk = cameras(18, 3);
    const std::string look = kLook;
    const std::vector<std::string> graphs{
        graph_of(look), graph_of(look + R"json(, "view": "mirror", "state": { "cull": "material" })json"),
        graph_of(look + R"json(, "views": "probe")json", true),
        graph_of(look + R"json(, "state": { "depthClamp": true, "cull": "none" })json"),
        graph_of(look + R"json(, "views": "probe", "into": "rects")json")};
    for (const std::string& graph : graphs) {
        const Pictures culled = draw(path, walk, true, {"color", "depth"}, reader_of(graph));
        const Pictures whole = draw(path, walk, false, {"color", "depth"}, reader_of(graph));
        expect_same(culled, whole, graph);
        EXPECT_GT(culled.left_out, 0u) << graph;
        if (HasFailure()) return;
    }
}

TEST_F(Culling, LeavesOutNothingThatTheShaderMayMove) {
    const std::string path = WEFT_SOURCE_DIR "/tests/render/views/graph.json";
    const std::vector<scene::Camera> walk = cameras(18, 1);
    for (const std::string& keys : {std::string(R"json("shader": "fixed", "out": ["color"])json"),
                                    std::string(kLook) + R"json(, "frustum": false)json"})
        EXPECT_EQ(draw(path, walk, true, {"color"}, reader_of(graph_of(keys))).left_out, 0u) << keys;
}

}  // namespace
}  // namespace weft::test
