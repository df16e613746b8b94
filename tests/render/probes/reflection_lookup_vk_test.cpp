// Looks up reflections in a closed room with one reflection probe. The room is 10 m × 6 m × 10 m; the probe
// is at (0, 2, 1). The expected directions and values were computed in closed form.
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr const char* kGraph = WEFT_SOURCE_DIR "/tests/render/probes/reflections.json";

struct Row {
    glm::vec3 direction;  // From the probe to the place that the ray meets.
    float radiance;
    bool on_edge;  // The ray ends on an edge of the room: both walls are right.
};
constexpr size_t kRows = 8;
const std::array<Row, kRows> kExpected{{{{.6804f, .2722f, -.6804f}, 1.0100f, false},
                                        {{-.8996f, .1200f, .4198f}, 2.1033f, false},
                                        {{.0830f, .0415f, -.9957f}, 5.9000f, false},
                                        {{-.7809f, 0, .6247f}, 2.1400f, true},
                                        {{.5774f, .5774f, .5774f}, 3.3100f, true},
                                        {{-.8560f, -.4466f, .2605f}, 4.0267f, false},
                                        {{.2357f, .9428f, -.2357f}, 3.1300f, false},
                                        {{.5963f, -.2981f, -.7454f}, 3.9200f, false}}};

class ReflectionLookup : public SessionTest {
 protected:
    // Returns the texels of "found".
    std::vector<glm::vec4> look_up(const scene::ReflectionProbe& probe) {
        probes_.reflections = {probe};
        const std::unique_ptr<render::Session> session = start(kGraph, {16, 16}, {"found"});
        if (!session) return {};
        Status done = draw_frame(*session);
        if (done) done = session->finish();
        EXPECT_TRUE(done) << to_text(done.errors());
        const std::vector<vk::ReadbackData> data = session->take_readbacks();
        return data.empty() ? std::vector<glm::vec4>{} : render::decode_texels(data[0].format, data[0].bytes);
    }
};

scene::ReflectionProbe probe_with_box() {
    return {"room", {0, 2, 1}, scene::ProbeBox{{0, 3, 0}, {5, 3, 5}, {1, 0, 0, 0}}};
}

TEST_F(ReflectionLookup, InABoxIsExact) {
    const std::vector<glm::vec4> found = look_up(probe_with_box());
    ASSERT_EQ(found.size(), 2 * kRows);
    for (size_t i = 0; i < kRows; ++i) {
        EXPECT_LT(glm::distance(glm::vec3(found[kRows + i]), kExpected[i].direction), 1e-4f) << i;
        if (kExpected[i].on_edge) continue;
        EXPECT_NEAR(found[i].r, kExpected[i].radiance, 0.004f) << i;
    }
}

// A box that is turned and moved like the room gives the same directions.
TEST_F(ReflectionLookup, InATurnedBoxIsTheSame) {
    scene::ReflectionProbe probe = probe_with_box();
    const std::vector<glm::vec4> straight = look_up(probe);
    const float half = std::sqrt(0.5f);
    probe.box->rotation = glm::quat(half, 0, half, 0);  // 90° around y: the room is as wide as long.
    const std::vector<glm::vec4> turned = look_up(probe);
    ASSERT_EQ(straight.size(), 2 * kRows);
    ASSERT_EQ(turned.size(), 2 * kRows);
    for (size_t i = kRows; i < 2 * kRows; ++i) EXPECT_LT(glm::distance(straight[i], turned[i]), 1e-4f) << i;
}

TEST_F(ReflectionLookup, WithoutABoxFollowsTheDistances) {
    scene::ReflectionProbe probe = probe_with_box();
    probe.box.reset();
    const std::vector<glm::vec4> found = look_up(probe);
    ASSERT_EQ(found.size(), 2 * kRows);
    for (size_t i = 0; i < kRows; ++i) {
        EXPECT_LT(glm::distance(glm::vec3(found[kRows + i]), kExpected[i].direction), 0.02f) << i;
        EXPECT_GT(found[kRows + i].w, 0.95f) << i;
        if (kExpected[i].on_edge) continue;
        EXPECT_NEAR(found[i].r, kExpected[i].radiance, 0.01f) << i;
        EXPECT_GT(found[i].w, 0.95f) << i;
    }
}

// Outside of its box, a probe gives no light.
TEST_F(ReflectionLookup, OutsideOfTheBoxThereIsNoLight) {
    scene::ReflectionProbe probe = probe_with_box();
    probe.box->center = {0, 30, 0};
    const std::vector<glm::vec4> found = look_up(probe);
    ASSERT_EQ(found.size(), 2 * kRows);
    for (size_t i = 0; i < kRows; ++i) EXPECT_EQ(found[i], glm::vec4(0)) << i;
}

}  // namespace
}  // namespace weft::test
