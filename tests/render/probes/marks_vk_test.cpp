// Tests of the module probe_marks: the colours of the spheres at the probes.
#include "tests/render/probes/bake_fixture.h"

namespace weft::test {
namespace {

constexpr int kMarksSide = 256;
constexpr glm::vec3 kBlue{0.25f, 0.55f, 1}, kBlack{0}, kGrey{0.45f}, kMagenta{1, 0.1f, 0.9f};

class ProbeMarks : public ProbeBake {
 protected:
    // Returns the pixel at which a place in world space is drawn.
    static glm::ivec2 pixel_of(const render::Session& session, const glm::vec3& place) {
        const glm::vec4 clip = session.parts().frames.view().view_projection * glm::vec4(place, 1);
        return glm::ivec2((glm::vec2(clip) / clip.w * 0.5f + 0.5f) * float{kMarksSide});
    }
    [[nodiscard]] glm::vec3 color_of(glm::ivec2 pixel, int view) const {
        return {images_.at(
            "probeMarks")[static_cast<size_t>((view * kMarksSide + pixel.y) * kMarksSide + pixel.x)]};
    }
    [[nodiscard]] glm::vec3 color_at(const render::Session& session, const glm::vec3& place) const {
        return color_of(pixel_of(session, place), 0);
    }
};

void expect_color(const glm::vec3& color, const glm::vec3& wanted, const char* what) {
    EXPECT_LT(glm::length(color - wanted), 0.08f)
        << what << ": " << color.x << " " << color.y << " " << color.z;
}

// Returns the normal of a sphere that the camera, which is at the origin, sees at a pixel.
glm::vec3 normal_at(const render::Session& session, glm::ivec2 pixel, const glm::vec3& center,
                    float radius_m) {
    const glm::vec2 ndc = (glm::vec2(pixel) + 0.5f) / float{kMarksSide} * 2.0f - 1.0f;
    const glm::vec4 far = session.parts().frames.view().inverse_view_projection * glm::vec4(ndc, 0.01f, 1);
    const glm::vec3 ray = glm::normalize(glm::vec3(far) / far.w);
    const float middle = glm::dot(center, ray);
    const float half2 = radius_m * radius_m - glm::dot(center, center) + middle * middle;
    return ((middle - std::sqrt(half2)) * ray - center) / radius_m;
}

// Returns the colour of a white ball in a light whose nine coefficients are 1.
float ball_grey(const glm::vec3& n) {
    const float light = std::max(0.0f, 1 + n.x + n.y + n.z + n.x * n.y + n.y * n.z + n.x * n.z +
                                           3 * n.y * n.y - 1 + n.x * n.x - n.z * n.z);
    const float tone =
        std::clamp(light * (2.51f * light + 0.03f) / (light * (2.43f * light + 0.59f) + 0.14f), 0.0f, 1.0f);
    return tone > 0.0031308f ? 1.055f * std::pow(tone, 1 / 2.4f) - 0.055f : 12.92f * tone;
}

// The camera is at the origin and looks along −z.
TEST_F(ProbeMarks, TheColourTellsTheStateOfAProbe) {
    scene::Scene scene;
    const uint32_t wall = scene::add_matt(scene, "wall", glm::vec3(0.5f));
    scene::MeshBuilder builder;
    builder.add_rectangle({-3, -3, -5}, {6, 0, 0}, {0, 6, 0});
    scene::place(scene, builder.finish("wall"), wall);
    scene::finish_scene(scene, glm::vec3(0), glm::vec3(0), 0);
    // The last probe is behind the wall.
    const std::vector<glm::vec3> places{{-1, 1, -4}, {1, 1, -4}, {0.5f, -0.2f, -4}, {0, 0, -7}};
    for (const float lit : {0.0f, 1.0f}) {
        const std::unique_ptr<render::Session> session = begin(scene, probes_at(places),
                                                               {.graph = "marks.json",
                                                                .observed = {"probeMarks"},
                                                                .side_px = kMarksSide,
                                                                .params = {{"lit", lit}}});
        ASSERT_TRUE(session);
        frame_of(*session).camera = {};
        frame_of(*session).turns["probeTurns"] = {0, 2, 3};
        frame(*session);
        const glm::vec3 up(0, 0.03f, 0);
        expect_color(color_at(*session, places[0] + up), kBlue, "baked, upper half");
        expect_color(color_at(*session, places[0] - up), lit > 0 ? kBlue : 0.2f * kBlue, "baked, lower half");
        expect_color(color_at(*session, places[1]), kGrey, "not baked");
        expect_color(color_at(*session, places[2]), kBlack, "moved, the ring");
        expect_color(color_at(*session, places[2] + up), kBlue, "moved, above the ring");
        expect_color(color_at(*session, places[3]), color_at(*session, {0, 0.5f, -5}), "hidden");
        for (const glm::ivec2 aside : {glm::ivec2(0), {3, 0}, {0, 3}, {-2, 1}}) {
            const glm::ivec2 pixel = pixel_of(*session, places[0]) + aside;
            const float grey = lit > 0 ? ball_grey(normal_at(*session, pixel, places[0], 0.08f)) : 0;
            EXPECT_LT(glm::length(color_of(pixel, 1) - grey), 0.02f)
                << "light at " << aside.x << " " << aside.y;
        }
        // Behind the wall, the probe sees its back.
        frame_of(*session).camera.transform[3].z = -6;
        frame(*session);
        expect_color(color_at(*session, places[3] + glm::vec3(0, 0, 0.07f)), kMagenta, "inside");
    }
}

}  // namespace
}  // namespace weft::test
