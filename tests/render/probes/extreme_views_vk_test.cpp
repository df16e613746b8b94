// Tests pictures with light probes from unusual places, and of a closed room of metal: each pixel is a finite
// number, and the light of the sky stays outside.
#include "tests/render/probes/picture_fixture.h"

namespace weft::test {
namespace {

constexpr float kSky = 4000;
const render::SkyColors kEvenSky{glm::vec3(kSky), glm::vec3(kSky), glm::vec3(kSky)};

class ExtremeViews : public ProbePicture {
 protected:
    struct Found {
        double most = 0, mean = 0, bright = 0;  // bright: the share of pixels above 2 % of the sky.
    };
    // Summarizes a picture. All channels must be finite and not negative.
    Found look(render::Session& session, const scene::Camera& camera) {
        const std::vector<glm::vec3> seen = picture(session, camera);
        EXPECT_EQ(seen.size(), size_t{kSize.x} * kSize.y);
        Found found;
        size_t wrong = 0;
        for (const glm::vec3& pixel : seen) {
            const double most = double{std::max({pixel.r, pixel.g, pixel.b})};
            wrong += glm::all(glm::greaterThanEqual(pixel, glm::vec3(0))) && std::isfinite(most) ? 0 : 1;
            found.most = std::max(found.most, most);
            found.mean += most / double(seen.size());
            found.bright += most > 0.02 * double{kSky} ? 1 / double(seen.size()) : 0;
        }
        EXPECT_EQ(wrong, 0u) << "pixels are negative or not finite";
        return found;
    }
};

// Nothing is brighter than white in the sun and under the sky.
TEST_F(ExtremeViews, FromEachPlaceThePictureIsFinite) {
    scene::test::BoxScene boxes = dark_room_beside_court();
    boxes.add({1.2f, 0, -0.6f}, {2.2f, 1, 0.6f});
    boxes.scene.lights = {sun_from({-0.4f, -1, -0.3f}, 50'000)};
    const std::unique_ptr<render::Session> session = begin(boxes.scene, placed(boxes.scene, 200), kEvenSky);
    ASSERT_TRUE(session);
    struct View {
        const char* name;
        glm::vec3 eye, at;
        bool is_dark;  // The camera is in the dark room.
    };
    const std::array views{View{"far outside", {150, 60, -90}, {0, 0, 0}, false},
                           View{"just outside", {kRoomLong + 0.4f, 3, 0}, {0, 1, 0}, false},
                           View{"below", {2, -30, 1}, {0, 0, 0}, false},
                           View{"at a wall of the court", {0.1f, 1.2f, 0.3f}, {0, 1.2f, 0.3f}, false},
                           View{"along a wall of the court", {0.1f, 1.2f, -1.8f}, {0.1f, 1.1f, 2}, false},
                           View{"at a wall of the dark room", {-0.1f, 1.2f, 0.3f}, {0, 1.2f, 0.3f}, true},
                           View{"in a corner of the dark room", {-0.1f, 0.05f, -1.95f}, {-2, 1, 1}, true},
                           View{"in a box", {1.7f, 0.5f, 0}, {0, 0.5f, 0}, false},
                           View{"in the wall", {0, 1.2f, 0}, {-2, 1, 1}, true}};
    const double most = 1.5 * (50'000 / std::numbers::pi + double{kSky});
    for (const View& view : views) {
        const Found found = look(*session, camera_at(view.eye, view.at));
        std::printf("%s: mean %.2f, at most %.1f, %.2f %% bright\n", view.name, found.mean, found.most,
                    100 * found.bright);
        EXPECT_LT(found.most, most) << view.name;
        EXPECT_GT(found.most, 0) << view.name;
        if (!view.is_dark) continue;
        EXPECT_LT(found.mean, 1e-3 * double{kSky}) << view.name;
        // At the foot of a wall, some pixels are brighter: all probes of their cell seem to be hidden.
        EXPECT_LT(found.bright, 0.002) << view.name;
    }
}

// Metal reflects nearly all light, so a leak would add up with each reflection. A lamp in the room shows that
// the room is not dark for another reason.
TEST_F(ExtremeViews, TheSkyDoesNotShineIntoAClosedRoomOfMetal) {
    scene::test::BoxScene boxes;
    boxes.add_room({-2, 0, -1.5f}, {2, 2.4f, 1.5f}, 0.1f);
    boxes.add({0.5f, 0, -0.4f}, {1.2f, 0.8f, 0.3f});
    scene::Scene& scene = boxes.scene;
    const std::array metals{add_metal(scene, glm::vec3(0.95f), 0), add_metal(scene, glm::vec3(0.95f), 0.1f),
                            add_metal(scene, glm::vec3(0.95f), 0.5f), add_metal(scene, glm::vec3(0.95f), 1)};
    for (size_t i = 0; i < scene.instances.size(); ++i)
        scene.instances[i].material = metals[i % metals.size()];
    scene.lights = {sun_from({-0.4f, -1, -0.3f}, 50'000)};
    const std::unique_ptr<render::Session> session =
        begin(scene, placed(scene, scene::kMostIrradianceProbes), kEvenSky);
    ASSERT_TRUE(session);
    const std::array cameras{camera_at({-1.6f, 1.4f, 1.2f}, {1, 0.8f, -0.5f}),
                             camera_at({1.95f, 0.3f, -1.4f}, {-1, 1, 1}),
                             camera_at({0, 1.2f, 0}, {0, 2.4f, 0})};
    for (const scene::Camera& camera : cameras) {
        const double dark = look(*session, camera).most;
        std::printf("closed room of metal: at most %.4f, the sky %.0f\n", dark, double{kSky});
        EXPECT_LT(dark, 0.02 * double{kSky});
    }
    scene::Light lamp;
    lamp.position = {-0.5f, 1.8f, 0};
    lamp.intensity = 500;
    frame_of(*session).lights = scene.lights;
    frame_of(*session).lights->push_back(lamp);
    for (const scene::Camera& camera : cameras) EXPECT_GT(look(*session, camera).most, 10);
}

}  // namespace
}  // namespace weft::test
