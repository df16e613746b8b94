// Tests how graphs see irradiance probes on a device: their faces, their tables, their turns, and the frames
// that light them before the first frame.
#include <algorithm>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "render/probes/probe_turns.h"
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kPicture{96, 64, 1};
constexpr size_t kFaceSide = 16;
constexpr const char* kFacesGraph = WEFT_SOURCE_DIR "/tests/render/probes/faces.json";

scene::Mesh wall() {
    scene::Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.bounds = {{-1, -1, 0}, {1, 1, 0}};
    return mesh;
}

// A wall 8 m behind the origin (z = −8), and in front of it two squares at z = −4 and z = +4. The one at z =
// −4 follows a node that stands still for a second, the one at z = +4 follows none.
scene::Scene walls() {
    scene::Scene scene;
    scene.meshes = {wall()};
    scene.materials = {{}};
    scene.materials[0].double_sided = true;
    scene.motion.nodes = {{}};
    scene::Animation animation;
    animation.length_s = 4;
    animation.samplers = {{scene::Interpolation::linear,
                           false,
                           {0, 1, 4},
                           {glm::vec4(0, 0, -4, 0), glm::vec4(0, 0, -4, 0), glm::vec4(9, 0, -4, 0)}}};
    animation.channels = {{0, scene::MotionPath::translation, 0}};
    scene.motion.animations = {animation};
    const glm::mat4 one(1);
    scene.instances = {
        {"wall", 0, 0, glm::scale(glm::translate(one, {0, 0, -8}), glm::vec3(20, 20, 1))},
        {"moves", 0, 0, glm::translate(one, {0, 0, -4}), 0},
        {"stays", 0, 0, glm::translate(one, {0, 0, 4})},
    };
    scene.bounds = scene::world_bounds(scene);
    return scene;
}

// A row of `count` columns of probes along x, with 2 × 2 probes each. The first probe is at the origin.
scene::Probes row(int count) {
    scene::Probes probes;
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < count; ++x) probes.volume.probes.push_back({{x, y, z}});
    return probes;
}

class ProbesVk : public SessionTest {
 protected:
    std::unique_ptr<render::Session> begin(const scene::Scene& scene, const scene::Probes& probes,
                                           bool moves_instances = false) {
        passes_ = registered_passes();
        render::SessionInput input;
        input.adds_parts = false;
        input.request.path = kFacesGraph;
        input.request.size = kPicture;
        input.request.observed = {"faceDepth", "noted", "counts"};
        input.load.reader = read_text;
        input.load.reads_disk = true;
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.load.shader_cache = WEFT_TEST_CACHE;
        input.passes = &passes_;
        input.check_plan = true;
        input.probes = probes;
        input.moves_instances = moves_instances;
        input.timestamps = true;
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, scene, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        if (!session) return nullptr;
        scene::Camera camera;
        camera.transform = glm::translate(glm::mat4(1), {-5, 0.1f, 0.3f});
        frame_of(**session) = {.camera = camera};
        return std::move(*session);
    }

    // Renders a frame. Then read_ has the values of the observed resources, and lit_ the probes that ran.
    void frame(render::Session& session, double time_s = 0) {
        ASSERT_TRUE(draw_frame(session, time_s, 0.1));
        ASSERT_TRUE(session.finish());
        read_.clear();
        for (vk::ReadbackData& data : session.take_readbacks()) read_[data.pass] = std::move(data.bytes);
        for (const vk::FrameTiming& timing : session.take_timings()) lit_ = lit(timing);
    }

    // Returns the probes that ran in a frame, by the names of their passes such as "bake::faces#3#0".
    static std::vector<uint32_t> lit(const vk::FrameTiming& timing) {
        std::set<uint32_t> probes;
        for (const vk::PassTiming& pass : timing.passes)
            if (!pass.rested && pass.pass.starts_with("bake::faces#"))
                probes.insert(
                    static_cast<uint32_t>(std::stoul(pass.pass.substr(std::strlen("bake::faces#")))));
        return {probes.begin(), probes.end()};
    }

    // The depth in the middle of a face.
    [[nodiscard]] float depth(uint32_t probe, uint32_t face) const {
        const std::vector<std::byte>& bytes = read_.at("observe:faceDepth");
        const size_t at = (size_t{6} * probe + face) * kFaceSide * kFaceSide + kFaceSide * 8 + 8;
        float value = 0;
        std::memcpy(&value, &bytes.at(at * sizeof value), sizeof value);
        return value;
    }
    // The numbers of probes, cells, cells with the right probes, levels and frames.
    [[nodiscard]] std::vector<uint32_t> counts() const {
        std::vector<uint32_t> words(5);
        std::memcpy(words.data(), read_.at("observe:counts").data(), words.size() * sizeof(uint32_t));
        return words;
    }

    std::map<std::string, std::vector<std::byte>> read_;
    std::vector<uint32_t> lit_;
};

TEST_F(ProbesVk, ShadersFindTheProbesAndTheirCells) {
    scene::Probes probes = row(3);
    probes.volume.probes[4].state = scene::ProbeState::dropped;
    probes.volume.probes[5].offset = {0.1f, 0.2f, -0.1f};
    const std::unique_ptr<render::Session> session = begin(walls(), probes);
    ASSERT_TRUE(session);
    EXPECT_EQ(session->probe_count(), 11u);
    frame(*session);
    EXPECT_EQ(counts(), (std::vector<uint32_t>{11, 2, 2, 1, 1}));
}

TEST_F(ProbesVk, FacesShowWhatDoesNotMove) {
    const std::unique_ptr<render::Session> session = begin(walls(), row(2));
    ASSERT_TRUE(session);
    // Two frames light all eight probes.
    frame(*session), frame(*session);
    EXPECT_NEAR(depth(0, 5), 0.01f / 8, 1e-6f) << "the wall, and not the square in front of it";
    EXPECT_NEAR(depth(0, 4), 0.01f / 4, 1e-6f) << "the square that stands still";
    for (const uint32_t face : {0u, 1u, 2u, 3u}) EXPECT_EQ(depth(0, face), 0) << face;
    // The square in front of the wall moves, and no probe wakes.
    for (const double time_s : {1.5, 2.0, 2.5}) {
        frame(*session, time_s);
        EXPECT_EQ(lit_, std::vector<uint32_t>{});
    }
}

TEST_F(ProbesVk, AnObjectCountsAsStillUntilTheProgramMovesIt) {
    scene::Scene scene = walls();
    const std::unique_ptr<render::Session> session = begin(scene, row(2), true);
    ASSERT_TRUE(session);
    frame(*session), frame(*session);
    EXPECT_NEAR(depth(0, 4), 0.01f / 4, 1e-6f);
    frame_of(*session).transforms = {{2, glm::translate(glm::mat4(1), {0, 0, 2})}};
    std::vector<uint32_t> lit;
    for (int i = 0; i < 14; ++i) {
        frame(*session);
        lit.insert(lit.end(), lit_.begin(), lit_.end());
    }
    std::ranges::sort(lit);
    EXPECT_EQ(lit, (std::vector<uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(depth(0, 4), 0);
    EXPECT_NEAR(depth(0, 5), 0.01f / 8, 1e-6f);
    // It moves on, and no probe wakes.
    for (int i = 0; i < 12; ++i) {
        frame_of(*session).transforms = {
            {2, glm::translate(glm::mat4(1), {0, 0, 3.0f + 0.1f * static_cast<float>(i)})}};
        frame(*session);
        EXPECT_EQ(lit_, std::vector<uint32_t>{});
    }
}

TEST_F(ProbesVk, WithoutProbesTheGroupIsGone) {
    const std::unique_ptr<render::Session> session = begin(walls(), {});
    ASSERT_TRUE(session);
    EXPECT_TRUE(session->plan().graph.groups.empty());
    Result<std::vector<vk::FrameTiming>> warm = session->warm_up_probes(frame_of(*session));
    ASSERT_TRUE(warm);
    EXPECT_TRUE(warm->empty());
    frame(*session);
    EXPECT_EQ(counts(), (std::vector<uint32_t>{0, 0, 0, 0, 1}));
}

TEST_F(ProbesVk, FourProbesHaveATurnInAFrameAndTheNearestComeFirst) {
    const std::unique_ptr<render::Session> session = begin(walls(), row(10));
    ASSERT_TRUE(session);
    std::set<uint32_t> all;
    for (int i = 0; i < 10; ++i) {
        frame(*session);
        EXPECT_EQ(lit_.size(), 4u) << i;
        all.insert(lit_.begin(), lit_.end());
        // The columns of the row have the numbers 0 to 9 + multiples of 10.
        if (i == 0) {
            EXPECT_EQ(lit_, (std::vector<uint32_t>{0, 10, 20, 30}));
        }
        if (i == 9) {
            EXPECT_EQ(lit_, (std::vector<uint32_t>{9, 19, 29, 39}));
        }
    }
    EXPECT_EQ(all.size(), 40u);
    frame(*session);
    EXPECT_EQ(lit_, std::vector<uint32_t>{}) << "all rest";
}

TEST_F(ProbesVk, AListOfTheProgramReplacesTheRule) {
    const std::unique_ptr<render::Session> session = begin(walls(), row(10));
    ASSERT_TRUE(session);
    frame_of(*session).turns["probeTurns"] = {39, 1, 5, 7, 22, 23};
    frame(*session);
    EXPECT_EQ(lit_, (std::vector<uint32_t>{1, 5, 7, 22, 23, 39}));
}

TEST_F(ProbesVk, AWarmUpLightsAllAndShiftsNothing) {
    const std::unique_ptr<render::Session> cold = begin(walls(), row(6)), warm = begin(walls(), row(6));
    ASSERT_TRUE(cold && warm);
    frame_of(*warm).time_s = 0;
    std::vector<uint32_t> progress;
    render::ProbeWarmUp settings{.rounds = 2, .most_per_frame = 10};
    settings.progress = [&](uint32_t done, uint32_t all) {
        EXPECT_EQ(all, 48u);
        progress.push_back(done);
    };
    Result<std::vector<vk::FrameTiming>> timings = warm->warm_up_probes(frame_of(*warm), settings);
    ASSERT_TRUE(timings) << to_text(timings.errors());
    EXPECT_EQ(progress, (std::vector<uint32_t>{10, 20, 24, 34, 44, 48}));
    ASSERT_EQ(timings->size(), 6u);
    for (size_t i = 0; i < 6; ++i)
        EXPECT_EQ(lit((*timings)[i]).size(), i < 2 ? 10u : i == 2 ? 4u : 0u) << "frame " << i;
    EXPECT_TRUE(warm->take_readbacks().empty());
    EXPECT_TRUE(warm->take_timings().empty());
    for (int i = 0; i < 3; ++i) {
        frame(*cold, 0.1 * i);
        const std::map<std::string, std::vector<std::byte>> wanted = read_;
        frame(*warm, 0.1 * i);
        EXPECT_EQ(lit_, std::vector<uint32_t>{}) << "frame " << i;
        EXPECT_EQ(read_.at("observe:noted"), wanted.at("observe:noted")) << "frame " << i;
        EXPECT_EQ(read_.at("observe:counts"), wanted.at("observe:counts")) << "frame " << i;
        EXPECT_NEAR(depth(23, 5), 0.01f / 9, 1e-6f);
    }
}

}  // namespace
}  // namespace weft::test
