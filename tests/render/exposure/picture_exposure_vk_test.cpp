// Tests the exposure of the pictures of the shipped graphs: deferred and forward shading agree, the stored
// values stay as they are, and a fixed exposure gives the picture of a graph without the module.
#include <algorithm>
#include <cmath>

#include "tests/render/exposure/exposure_fixture.h"

namespace weft::test {
namespace {

class PictureExposure : public ExposureTest {
 protected:
    static constexpr Extent3D kSize{160, 90, 1};

    // Renders one frame of a shipped graph.
    std::unique_ptr<render::Session> picture(const scene::Scene& scene, const std::string& graph,
                                             bool automatic, std::vector<std::string> observed,
                                             const FileReader& reader = read_text) {
        std::unique_ptr<render::Session> session = start(scene, scene.cameras.at(0), graph_path(graph), kSize,
                                                         std::move(observed), scene.exposure_ev, reader);
        if (!session) return nullptr;
        if (!automatic) frame_of(*session).parameters["autoExposure"] = 0;
        EXPECT_TRUE(draw_frame(*session));
        EXPECT_TRUE(session->finish());
        return session;
    }
};

// Reads a file. Removes the module from the shipped graphs.
std::optional<std::string> read_without_module(const std::string& path) {
    std::optional<std::string> text = read_text(path);
    for (const std::string part : {", \"modules/exposure.json\"", ", \"adaptation\""})
        if (text && path.ends_with(".json"))
            while (text->find(part) != std::string::npos) text->erase(text->find(part), part.size());
    return text;
}

TEST_F(PictureExposure, AFixedExposureGivesThePictureWithoutTheModule) {
    const Result<scene::Scene> scene = scene::make_builtin("mirror");
    ASSERT_TRUE(scene);
    for (const char* graph : {"forward", "edges"}) {
        SCOPED_TRACE(graph);
        const auto fixed = picture(*scene, graph, false, {"hdr"}),
                   automatic = picture(*scene, graph, true, {"hdr"}),
                   plain = picture(*scene, graph, true, {"hdr"},
                                   [](const std::string&path) { return read_without_module(path); });
        ASSERT_TRUE(fixed && automatic && plain);
        EXPECT_EQ(find_resource(plain->plan().graph, "adaptation"), kNoId) << "the module is removed";
        EXPECT_TRUE(output_of(*fixed) == output_of(*plain));
        EXPECT_FALSE(output_of(*automatic) == output_of(*plain));
        const auto stored = automatic->take_readbacks(), stored_plain = plain->take_readbacks();
        ASSERT_TRUE(stored.size() == 1 && stored_plain.size() == 1);
        EXPECT_TRUE(stored[0].bytes == stored_plain[0].bytes) << "hdr is stored with the pre-exposure";
    }
}

TEST_F(PictureExposure, DeferredAndForwardAgree) {
    for (const char* name : {"spheres", "cornell"}) {
        SCOPED_TRACE(name);
        const Result<scene::Scene> scene = scene::make_builtin(name);
        ASSERT_TRUE(scene);
        const auto deferred = picture(*scene, "deferred", true, {"adaptation"}),
                   forward = picture(*scene, "forward", true, {"adaptation"});
        ASSERT_TRUE(deferred && forward);
        const float deferred_ev = adaptation_of(deferred->take_readbacks()).exposure_ev,
                    forward_ev = adaptation_of(forward->take_readbacks()).exposure_ev;
        std::printf("%s: exposure %.3f EV deferred, %.3f EV forward; the scene suggests %.1f EV\n", name,
                    deferred_ev, forward_ev, scene->exposure_ev);
        EXPECT_NEAR(deferred_ev, forward_ev, 0.02);
        EXPECT_NEAR(deferred_ev, scene->exposure_ev, 1.5);
    }
}

TEST_F(PictureExposure, SwitchingItOffAndOnContinues) {
    const std::unique_ptr<render::Session> session = start_meter();
    ASSERT_TRUE(session);
    const Adaptation first = after_frame(*session, {{"dark", 32}, {"bright", 32}, {"brighter_s", 1}}, 0.1);
    const std::vector<std::byte> adapted = output_of(*session);
    EXPECT_NEAR(std::to_integer<int>(adapted.at(0)), shown(32 * std::exp2(first.exposure_ev)), 1);
    const Adaptation off = after_frame(*session, {{"autoExposure", 0}, {"gain", 2}}, 0.1);
    EXPECT_EQ(off.adapted_ev, first.adapted_ev) << "nothing is metered";
    EXPECT_NEAR(std::to_integer<int>(output_of(*session).at(0)), shown(64 * std::exp2(kStored_ev)), 1);
    const Adaptation again = after_frame(*session, {{"autoExposure", 1}, {"gain", 4}}, 1);
    EXPECT_NEAR(again.adapted_ev, again.metered_ev + (first.adapted_ev - again.metered_ev) * std::exp(-1),
                1e-4);
}

// Returns for each sunlit pixel the part that the lamps add to its light, in ascending order. `radiance` and
// `sun_only` are the values of hdr with and without lamps, `least` is the least sunlit value.
std::vector<double> parts_of_lamps(const std::vector<glm::vec4>& radiance,
                                   const std::vector<glm::vec4>& sun_only, float least) {
    std::vector<double> parts;
    for (size_t i = 0; i < radiance.size(); ++i)
        if (sun_only[i].g >= least) parts.push_back(radiance[i].g / sun_only[i].g - 1.0);
    std::ranges::sort(parts);
    return parts;
}

// The lamps of a scene have fixed intensities, so at noon they add little to walls in the sun.
TEST_F(PictureExposure, LampsAddLittleToSunlitWallsAtNoon) {
    scene::BuiltinOptions noon, night;
    noon.hour = 12.0f;
    night.hour = 22.0f;
    Result<scene::Scene> scene = scene::make_builtin("atrium", noon);
    const Result<scene::Scene> dark = scene::make_builtin("atrium", night);
    ASSERT_TRUE(scene && dark && scene->lights.size() == dark->lights.size());
    scene->sky_zenith = scene->sky_horizon = glm::vec3(0);  // as with --env none
    const float least = 400 * std::exp2(scene->exposure_ev);
    // All lamps are on, also those that are off at noon.
    std::vector<scene::Light> lights = dark->lights;
    lights[0] = scene->lights[0];
    for (size_t i = 1; i < lights.size(); ++i)
        EXPECT_TRUE(scene->lights[i].intensity == 0 || scene->lights[i].intensity == lights[i].intensity);
    const scene::Camera& court = scene->cameras.at(0);
    scene->lights = lights;
    const Rendered lamps = render(*scene, court, kSize, scene->exposure_ev, {"hdr"});
    scene->lights.resize(1);
    const Rendered sun = render(*scene, court, kSize, scene->exposure_ev, {"hdr"});
    ASSERT_TRUE(lamps.images.contains("hdr") && sun.images.contains("hdr"));
    const std::vector<double> parts = parts_of_lamps(lamps.images.at("hdr"), sun.images.at("hdr"), least);
    ASSERT_GT(parts.size(), 2000u);
    const double most = parts[parts.size() * 99 / 100];
    std::printf("lamps add at most %.2f %% to 99 %% of %zu sunlit pixels, and %.2f %% beside a lamp\n",
                100 * most, parts.size(), 100 * parts.back());
    EXPECT_LT(most, 0.02);
    EXPECT_GT(most, 0) << "the lamps are on";
    EXPECT_LT(parts.back(), 0.1) << "a candle on the rim of the pool, 0.1 m from the stone";
}

}  // namespace
}  // namespace weft::test
