// Tests pictures with a speck of one pixel that has 10⁶ cd/m², and a glowing wire that is one pixel wide,
// while the camera moves. All values must be finite. The specks must leave no bright trails, and must not
// move the exposure.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/exposure/exposure_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kSpeckSize{160, 90, 1};
constexpr int kSpeckFrames = 14;

// Adds a flat square above the spheres. Its corners are those of the ground mesh, from −1 to 1.
void add_glow(scene::Scene& scene, const glm::mat4& transform, float luminance) {
    scene::Material material;
    material.base_color = glm::vec4(0, 0, 0, 1);
    material.metallic = 0;
    material.specular = 0;
    material.emissive = glm::vec3(luminance);
    scene.materials.push_back(material);
    scene.instances.push_back(
        {"glow", uint32_t(scene.meshes.size() - 1), uint32_t(scene.materials.size() - 1), transform});
}

// A pixel is about 0.075 m wide where the speck and the wire are.
scene::Scene specks_over_spheres(bool glowing) {
    Result<scene::Scene> made = scene::make_builtin("spheres");
    if (!made) return {};
    scene::Scene scene = std::move(*made);
    scene::Mesh square;
    square.positions = {{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}};
    square.normals.assign(4, {0, 1, 0});
    square.tangents.assign(4, {1, 0, 0, 1});
    square.uvs = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    square.indices = {0, 1, 2, 0, 2, 3};
    square.bounds = {{-1, 0, -1}, {1, 0, 1}};
    scene.meshes.push_back(square);
    const auto at = [](glm::vec3 place) { return glm::translate(glm::mat4(1), place); };
    add_glow(scene, glm::scale(at({1.5f, 1, 1.2f}), glm::vec3(0.04f)), glowing ? 1e6f : 0);
    add_glow(scene,
             glm::scale(glm::rotate(at({-1, 1, 0}), 1.1f, glm::vec3(0, 1, 0)), glm::vec3(1.6f, 1, 0.035f)),
             glowing ? 3e4f : 0);
    return scene;
}

using Pictures = std::map<std::string, std::vector<glm::vec4>>;

class BrightSpecks : public ExposureTest {
 protected:
    struct Run {
        std::unique_ptr<render::Session> session;
        Pictures pictures;
        Adaptation adaptation;
    };
    // Without `exposure_ev`, the pre-exposure is that of the scene.
    Run begin(bool glowing, const char* graph, std::vector<std::string> observed,
              std::optional<float> exposure_ev = {}) {
        const scene::Scene scene = specks_over_spheres(glowing);
        observed.emplace_back("adaptation");
        return {start(scene, scene.cameras.at(0), graph_path(graph), kSpeckSize, observed,
                      exposure_ev.value_or(scene.exposure_ev)),
                {},
                {}};
    }
    // Renders the next frame. The camera moves by 1.7 px to the right and 0.6 px down.
    static void next_frame(Run& run) {
        Status drawn = draw_frame(*run.session, 0, 1.0 / 30);
        EXPECT_TRUE(drawn && run.session->finish());
        frame_of(*run.session).camera.transform[3] += glm::vec4(0.13f, 0, 0.045f, 0);
        const std::vector<vk::ReadbackData> readbacks = run.session->take_readbacks();
        run.adaptation = adaptation_of(readbacks);
        run.pictures.clear();
        for (const vk::ReadbackData& data : readbacks)
            if (data.pass != "observe:adaptation")
                run.pictures[data.pass.substr(std::string("observe:").size())] =
                    render::decode_texels(data.format, data.bytes);
    }
};

void expect_finite(const std::vector<glm::vec4>& texels, int frame) {
    for (const glm::vec4& texel : texels)
        for (int c = 0; c < 3; ++c)
            ASSERT_TRUE(std::isfinite(texel[c]) && texel[c] >= 0 && texel[c] <= 65504) << "frame " << frame;
}

// Returns for each pixel whether the values differ by more than `share`.
std::vector<bool> different(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b, float share) {
    std::vector<bool> found(a.size());
    for (size_t i = 0; i < a.size(); ++i)
        found[i] = glm::any(glm::greaterThan(glm::abs(glm::vec3(a[i]) - glm::vec3(b[i])),
                                             share * glm::max(glm::vec3(b[i]), glm::vec3(1e-3f))));
    return found;
}

// Returns for each pixel of `found` whether it is brighter by half than all 3 × 3 pixels at its place in both
// pictures without specks.
std::vector<bool> brighter(const std::vector<glm::vec4>& found, const std::vector<glm::vec4>& now,
                           const std::vector<glm::vec4>& resolved) {
    const int width = int(kSpeckSize.width), height = int(kSpeckSize.height);
    std::vector<bool> is_brighter(found.size());
    for (int i = 0; i < width * height; ++i) {
        float most = 0;
        for (int k = 0; k < 9; ++k) {
            const int x = std::clamp(i % width + k % 3 - 1, 0, width - 1),
                      y = std::clamp(i / width + k / 3 - 1, 0, height - 1);
            most = std::max({most, now[size_t(y * width + x)].g, resolved[size_t(y * width + x)].g});
        }
        is_brighter[size_t(i)] = found[size_t(i)].g > 1.5f * most;
    }
    return is_brighter;
}

// Returns the number of pixels that are set in `found` and have no pixel of `near` at a distance of `reach`
// or less.
size_t count_far(const std::vector<bool>& found, const std::vector<bool>& near, int reach) {
    const int width = int(kSpeckSize.width), height = int(kSpeckSize.height);
    size_t far = 0;
    for (int i = 0; i < width * height; ++i) {
        if (!found[size_t(i)]) continue;
        bool is_near = false;
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const int column = i % width + x, row = i / width + y;
                if (column >= 0 && row >= 0 && column < width && row < height)
                    is_near = is_near || near[size_t(row * width + column)];
            }
        far += is_near ? 0 : 1;
    }
    return far;
}

TEST_F(BrightSpecks, TemporalAntiAliasingKeepsNoTrail) {
    Run glowing = begin(true, "taa", {"hdr", "resolved"}), dark = begin(false, "taa", {"hdr", "resolved"});
    ASSERT_TRUE(glowing.session && dark.session);
    size_t lit = 0, trail = 0;
    double ev_difference = 0, ev_step = 0;
    for (int frame = 0; frame < kSpeckFrames; ++frame) {
        const float before_ev = glowing.adaptation.exposure_ev;
        next_frame(glowing);
        next_frame(dark);
        expect_finite(glowing.pictures.at("resolved"), frame);
        const std::vector<bool> now = different(glowing.pictures.at("hdr"), dark.pictures.at("hdr"), 0.01f);
        lit += size_t(std::count(now.begin(), now.end(), true));
        trail += count_far(
            brighter(glowing.pictures.at("resolved"), dark.pictures.at("hdr"), dark.pictures.at("resolved")),
            now, 1);
        ev_difference = std::max(
            ev_difference, std::abs(double{glowing.adaptation.exposure_ev} - dark.adaptation.exposure_ev));
        if (frame > 0)
            ev_step = std::max(ev_step, std::abs(double{glowing.adaptation.exposure_ev} - before_ev));
    }
    std::printf(
        "%zu pixels of specks in %d frames, trails: %zu pixels; exposure: %.4f EV from that without "
        "specks, steps of at most %.4f EV\n",
        lit, kSpeckFrames, trail, ev_difference, ev_step);
    EXPECT_GT(lit, 20u * kSpeckFrames);
    EXPECT_EQ(trail, 0u);
    EXPECT_LT(ev_difference, 0.05);
    EXPECT_LT(ev_step, 0.02);
}

// The lens scatters the light of the specks over the picture. The sum of the scattered light must not depend
// much on where in its pixel a speck is, else the glow flickers.
TEST_F(BrightSpecks, BloomIsFiniteAndSteady) {
    Run glowing = begin(true, "bloom", {"hdr", "bloom.mip(0)"}),
        dark = begin(false, "bloom", {"hdr", "bloom.mip(0)"});
    ASSERT_TRUE(glowing.session && dark.session);
    std::vector<double> sums;
    for (int frame = 0; frame < kSpeckFrames; ++frame) {
        next_frame(glowing);
        next_frame(dark);
        expect_finite(glowing.pictures.at("hdr"), frame);
        expect_finite(glowing.pictures.at("bloom.mip(0)"), frame);
        double sum = 0;
        for (size_t i = 0; i < glowing.pictures.at("bloom.mip(0)").size(); ++i)
            sum += double{glowing.pictures.at("bloom.mip(0)")[i].g} - dark.pictures.at("bloom.mip(0)")[i].g;
        sums.push_back(sum);
    }
    const auto [least, most] = std::ranges::minmax(sums);
    std::printf("scattered light of the specks: %.1f to %.1f\n", least, most);
    EXPECT_GT(least, 0);
    EXPECT_LT(most, 1.5 * least);
}

// With the pre-exposure 0, the speck is brighter than the largest half float.
TEST_F(BrightSpecks, LightBeyondHalfFloatsIsFinite) {
    for (const auto& [graph, picture] : {std::pair("taa", "resolved"), std::pair("bloom", "hdr")}) {
        Run run = begin(true, graph, {picture}, 0.0f);
        ASSERT_TRUE(run.session);
        for (int frame = 0; frame < 2; ++frame) {
            next_frame(run);
            expect_finite(run.pictures.at(picture), frame);
            EXPECT_TRUE(std::isfinite(run.adaptation.exposure_ev));
        }
    }
}

// The light of the whole scene becomes 256 times as bright or as dark.
TEST_F(BrightSpecks, TheExposureFollowsAllLightWithoutSwinging) {
    const scene::Scene scene = specks_over_spheres(true);
    const std::unique_ptr<render::Session> session =
        start(scene, scene.cameras.at(0), kDeferredGraph, kSpeckSize, {"adaptation"}, scene.exposure_ev);
    ASSERT_TRUE(session);
    const Adaptation first = after_frame(*session, {}, 1.0 / 30);
    Adaptation state = first;
    for (const double stops : {8.0, -8.0}) {
        const float gain = float(std::exp2(stops));
        std::vector<scene::Light> lights = scene.lights;
        for (scene::Light& light : lights) light.intensity *= gain;
        frame_of(*session).lights = lights;
        frame_of(*session).sky = render::SkyColors{scene.sky_zenith * gain, scene.sky_horizon * gain};
        const double sign = stops > 0 ? 1 : -1;
        for (int i = 0; i < 24; ++i) {
            const float before_ev = state.adapted_ev;
            state = after_frame(*session, {}, 0.4);
            EXPECT_GE(sign * (state.adapted_ev - before_ev), -1e-6) << "frame " << i;
            EXPECT_LE(sign * (state.adapted_ev - state.metered_ev), 1e-6) << "frame " << i;
        }
        std::printf("light × 2^%.0f: the meter follows by %.3f EV\n", stops,
                    state.adapted_ev - first.adapted_ev);
        EXPECT_NEAR(state.adapted_ev - first.adapted_ev, stops, 0.05);
    }
}

}  // namespace
}  // namespace weft::test
