// Tests the light on a rough metal floor before a striped wall against an integral over the lobe, computed on
// the CPU by tracing rays through the same boxes. No single ray may leave a bright speck.
#include <algorithm>
#include <cmath>
#include <random>

#include "tests/render/reflections/reflection_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kRoughSize{320, 180, 1};
constexpr int kRoughFrames = 32;
constexpr double kSkyRadiance = 0.1;
constexpr unsigned kSeed = 20261128;

struct Emitter {
    glm::dvec3 least, most;
    double radiance;
};

// The wall, and stripes before it.
std::vector<Emitter> emitters() {
    std::vector<Emitter> found{{{-2.4, 0, -2.1}, {2.4, 1.3, -2}, 0.2}};
    for (int i = -6; i <= 5; ++i) found.push_back({{0.4 * i, 0, -2}, {0.4 * i + 0.2, 1.1, -1.95}, 0.6});
    return found;
}

scene::Scene rough_floor(float roughness) {
    scene::Scene scene;
    scene.sky_zenith = scene.sky_horizon = glm::vec3(float(kSkyRadiance));
    add_box(scene, {-4, -0.1f, -4}, {4, 0, 4}, metal(roughness));
    for (const Emitter& box : emitters())
        add_box(scene, glm::vec3(box.least), glm::vec3(box.most), emitter(glm::vec3(float(box.radiance))));
    return scene;
}

double radiance_along(const glm::dvec3& from, const glm::dvec3& direction) {
    double nearest = 1e30, radiance = kSkyRadiance;
    for (const Emitter& box : emitters()) {
        double enter = 1e-6, leave = 1e30;
        for (int axis = 0; axis < 3; ++axis) {
            const double a = (box.least[axis] - from[axis]) / direction[axis],
                         b = (box.most[axis] - from[axis]) / direction[axis];
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        if (enter > leave || enter > nearest) continue;
        nearest = enter;
        radiance = box.radiance;
    }
    return radiance;
}

// Returns the radiance that a metal floor (y = 0, F = 1, single reflections) sends to the eye: GGX with
// height-correlated Smith masking and shadowing. The half vectors of the rays are distributed by D · cosine.
double reflected(const glm::dvec3& place, const glm::dvec3& eye, double roughness, std::mt19937& random) {
    constexpr int kRays = 5000;
    const double alpha = roughness * roughness;
    const glm::dvec3 v = glm::normalize(eye - place);
    const auto lambda = [&](double cosine) {
        return (std::sqrt(1 + alpha * alpha * (1 / (cosine * cosine) - 1)) - 1) / 2;
    };
    std::uniform_real_distribution<double> unit(0, 1);
    double sum = 0;
    for (int i = 0; i < kRays; ++i) {
        const double u = unit(random), turn = 2 * 3.14159265358979 * unit(random);
        const double tangent = alpha * std::sqrt(u / (1 - u)), up = 1 / std::sqrt(1 + tangent * tangent);
        const glm::dvec3 h(up * tangent * std::cos(turn), up, up * tangent * std::sin(turn));
        const double vh = glm::dot(v, h);
        const glm::dvec3 l = 2 * vh * h - v;
        if (l.y <= 0 || vh <= 0) continue;
        sum += vh / (v.y * h.y) / (1 + lambda(v.y) + lambda(l.y)) * radiance_along(place, l);
    }
    return sum / kRays;
}

class RoughFloor : public ReflectionTest {
 protected:
    struct Errors {
        double sum = 0, mean = 0, most_speck = 0;
        int points = 0;
    };
    Errors errors_of(float roughness) {
        params_["multipleScattering"] = 0;
        const glm::vec3 eye(0, 1.0f, 2.6f);
        const LastFrame last =
            draw(rough_floor(roughness), scene::camera_looking_at(eye, {0, 0.3f, -1}, 0.8f), kRoughSize,
                 kRoughFrames, {"hdr", "depth"});
        std::mt19937 random(kSeed);
        Errors found;
        double total = 0, reference = 0;
        for (int y = 100; y < 165; y += 8) {
            for (int x = 60; x < 260; x += 20) {
                const size_t at = size_t(y) * kRoughSize.width + size_t(x);
                const glm::vec3 place = place_at(last.view, x, y, last.images.at("depth")[at].r);
                if (std::abs(place.y) > 1e-3f) continue;
                const double expected = reflected(place, eye, double(roughness), random);
                const double light = double(last.images.at("hdr")[at].g / last.pre_exposure);
                total += light;
                reference += expected;
                found.mean += std::abs(light - expected);
                found.most_speck = std::max(found.most_speck, light / expected);
                ++found.points;
            }
        }
        found.sum = total / reference - 1;
        found.mean /= reference;
        return found;
    }
};

TEST_F(RoughFloor, ReflectsTheIntegralOverTheLobe) {
    for (const float roughness : {0.1f, 0.2f, 0.3f, 0.5f}) {
        const Errors found = errors_of(roughness);
        std::printf(
            "roughness %.1f, %d points: sum %+.4f, mean difference %.4f, brightest %.2f times the integral\n",
            double(roughness), found.points, found.sum, found.mean, found.most_speck);
        EXPECT_GT(found.points, 40);
        EXPECT_LE(std::abs(found.sum), 0.025);
        EXPECT_LE(found.mean, 0.06);
        EXPECT_LE(found.most_speck, 3);
    }
}

}  // namespace
}  // namespace weft::test
