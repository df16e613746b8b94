// Tests the exposure of the pictures of the shipped graphs: deferred and forward shading agree, the stored
// values stay as they are, and a fixed exposure gives the picture of a graph without the module.
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
    for (const std::string part : {"\"include\": [\"modules/exposure.json\"],", ", \"adaptation\""})
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

}  // namespace
}  // namespace weft::test
