// Tests of the module probe_marks: the colours of the spheres at the probes.
#include "tests/render/probes/bake_fixture.h"

namespace weft::test {
namespace {

constexpr int kMarksSide = 256;
constexpr glm::vec3 kBlue{0.25f, 0.55f, 1}, kBlack{0}, kGrey{0.45f}, kMagenta{1, 0.1f, 0.9f};

class ProbeMarks : public ProbeBake {
 protected:
    // Returns the colour at a place in world space.
    [[nodiscard]] glm::vec3 color_at(const render::Session& session, const glm::vec3& place) const {
        const glm::vec4 clip = session.parts().frames.view().view_projection * glm::vec4(place, 1);
        const glm::ivec2 at((glm::vec2(clip) / clip.w * 0.5f + 0.5f) * float{kMarksSide});
        return {images_.at("probeMarks")[static_cast<size_t>(at.y * kMarksSide + at.x)]};
    }
};

void expect_color(const glm::vec3& color, const glm::vec3& wanted, const char* what) {
    EXPECT_LT(glm::length(color - wanted), 0.08f)
        << what << ": " << color.x << " " << color.y << " " << color.z;
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
        // Behind the wall, the probe sees its back.
        frame_of(*session).camera.transform[3].z = -6;
        frame(*session);
        expect_color(color_at(*session, places[3] + glm::vec3(0, 0, 0.07f)), kMagenta, "inside");
    }
}

}  // namespace
}  // namespace weft::test
