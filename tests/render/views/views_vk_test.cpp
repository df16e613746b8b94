// Tests passes that draw all views of a list: an atlas with the shadow maps of eight lamps, the six faces of
// a probe, and the camera in a mirror. Each picture must have the same bytes as those of passes with one view
// each, and the world positions in the pictures must lie on the rays that are computed here from the
// definition of the views.
#include <algorithm>
#include <cmath>

#include "render/views/view_matrices.h"
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kSize{48, 40, 1};
constexpr uint32_t kCubeSide_px = 24;
constexpr uint32_t kOwnViews = 3;
const glm::vec3 kProbe{0.4f, 1.3f, 0.2f};
constexpr float kMirrorHeight_m = -0.25f;

constexpr const char* kFrame = R"json("version": 1,
  "imports": { "opaque": "drawlist", "lampFaces": "views", "mine": "views" },
  "consts": { "level": -0.25 },
  "views": { "mirror": { "of": "camera", "plane": [0, 1, 0, "0 - level"] },
             "probe": { "cube": { "at": [0.4, 1.3, 0.2], "near": 0.01 } },
             "lamps": { "of": "lampFaces", "count": 8 } },
  "resources": {
    "atlas": { "format": "d32f", "size": [100, 77] },
    "cubeDepth": { "format": "d32f", "cube": 24 },
    "cube": { "format": "rgba32f", "cube": 24 }, "cubePast": { "format": "rgba32f", "cube": 24 },
    "seenDepth": "d32f", "seen": "rgba32f", "seenPast": "rgba32f",
    "mineDepth": { "format": "d32f", "size": 16, "layers": "mineViews" },
    "mineColor": { "format": "rgba32f", "size": 16, "layers": "mineViews" },
    "minePast": { "format": "rgba32f", "size": 16, "layers": "mineViews" }
  }, )json";

const std::string kLook =
    R"json("type": "raster", "draws": ["opaque"], "shader": "look", "state": { "cull": "material" })json";

std::string united() {
    return std::string("{") + kFrame + R"json("passes": {
    "atlas": { "type": "raster", "views": "lamps", "into": "rects", "draws": ["opaque"], "shader": "depth",
               "depth": { "ref": "atlas", "clear": 0.125 }, "state": { "cull": "material", "depthBias": { "slope": 1 } } },
    "cube": { "views": "probe", "depth": "cubeDepth", "out": { "color": "cube", "past": "cubePast" }, )json" +
           kLook + R"json(},
    "mirror": { "view": "mirror", "depth": "seenDepth", "out": { "color": "seen", "past": "seenPast" }, )json" +
           kLook + R"json(},
    "mine": { "views": "mine", "into": "layers", "depth": "mineDepth",
              "out": { "color": "mineColor", "past": "minePast" }, )json" +
           kLook + "} } }";
}

// Returns the same graph with one pass for each view, in which all numbers are written out.
std::string separate() {
    std::string text = std::string("{") + kFrame + "\"passes\": {";
    for (int i = 0; i < 8; ++i) {
        const std::string n = std::to_string(i);
        const std::string rect =
            "[" + std::to_string(i % 3 * 33) + ", " + std::to_string(i / 3 * 25) + ", 33, 25]";
        text +=
            "\"atlas" + n + "\": { \"type\": \"raster\", \"view\": \"lampFaces(" + n +
            ")\", \"draws\": [\"opaque\"], \"shader\": \"depth\", \"partial\": true, " +
            (i == 0 ? "\"depth\": { \"ref\": \"atlas\", \"clear\": 0.125 }"
                    : "\"depth\": \"atlas\", \"after\": [\"atlas" + std::to_string(i - 1) + "\"]") +
            ", \"state\": { \"cull\": \"material\", \"depthBias\": { \"slope\": 1 }, \"viewport\": " + rect +
            ", \"scissor\": " + rect + " } }, ";
    }
    const auto layered = [&](const std::string& name, const std::string& image, const std::string& color,
                             const std::string& view, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) {
            const std::string n = std::to_string(i), layer = ".layer(" + n + ")";
            text += "\"" + name + n + "\": { \"view\": \"" + view + "(" + n + ")\", \"depth\": \"" + image +
                    "Depth" + layer + "\", \"out\": { \"color\": \"" + color + layer + "\", \"past\": \"" +
                    image + "Past" + layer + "\" }, " + kLook + " }, ";
        }
    };
    layered("cube", "cube", "cube", "probe", 6);
    layered("mine", "mine", "mineColor", "mine", kOwnViews);
    return text +
           "\"mirror\": { \"view\": \"mirror(0)\", \"depth\": \"seenDepth\", \"out\": "
           "{ \"color\": \"seen\", \"past\": \"seenPast\" }, " +
           kLook + " } } }";
}

scene::Light spot(const glm::vec3& at, const glm::vec3& to) {
    scene::Light light;
    light.type = scene::LightType::spot;
    light.position = at;
    light.direction = glm::normalize(to - at);
    light.outer_cone_rad = 0.6f;
    return light;
}

class Views : public SessionTest {
 protected:
    void SetUp() override {
        SessionTest::SetUp();
        Result<scene::Scene> scene = scene::make_builtin("spheres");
        ASSERT_TRUE(scene);
        scene_ = std::move(*scene);
        scene_.lights.clear();
        const glm::vec3 center = (scene_.bounds.min + scene_.bounds.max) * 0.5f;
        for (int i = 0; i < 8; ++i) {
            const float angle = 0.785f * static_cast<float>(i);
            scene_.lights.push_back(
                spot(center + glm::vec3(4 * std::cos(angle), 3, 4 * std::sin(angle)), center));
        }
        camera_ = scene_.cameras.at(0);
    }
    std::unique_ptr<render::Session> open(const std::string& graph,
                                          const std::map<std::string, uint32_t, std::less<>>& views = {
                                              {"mine", kOwnViews}}) {
        passes_ = registered_passes();
        render::SessionInput input;
        input.adds_parts = false;
        input.request.path = WEFT_SOURCE_DIR "/tests/render/views/graph.json";
        input.request.size = kSize;
        input.request.observed = {"atlas", "cube", "cubePast", "seen", "seenPast", "mineColor", "minePast"};
        input.load.reader = [graph](const std::string& path) {
            return path.ends_with("graph.json") ? std::optional(graph) : read_text(path);
        };
        input.load.graph_root = WEFT_SOURCE_DIR "/graphs";
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.load.shader_cache = WEFT_TEST_CACHE;
        input.load.reads_disk = true;
        input.passes = &passes_;
        input.check_plan = true;
        input.views = views;
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, scene_, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        return session ? std::move(*session) : nullptr;
    }
    // The input of a frame: with each frame, the camera and the views of the program move.
    [[nodiscard]] render::FrameInput input(int frame) const {
        render::FrameInput input{.camera = camera_};
        input.camera.transform[3].x += 0.1f * static_cast<float>(frame);
        for (uint32_t i = 0; i < kOwnViews; ++i)
            input.views["mine"].push_back(render::cube_face({0.1 * frame, 1.5, 5.0 - i}, i + 3, 0.02));
        return input;
    }
    // Renders two frames, and returns the readbacks of the second by the name of the resource.
    std::map<std::string, vk::ReadbackData> second_frame(render::Session& session) {
        std::map<std::string, vk::ReadbackData> by_name;
        for (int frame = 0; frame < 2; ++frame) {
            const Status done = session.render_frame(input(frame));
            EXPECT_TRUE(done) << to_text(done.errors());
            if (!done) return {};
        }
        EXPECT_TRUE(session.finish());
        for (vk::ReadbackData& data : session.take_readbacks()) by_name[data.pass] = std::move(data);
        return by_name;
    }

    scene::Scene scene_;
    scene::Camera camera_;
};

// Returns the direction of a texel of a cube map, from the table "Cube map face and coordinate selection" of
// Vulkan.
glm::vec3 cube_direction(uint32_t face, float s, float t) {
    switch (face) {
        case 0:
            return {1, -t, -s};
        case 1:
            return {-1, -t, s};
        case 2:
            return {s, 1, t};
        case 3:
            return {s, -1, -t};
        case 4:
            return {s, -t, 1};
        default:
            return {-s, -t, -1};
    }
}

// Returns the centre of a texel, in clip space.
glm::vec2 center_of(uint32_t x, uint32_t y, uint32_t width, uint32_t height) {
    return {(static_cast<float>(x) + 0.5f) / static_cast<float>(width) * 2 - 1,
            (static_cast<float>(y) + 0.5f) / static_cast<float>(height) * 2 - 1};
}

void expect_on_ray(const glm::vec4& pixel, const glm::vec3& from, const glm::vec3& direction,
                   const char* what) {
    EXPECT_EQ(pixel.a, 1) << what << ": back face";
    EXPECT_GT(glm::dot(glm::normalize(glm::vec3(pixel) - from), glm::normalize(direction)), 0.99999f) << what;
}

glm::vec3 mirrored_point(const glm::vec3& p) {
    return {p.x, 2 * kMirrorHeight_m - p.y, p.z};
}

// Returns the position of a point in clip space, for a camera that only moves and does not turn its axes.
glm::vec2 project(const scene::Camera& camera, float aspect, const glm::vec3& p) {
    const glm::vec3 way = p - glm::vec3(camera.transform[3]);
    const glm::vec3 axes{glm::dot(way, glm::vec3(camera.transform[0])),
                         glm::dot(way, glm::vec3(camera.transform[1])),
                         -glm::dot(way, glm::vec3(camera.transform[2]))};
    const float tan_y = std::tan(camera.fov_y_rad * 0.5f);
    return {axes.x / (axes.z * tan_y * aspect), -axes.y / (axes.z * tan_y)};
}

TEST_F(Views, OfOnePassAreTheSameBytesAsThoseOfSeparatePasses) {
    const auto one = open(united()), many = open(separate());
    ASSERT_TRUE(one && many);
    const auto together = second_frame(*one), alone = second_frame(*many);
    ASSERT_EQ(together.size(), 7u);
    ASSERT_EQ(alone.size(), 7u);
    for (const auto& [name, data] : together) {
        EXPECT_TRUE(data.bytes == alone.at(name).bytes) << name;
        EXPECT_NE(data.bytes, std::vector<std::byte>(data.bytes.size()))
            << name << " is empty, which proves nothing";
    }
    uint32_t begun = 0;
    for (const PassStep& step : one->plan().barriers.steps)
        if (one->plan().graph.passes[step.pass].name.starts_with("atlas#"))
            begun += step.merges_render_pass ? 0 : 1;
    EXPECT_EQ(begun, 1u) << "the views of an atlas share a rendering scope";
}

TEST_F(Views, OfACubeShowWhatASamplerReadsInEachDirection) {
    const auto session = open(united());
    ASSERT_TRUE(session);
    const auto read = second_frame(*session);
    const std::vector<glm::vec4> texels =
        render::decode_texels(Format::rgba32f, read.at("observe:cube").bytes);
    const std::vector<glm::vec4> past =
        render::decode_texels(Format::rgba32f, read.at("observe:cubePast").bytes);
    ASSERT_EQ(texels.size(), size_t{6} * kCubeSide_px * kCubeSide_px);
    size_t drawn = 0;
    for (uint32_t i = 0; i < texels.size(); ++i) {
        if (texels[i].a == 0) continue;
        ++drawn;
        const uint32_t face = i / (kCubeSide_px * kCubeSide_px);
        const glm::vec2 at =
            center_of(i % kCubeSide_px, i / kCubeSide_px % kCubeSide_px, kCubeSide_px, kCubeSide_px);
        expect_on_ray(texels[i], kProbe, cube_direction(face, at.x, at.y), "cube");
        EXPECT_EQ(past[i].z, kCubeSide_px);
        EXPECT_LT(glm::distance(glm::vec2(past[i]), at), 1e-3f) << "a probe does not move";
        if (HasFailure()) return;
    }
    EXPECT_GT(drawn, texels.size() / 8);
}

TEST_F(Views, InAMirrorShowWhatTheCameraSeesInIt) {
    const auto session = open(united());
    ASSERT_TRUE(session);
    const auto read = second_frame(*session);
    const std::vector<glm::vec4> texels =
        render::decode_texels(Format::rgba32f, read.at("observe:seen").bytes);
    const std::vector<glm::vec4> past =
        render::decode_texels(Format::rgba32f, read.at("observe:seenPast").bytes);
    const float aspect = static_cast<float>(kSize.width) / static_cast<float>(kSize.height);
    const scene::Camera now = input(1).camera, before = input(0).camera;
    size_t drawn = 0;
    for (uint32_t i = 0; i < texels.size(); ++i) {
        if (texels[i].a == 0) continue;
        ++drawn;
        EXPECT_EQ(texels[i].a, 1) << "back face";
        const glm::vec3 image = mirrored_point(glm::vec3(texels[i]));
        const glm::vec2 at = center_of(i % kSize.width, i / kSize.width, kSize.width, kSize.height);
        EXPECT_LT(glm::distance(project(now, aspect, image), at), 1e-3f);
        EXPECT_LT(glm::distance(glm::vec2(past[i]), project(before, aspect, image)), 1e-3f);
        EXPECT_EQ(past[i].w, kSize.height);
        if (HasFailure()) return;
    }
    EXPECT_GT(drawn, texels.size() / 8);
}

TEST_F(Views, OfTheProgramHaveTheMatricesOfTheFrameAndOfTheOneBefore) {
    const auto session = open(united());
    ASSERT_TRUE(session);
    const auto read = second_frame(*session);
    const std::vector<glm::vec4> texels =
        render::decode_texels(Format::rgba32f, read.at("observe:mineColor").bytes);
    const std::vector<glm::vec4> past =
        render::decode_texels(Format::rgba32f, read.at("observe:minePast").bytes);
    size_t drawn = 0, compared = 0;
    for (uint32_t i = 0; i < texels.size(); ++i) {
        if (texels[i].a == 0) continue;
        ++drawn;
        const uint32_t view = i / 256;
        const glm::vec2 at = center_of(i % 16, i / 16 % 16, 16, 16);
        expect_on_ray(texels[i], {0.1, 1.5, 5.0f - static_cast<float>(view)},
                      cube_direction(view + 3, at.x, at.y), "mine");
        const render::ViewInput before = input(0).views.at("mine")[view];
        const glm::vec4 clip = before.projection * before.view * glm::vec4(glm::vec3(texels[i]), 1);
        if (clip.w < 0.1f) continue;  // Next to the eye, the position in the picture has no exact value.
        const glm::vec2 expected = glm::vec2(clip) / clip.w;
        ++compared;
        EXPECT_LT(glm::distance(glm::vec2(past[i]), expected), 1e-3f * std::max(1.0f, glm::length(expected)));
        if (HasFailure()) return;
    }
    EXPECT_GT(drawn, 16u);
    EXPECT_GT(compared, drawn / 4);
}

TEST_F(Views, OfTheFirstFrameWereTheSameBefore) {
    const auto session = open(united());
    ASSERT_TRUE(session);
    ASSERT_TRUE(session->render_frame(input(0)));
    ASSERT_TRUE(session->finish());
    for (const render::FrameView& view : session->parts().frames.views().views())
        EXPECT_EQ(view.constants.prev_view_projection, view.constants.steady_view_projection) << view.name;
    EXPECT_EQ(session->parts().frames.views().views().size(), 1u + 8 + 6 + 1 + kOwnViews);
}

TEST_F(Views, ThatTheProgramDoesNotGiveAreAnError) {
    const auto session = open(united());
    ASSERT_TRUE(session);
    render::FrameInput frame = input(0);
    frame.views["mine"].pop_back();
    const Status failed = session->render_frame(frame);
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.errors().at(0).code, "W193");
    EXPECT_NE(failed.errors()[0].message.find("gave 2 views for the list \"mine\""), std::string::npos);
    // The session goes on with the next frame.
    EXPECT_TRUE(session->render_frame(input(0)));
    EXPECT_TRUE(session->finish());
}

// The draws of a mirrored view without a draw list have the front faces that the author gives.
TEST_F(Views, InAMirrorKeepTheFrontFacesOfProceduralDraws) {
    const std::string graph = R"json({ "version": 1, "imports": { "opaque": "drawlist" },
      "views": { "mirror": { "of": "camera", "plane": [0, 1, 0, 0.25] } },
      "resources": { "atlas": "rgba8", "cube": "rgba8", "cubePast": "r8", "seen": "rgba8", "seenPast": "r8",
                     "mineColor": "r8", "minePast": "r8" },
      "passes": {
        "below": { "type": "raster", "draws": { "vertices": 3 }, "shader": "roof", "view": "mirror",
                   "out": { "color": "atlas" }, "state": { "cull": "back", "frontFace": "ccw" } },
        "above": { "type": "raster", "draws": { "vertices": 3 }, "shader": "roof", "view": "mirror",
                   "out": { "color": "cube" }, "state": { "cull": "back", "frontFace": "cw" } },
        "none1": { "type": "clear", "out": ["cubePast"] }, "none2": { "type": "clear", "out": ["seen"] },
        "none3": { "type": "clear", "out": ["seenPast"] }, "none4": { "type": "clear", "out": ["mineColor"] },
        "none5": { "type": "clear", "out": ["minePast"] } } })json";
    const auto session = open(graph, {});
    ASSERT_TRUE(session);
    const auto read = second_frame(*session);
    size_t front = 0;
    for (const glm::vec4& texel : render::decode_texels(Format::rgba8, read.at("observe:atlas").bytes)) {
        EXPECT_TRUE(texel.a == 0 || texel.a == 1);
        front += texel.a == 1 ? 1 : 0;
    }
    EXPECT_GT(front, 100u);
    for (const std::byte byte : read.at("observe:cube").bytes) EXPECT_EQ(byte, std::byte{0});
}

// A resting pass over all views of a list, with one pass for each view, runs only in frames in which the
// matrix of one of them changes, even if other views move.
TEST_F(Views, AtRestWakeWhenTheirMatricesChange) {
    std::string graph = united();
    const std::string find = "\"mine\": { \"views\": \"mine\",";
    graph.replace(graph.find(find), find.size(), find + " \"rest\": true, \"lowering\": \"passes\",");
    for (const char* name : {"mineDepth", "mineColor", "minePast"}) {
        const std::string key = std::string("\"") + name + "\": { ";
        graph.replace(graph.find(key), key.size(), key + "\"keep\": true, ");
    }
    const std::string plain = "\"depth\": \"mineDepth\",";
    graph.replace(graph.find(plain), plain.size(),
                  "\"clear\": 0, \"depth\": { \"ref\": \"mineDepth\", \"clear\": 0 },");
    const auto session = open(graph);
    ASSERT_TRUE(session);
    const auto frame = [&](float camera_x, int moved) {
        render::FrameInput next = input(0);
        next.camera.transform[3].x += camera_x;
        if (moved >= 0) next.views["mine"][static_cast<size_t>(moved)].view[3].x += 0.5f;
        ASSERT_TRUE(session->render_frame(next));
    };
    // The previous matrix of a view is one of its constants, so a view wakes twice: when it moves, and when
    // its previous matrix follows.
    const std::vector<std::pair<float, int>> frames{{0, -1}, {1, -1}, {2, 1}, {3, 1}, {4, 1}, {5, -1}};
    for (const auto& [x, moved] : frames) frame(x, moved);
    ASSERT_TRUE(session->finish());
    std::vector<std::string> ran;
    for (const vk::FrameTiming& timing : session->take_timings()) {
        std::string text;
        for (const vk::PassTiming& pass : timing.passes)
            if (pass.pass.starts_with("mine#") && !pass.rested) text += pass.pass.back();
        ran.push_back(text);
    }
    EXPECT_EQ(ran, (std::vector<std::string>{"012", "", "1", "1", "", "1"}));
}

}  // namespace
}  // namespace weft::test
