// Tests the reflections of a flat mirror: they must be the picture that a mirrored camera sees. The objects
// emit light, so their colours are the same from both cameras.
#include <algorithm>
#include <cmath>

#include "tests/render/reflections/reflection_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kMirrorSize{640, 360, 1};
constexpr int kMirrorFrames = 8;
constexpr float kSky = 0.2f;
// A pixel is covered from this confidence on. At the outline of a mirrored object, the texels of a reflection
// with half the resolution contain the mean of the object and of what is beside it.
constexpr float kLeastConfidence = 0.3f;
// Pixels closer to the edge of the picture than this share of it are left out, because reflections fade
// there.
constexpr float kFadingEdge = 0.06f;

scene::Scene objects_on_floor(bool with_floor) {
    scene::Scene scene;
    scene.sky_zenith = scene.sky_horizon = glm::vec3(kSky);
    if (with_floor) add_box(scene, {-6, -0.1f, -6}, {6, 0, 6}, metal(0));
    add_box(scene, {-1.4f, 0, -1.2f}, {-0.6f, 0.9f, -0.5f}, emitter({0.9f, 0.2f, 0.1f}));
    add_box(scene, {0.5f, 0, -0.4f}, {1.0f, 0.6f, 0.1f}, emitter({0.1f, 0.8f, 0.3f}));
    add_box(scene, {-0.3f, 0.5f, -1.9f}, {0.4f, 1.1f, -1.6f}, emitter({0.2f, 0.3f, 0.9f}));
    // A fence of thin bars.
    for (int i = 0; i < 6; ++i) {
        const float x = -0.5f + 0.16f * float(i);
        add_box(scene, {x, 0, 0.2f}, {x + 0.06f, 0.4f, 0.26f}, emitter(glm::vec3(0.1f + 0.15f * float(i))));
    }
    return scene;
}

class FlatMirror : public ReflectionTest {
 protected:
    struct Agreement {
        size_t both = 0, covered = 0;
        double psnr_db = 0;
    };
    Agreement agreement(const glm::vec3& eye, const glm::vec3& at, double scale) {
        params_["ssrScale"] = scale;
        const glm::vec3 flip{1, -1, 1};
        const LastFrame seen = draw(objects_on_floor(true), scene::camera_looking_at(eye, at, 0.75f),
                                    kMirrorSize, kMirrorFrames, {"depth", "ssr.layer(0)"});
        params_.erase("ssrScale");
        const LastFrame mirrored =
            draw(objects_on_floor(false), scene::camera_looking_at(eye * flip, at * flip, 0.75f), kMirrorSize,
                 1, {"depth"}, graph_path("deferred"));
        return compared(seen, mirrored, int(scale));
    }
    static Agreement compared(const LastFrame& seen, const LastFrame& mirrored, int scale) {
        const int width = int(kMirrorSize.width), height = int(kMirrorSize.height);
        Agreement found;
        double squares = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const size_t here = size_t(y * width + x), there = size_t((height - 1 - y) * width + x);
                const float depth = seen.images.at("depth")[here].r,
                            far = mirrored.images.at("depth")[there].r;
                if (depth <= 0 || std::abs(place_at(seen.view, x, y, depth).y) > 1e-3f || far <= 0) continue;
                if (!shows(seen, place_at(mirrored.view, x, height - 1 - y, far))) continue;
                ++found.both;
                if (confidence(seen.images.at("ssr.layer(0)"), x, y, scale) < kLeastConfidence) continue;
                ++found.covered;
                const glm::vec3 off = seen.output[here] - mirrored.output[there];
                squares += double(glm::dot(off, off)) / 3;
            }
        }
        found.psnr_db = -10 * std::log10(squares / double(found.covered));
        return found;
    }
    // Returns the confidence at a pixel, as the lighting pass interpolates it on a flat surface.
    static float confidence(const std::vector<glm::vec4>& light, int x, int y, int scale) {
        const int columns = (int(kMirrorSize.width) + scale - 1) / scale, rows = int(light.size()) / columns;
        const auto texel = [&](int u, int v) {
            return light[size_t(std::min(v, rows - 1) * columns + std::min(u, columns - 1))].a;
        };
        const float dx = float(x % scale) / float(scale), dy = float(y % scale) / float(scale);
        const int u = x / scale, v = y / scale;
        return glm::mix(glm::mix(texel(u, v), texel(u + 1, v), dx),
                        glm::mix(texel(u, v + 1), texel(u + 1, v + 1), dx), dy);
    }
    // Returns true if the frame shows a place, not too close to the edge of the picture.
    static bool shows(const LastFrame& frame, const glm::vec3& place) {
        const glm::vec4 clip = frame.view.view_projection * glm::vec4(place, 1);
        const glm::vec2 uv = glm::vec2(clip) / clip.w * 0.5f + 0.5f;
        if (glm::any(glm::lessThan(uv, glm::vec2(kFadingEdge))) ||
            glm::any(glm::greaterThan(uv, glm::vec2(1 - kFadingEdge))))
            return false;
        const int x = int(uv.x * float(kMirrorSize.width)), y = int(uv.y * float(kMirrorSize.height));
        const float depth = frame.images.at("depth")[size_t(y) * kMirrorSize.width + size_t(x)].r;
        return depth > 0 && glm::distance(place_at(frame.view, x, y, depth), place) < 0.03f;
    }
    void expect_mirror(double scale, double least_psnr_db, const glm::vec3& eye = {0.2f, 1.1f, 3.4f},
                       const glm::vec3& at = {0, 0.25f, -0.4f}) {
        const Agreement found = agreement(eye, at, scale);
        ASSERT_GT(found.both, size_t{8000});
        const double coverage = double(found.covered) / double(found.both);
        std::printf("%g px a texel: %zu pixels, coverage %.4f, PSNR %.1f dB\n", scale, found.both, coverage,
                    found.psnr_db);
        EXPECT_GE(coverage, 0.98);
        EXPECT_GE(found.psnr_db, least_psnr_db);
    }
};

TEST_F(FlatMirror, ShowsWhatAMirroredCameraSees) {
    expect_mirror(1, 35);
}

// The rays of a level camera are exactly vertical lines in the picture.
TEST_F(FlatMirror, ShowsItToALevelCamera) {
    expect_mirror(1, 35, {0.2f, 0.8f, 3.4f}, {0.2f, 0.8f, -0.4f});
}

TEST_F(FlatMirror, ShowsItAtHalfResolution) {
    expect_mirror(2, 30);
}

}  // namespace
}  // namespace weft::test
