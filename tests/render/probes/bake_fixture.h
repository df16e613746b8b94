// Purpose: test fixture that bakes irradiance probes and reads the images of the bake.
#pragma once

#include <array>
#include <numbers>

#include "scene/builtin/scene_parts.h"
#include "scene/procedural/procedural_mesh.h"
#include "tests/render/session_fixture.h"

namespace weft::test {

inline constexpr int kBakeSide = 32, kMapSide = 34, kInnerSide = 32;
// The images of the bake.
inline const std::vector<std::string> kBakeImages{"probeAlbedo", "probeNormal", "probeDistance",
                                                  "probeEmission", "probeMoments"};

// Returns a volume of probes at these places. They are not the corners of any cell.
inline scene::Probes probes_at(const std::vector<glm::vec3>& places) {
    scene::Probes probes;
    for (size_t i = 0; i < places.size(); ++i) {
        scene::Probe& probe = probes.volume.probes.emplace_back();
        probe.at = {static_cast<int>(i), 0, 0};
        probe.offset = places[i] - glm::vec3(probe.at);
    }
    return probes;
}

// Returns the direction of a texel of a face that a samplerCube of Vulkan reads.
inline glm::vec3 direction_of_texel(int face, int x, int y, int side = kBakeSide) {
    const float s = (2.0f * static_cast<float>(x) + 1.0f) / static_cast<float>(side) - 1.0f;
    const float t = (2.0f * static_cast<float>(y) + 1.0f) / static_cast<float>(side) - 1.0f;
    const std::array<glm::vec3, 6> directions{glm::vec3{1, -t, -s}, {-1, -t, s}, {s, 1, t},
                                              {s, -1, -t},          {s, -t, 1},  {-s, -t, -1}};
    return glm::normalize(directions[static_cast<size_t>(face)]);
}

inline glm::vec3 octahedral(glm::vec2 e) {
    glm::vec3 n(e, 1 - std::abs(e.x) - std::abs(e.y));
    if (n.z < 0) {
        const glm::vec2 folded = 1.0f - glm::abs(glm::vec2(n.y, n.x));
        n.x = n.x < 0 ? -folded.x : folded.x;
        n.y = n.y < 0 ? -folded.y : folded.y;
    }
    return glm::normalize(n);
}

class ProbeBake : public SessionTest {
 protected:
    struct Picture {
        std::string graph = "bake.json";
        std::vector<std::string> observed = kBakeImages;
        uint32_t side_px = 32;
        std::map<std::string, double> params = {};
    };

    std::unique_ptr<render::Session> begin(const scene::Scene& scene, const scene::Probes& probes) {
        return begin(scene, probes, Picture());
    }
    std::unique_ptr<render::Session> begin(const scene::Scene& scene, const scene::Probes& probes,
                                           const Picture& picture) {
        passes_ = registered_passes();
        render::SessionInput input;
        input.adds_parts = false;
        input.request.path = WEFT_SOURCE_DIR "/tests/render/probes/" + picture.graph;
        input.request.size = {picture.side_px, picture.side_px, 1};
        input.request.observed = picture.observed;
        for (const auto& [name, value] : picture.params) input.request.params[name] = value;
        input.load.reader = read_text;
        input.load.graph_root = WEFT_SOURCE_DIR "/graphs";
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.load.shader_cache = WEFT_TEST_CACHE;
        input.passes = &passes_;
        input.probes = probes;
        input.moves_instances = true;
        input.check_plan = true;
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, scene, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        if (!session) return nullptr;
        frame_of(**session) = {.camera = scene::framing_camera(scene, 1)};
        return std::move(*session);
    }

    // Renders a frame. Then texel() reads its images, and ran() tells how many passes of the bake ran.
    void frame(render::Session& session) {
        ASSERT_TRUE(draw_frame(session));
        ASSERT_TRUE(session.finish());
        for (const vk::ReadbackData& data : session.take_readbacks())
            images_[data.pass.substr(std::string("observe:").size())] =
                render::decode_texels(data.format, data.bytes);
        ran_ = 0;
        for (const vk::FrameTiming& timing : session.take_timings())
            for (const vk::PassTiming& pass : timing.passes)
                if (pass.pass.starts_with("probeBake::") && !pass.rested) ++ran_;
    }

    // Returns a texel of a face of a probe.
    [[nodiscard]] glm::vec4 texel(const std::string& image, int probe, int face, int x, int y) const {
        const auto layer = static_cast<size_t>(6 * probe + face);
        return images_.at(
            image)[(layer * kBakeSide + static_cast<size_t>(y)) * kBakeSide + static_cast<size_t>(x)];
    }
    // Returns a texel of the map of moments of a probe; the border begins at 0.
    [[nodiscard]] glm::vec4 moments(int probe, int x, int y) const {
        return images_.at("probeMoments")[static_cast<size_t>((probe * kMapSide + y) * kMapSide + x)];
    }

    std::map<std::string, std::vector<glm::vec4>> images_;
    size_t ran_ = 0;
};

}  // namespace weft::test
