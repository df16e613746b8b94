// Purpose: test fixture that lights the irradiance probes of a scene, and reads their light.
#pragma once

#include <cstring>
#include <numeric>

#include "shared/probe_sh.glsl"
#include "tests/render/probes/probe_scenes.h"
#include "tests/render/session_fixture.h"

namespace weft::test {

// Values of the parameter probeFeedback: the light that surfaces reflect further.
enum class Feedback : uint8_t { none, volume, self };

// The light of a probe, as shaders read it.
struct ProbeLight {
    std::array<glm::dvec3, 9> coefficients{};
    bool is_lit = false;

    [[nodiscard]] glm::dvec3 irradiance(const glm::dvec3& n) const {
        const std::array<double, 9> basis{
            1, n.x, n.y, n.z, n.x * n.y, n.y * n.z, n.x * n.z, 3 * n.y * n.y - 1, n.x * n.x - n.z * n.z};
        glm::dvec3 sum(0);
        for (size_t i = 0; i < basis.size(); ++i) sum += coefficients[i] * basis[i];
        return sum * std::numbers::pi;
    }
};

// The sky of a scene with the same radiance in all directions.
inline render::SkyColors even_sky(float radiance) {
    return {glm::vec3(radiance), glm::vec3(radiance), glm::vec3(radiance)};
}

class Relight : public SessionTest {
 protected:
    static constexpr const char* kGraph = WEFT_SOURCE_DIR "/tests/render/probes/relight.json";

    struct Settings {
        Feedback feedback = Feedback::none;
        uint32_t face_px = 32;
        float sky = 0;
        uint32_t block_px = 2;
    };

    // Starts a session that lights all `probes` in each frame.
    std::unique_ptr<render::Session> begin(const scene::Scene& scene, const scene::Probes& probes,
                                           const Settings& settings) {
        passes_ = registered_passes();
        render::SessionInput input;
        input.adds_parts = false;
        input.request.path = kGraph;
        input.request.size = {16, 16, 1};
        input.request.observed = {"probeSh"};
        input.request.params = {{"probeFeedback", static_cast<double>(settings.feedback)},
                                {"probeBlock", settings.block_px},
                                {"probeFaceSize", settings.face_px}};
        input.load.reader = read_text;
        input.load.reads_disk = true;
        input.load.graph_root = WEFT_SOURCE_DIR "/graphs";
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.load.shader_cache = WEFT_TEST_CACHE;
        input.passes = &passes_;
        input.check_plan = true;
        input.probes = probes;
        input.moves_instances = moves_instances_;
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, scene, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        if (!session) return nullptr;
        count_ =
            static_cast<uint32_t>(std::ranges::count_if(probes.volume.probes, [](const scene::Probe& probe) {
                return probe.state != scene::ProbeState::dropped;
            }));
        render::FrameInput& frame = frame_of(**session);
        frame = {.camera = scene::framing_camera(scene, 1)};
        frame.sky = even_sky(settings.sky);
        std::vector<uint32_t>& turns = frame.turns["probeTurns"];
        turns.resize(count_);
        std::iota(turns.begin(), turns.end(), 0u);
        return std::move(*session);
    }

    // Renders a frame. Returns the light of all probes; empty after an error.
    std::vector<ProbeLight> round(render::Session& session) {
        Status done = draw_frame(session);
        if (done) done = session.finish();
        EXPECT_TRUE(done) << to_text(done.errors());
        woken_.clear();
        for (const vk::FrameTiming& timing : session.take_timings())
            for (const vk::PassTiming& pass : timing.passes)
                if (!pass.woken_by.empty()) woken_[pass.pass] = pass.woken_by;
        std::vector<ProbeLight> lights;
        for (const vk::ReadbackData& data : session.take_readbacks())
            for (uint32_t p = 0; p < count_; ++p) {
                std::array<glm::vec4, shared::kProbeShStride> items;
                std::memcpy(items.data(), data.bytes.data() + p * sizeof items, sizeof items);
                ProbeLight& light = lights.emplace_back();
                for (size_t i = 0; i < 9; ++i) light.coefficients[i] = glm::dvec3(items[i]);
                light.is_lit = items[0].w == 1;
            }
        EXPECT_EQ(lights.size(), count_);
        return lights;
    }
    // Renders some frames, and returns the light after the last of them.
    std::vector<ProbeLight> rounds(render::Session& session, int count) {
        std::vector<ProbeLight> lights;
        for (int i = 0; i < count; ++i) lights = round(session);
        return lights;
    }
    // The number of rounds of the group that ran in the last frame.
    [[nodiscard]] size_t rounds_run() const {
        return static_cast<size_t>(std::ranges::count_if(
            woken_, [](const auto& pass) { return pass.first.starts_with("probeRelight::light"); }));
    }

    bool moves_instances_ = false;
    uint32_t count_ = 0;                        // Number of probes.
    std::map<std::string, std::string> woken_;  // The passes that ran in the last frame, and why.
};

}  // namespace weft::test
