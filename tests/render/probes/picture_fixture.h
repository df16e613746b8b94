// Purpose: test fixture that renders pictures of scenes with light probes, with all that graphs/deferred.json
// does. Also a court beside a dark room, and the pixels of a picture that show a ball.
#pragma once

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "scene/builtin/scene_parts.h"
#include "scene/procedural/procedural_mesh.h"
#include "tests/render/probes/probe_fixture.h"
#include "tests/scene/probes/probe_scenes.h"
#include "weft/scene/place_probes.h"

namespace weft::test {

// Inner sizes of the rooms of dark_room_beside_court(). The wall between them is at x = 0.
inline constexpr float kRoomLong = 3, kRoomHalfWide = 2, kRoomHigh = 2.4f, kRoomWall = 0.1f;

// A closed dark room at x < 0 and an open court at x > 0, on both sides of a wall of 10 cm.
inline scene::test::BoxScene dark_room_beside_court() {
    scene::test::BoxScene boxes;
    constexpr float kEnd = kRoomLong + kRoomWall, kSide = kRoomHalfWide + kRoomWall;
    boxes.add({-kEnd, -kRoomWall, -kSide}, {kEnd, 0, kSide});
    boxes.add({-kRoomWall / 2, 0, -kRoomHalfWide}, {kRoomWall / 2, kRoomHigh, kRoomHalfWide});
    boxes.add({-kEnd, 0, -kSide}, {-kRoomLong, kRoomHigh, kSide});
    boxes.add({kRoomLong, 0, -kSide}, {kEnd, kRoomHigh, kSide});
    boxes.add({-kEnd, 0, -kSide}, {kEnd, kRoomHigh, -kRoomHalfWide});
    boxes.add({-kEnd, 0, kRoomHalfWide}, {kEnd, kRoomHigh, kSide});
    boxes.add({-kEnd, kRoomHigh, -kSide}, {kRoomWall / 2, kRoomHigh + kRoomWall, kSide});
    boxes.scene.materials[0].base_color = glm::vec4(0.7f, 0.7f, 0.7f, 1);
    return boxes;
}

inline scene::Light sun_from(const glm::vec3& direction, float lux) {
    scene::Light sun;
    sun.type = scene::LightType::directional;
    sun.direction = glm::normalize(direction);
    sun.intensity = lux;
    return sun;
}

inline uint32_t add_metal(scene::Scene& scene, const glm::vec3& color, float roughness) {
    scene::Material metal;
    metal.base_color = glm::vec4(color, 1);
    metal.metallic = 1;
    metal.roughness = roughness;
    scene.materials.push_back(metal);
    return static_cast<uint32_t>(scene.materials.size() - 1);
}

inline scene::Camera camera_at(const glm::vec3& eye, const glm::vec3& at, float fov_y_rad = 1.0f) {
    const bool is_vertical = glm::abs(glm::normalize(at - eye).y) > 0.99f;
    const glm::vec3 up = is_vertical ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
    scene::Camera camera;
    camera.transform = glm::inverse(glm::lookAt(eye, at, up));
    camera.fov_y_rad = fov_y_rad;
    camera.near_m = 0.01f;
    return camera;
}

struct Ball {
    glm::vec3 middle{0};
    float radius_m = 0;
};

// Returns the direction in which the camera sees a pixel.
inline glm::vec3 way_of(const scene::Camera& camera, glm::uvec2 size, size_t pixel) {
    const glm::vec2 at = (glm::vec2(pixel % size.x, pixel / size.x) + 0.5f) / glm::vec2(size) * 2.0f - 1.0f;
    const float high = std::tan(0.5f * camera.fov_y_rad), wide = high * float(size.x) / float(size.y);
    return glm::normalize(glm::mat3(camera.transform) * glm::vec3(at.x * wide, -at.y * high, -1));
}

// Returns the pixels of a picture that show the ball. 5 % of its radius are left out.
inline std::vector<size_t> pixels_of(const Ball& ball, const scene::Camera& camera, glm::uvec2 size) {
    std::vector<size_t> found;
    const glm::vec3 to_middle = ball.middle - glm::vec3(camera.transform[3]);
    for (size_t i = 0; i < size_t{size.x} * size.y; ++i) {
        const float along = glm::dot(way_of(camera, size, i), to_middle);
        const float beside = std::sqrt(std::max(glm::dot(to_middle, to_middle) - along * along, 0.0f));
        if (along > 0 && beside < 0.95f * ball.radius_m) found.push_back(i);
    }
    return found;
}

class ProbePicture : public ProbeTest {
 protected:
    static constexpr glm::uvec2 kSize{96, 64};

    static scene::Probes placed(const scene::Scene& scene, uint32_t most_probes) {
        scene::PlacementParams placement;
        placement.most_probes = most_probes;
        Result<scene::Probes> probes = scene::place_probes(scene, placement);
        EXPECT_TRUE(probes) << to_text(probes.errors());
        return probes ? std::move(*probes) : scene::Probes{};
    }

    // Starts a session of deferred.json, and lights its probes. The exposure is fixed.
    std::unique_ptr<render::Session> begin(const scene::Scene& scene, scene::Probes probes,
                                           const render::SkyColors& sky, uint32_t rounds = 4,
                                           std::vector<std::string> observed = {"hdr"}) {
        std::unique_ptr<render::Session> session = start_with_probes(
            scene, std::move(probes), graph_path("deferred"), {kSize.x, kSize.y, 1}, std::move(observed),
            {{"probeFaceSize", 16},
             {"lampShadowMaps", 0},  // The references of these tests have no shadows of lamps.
             {"autoExposure", 0},
             {"reflectionFaceSize", 64},
             {"sceneSunShadowSize", 512}});
        if (!session) return nullptr;
        render::FrameInput& frame = frame_of(*session);
        frame = {.camera = scene::framing_camera(scene, float(kSize.x) / float(kSize.y))};
        frame.sky = sky;
        const Result<std::vector<vk::FrameTiming>> lit = session->warm_up_probes(frame, {.rounds = rounds});
        EXPECT_TRUE(lit) << to_text(lit.errors());
        return lit ? std::move(session) : nullptr;
    }

    // Renders a frame, and returns its radiance in cd/m². Empty after an error.
    std::vector<glm::vec3> picture(render::Session& session, const scene::Camera& camera) {
        frame_of(session).camera = camera;
        Status done = draw_frame(session);
        if (done) done = session.finish();
        EXPECT_TRUE(done) << to_text(done.errors());
        std::vector<glm::vec3> radiance;
        if (!done) return radiance;
        const ProbeResults results = take_results(session);
        for (const glm::vec4& texel : results.images.at("hdr"))
            radiance.push_back(glm::vec3(texel) / session.pre_exposure());
        return radiance;
    }

    static double mean_of(const std::vector<glm::vec3>& picture, const std::vector<size_t>& pixels) {
        double sum = 0;
        for (const size_t pixel : pixels) sum += double{picture.at(pixel).g};
        return sum / static_cast<double>(pixels.size());
    }
};

}  // namespace weft::test
