// Deferred shading reads a surface from the G-buffer; forward shading uses the surface itself. Tests that
// their difference in each pixel stays within the bound that the formats of the G-buffer imply
// (docs/precision.md).
#include <algorithm>
#include <functional>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/reference_ambient.h"
#include "tests/render/shading/reference_brdf.h"
#include "tests/render/shading/reference_light.h"

namespace weft::test {
namespace {

constexpr Extent3D kPrecisionSize{160, 90, 1};

// The values that the G-buffer stores for one pixel, as shaders read them. `base_root` and `f0_root` are the
// square roots of the base colour and of the dielectric F0. `position` is computed from the depth.
struct Stored {
    glm::dvec3 base_root{0};
    double occlusion = 1, roughness = 1, metalness = 0;
    glm::dvec3 f0_root{0};
    double specular = 1;
    glm::dvec3 normal{0, 1, 0};
    glm::dvec3 position{0};
};

// Largest errors of the stored values. kHalfStep: half a step of an 8-bit number. kNormalRad: 0.0037° for an
// octahedral normal of two 16-bit numbers. kDepthShare: relative error of a distance that is computed from a
// float depth with a matrix.
constexpr double kHalfStep = 0.5 / 255, kNormalRad = 0.0037 * kPi / 180, kDepthShare = 4e-6;
// Relative error of two roundings to half floats (2/2048), plus the error of about a hundred float operations
// (2e-4).
constexpr double kRounding = 2.0 / 2048 + 2e-4;
// bound() changes one stored number at a time and adds the effects. If several numbers change together, the
// effect can be larger than this sum. This factor allows a quarter more.
constexpr double kTogether = 1.25;

// The mean radiance of the gradient sky that a surface mirrors, and the directional albedo, on grids of
// values.
class Ambient {
 public:
    explicit Ambient(const scene::Scene& scene) {
        for (int channel = 0; channel < 3; ++channel) {
            const CubeSum cube = cube_sum([&](const glm::dvec3& w) { return sky(scene, w)[channel]; });
            for (int r = 0; r <= kSteps; ++r)
                for (int y = 0; y <= kSteps; ++y) {
                    const double height = 2.0 * y / kSteps - 1;
                    const glm::dvec3 n(std::sqrt(1 - height * height), height, 0);
                    // For smaller roughnesses, the texels of the sum are too large; the sky is smooth there.
                    mirrored_[size_t(r)][size_t(y)][channel] =
                        r * 0.05 < 0.15 ? sky(scene, n)[channel] : filtered(cube, n, r * 0.05);
                }
        }
        for (int r = 0; r <= kSteps; ++r)
            for (int c = 0; c <= kSteps; ++c)
                albedo_[size_t(r)][size_t(c)] =
                    reference_albedo(r * 0.05, std::max(c * c / double(kSteps * kSteps), 1e-3), 40, 8);
    }
    [[nodiscard]] glm::dvec3 mirrored(double height, double roughness) const {
        return between(mirrored_, roughness, 0.5 + 0.5 * height);
    }
    [[nodiscard]] glm::dvec2 albedo(double roughness, double n_v) const {
        return between(albedo_, roughness, std::sqrt(n_v));
    }

 private:
    static constexpr int kSteps = 20;
    template <typename T>
    using Grid = std::array<std::array<T, kSteps + 1>, kSteps + 1>;

    static glm::dvec3 sky(const scene::Scene& scene, const glm::dvec3& w) {
        const glm::dvec3 zenith(scene.sky_zenith), horizon(scene.sky_horizon);
        if (w.y >= 0) return glm::mix(horizon, zenith, std::sqrt(w.y));
        const double t = std::clamp(-w.y / 0.15, 0.0, 1.0);
        return glm::mix(horizon, horizon * 0.25, t * t * (3 - 2 * t));
    }
    template <typename T>
    static T between(const Grid<T>& grid, double row, double column) {
        const double r = std::clamp(row, 0.0, 1.0) * kSteps, c = std::clamp(column, 0.0, 1.0) * kSteps;
        const auto i = std::min(size_t(r), size_t(kSteps - 1)), k = std::min(size_t(c), size_t(kSteps - 1));
        return glm::mix(glm::mix(grid[i][k], grid[i][k + 1], c - double(k)),
                        glm::mix(grid[i + 1][k], grid[i + 1][k + 1], c - double(k)), r - double(i));
    }

    Grid<glm::dvec3> mirrored_;  // First index: 20 × roughness. Second: height of the direction.
    Grid<glm::dvec2> albedo_;    // First index: 20 × roughness. Second: 20 × √(n·v).
};

struct View {
    const Ambient* ambient = nullptr;
    std::vector<shared::Light> lights;
    glm::dvec3 eye{0};
};

glm::dvec3 radiance(const Stored& p, const View& view) {
    ReferenceSurface s;
    s.normal = p.normal;
    s.base_color = p.base_root * p.base_root;
    s.metallic = p.metalness;
    s.roughness = p.roughness;
    s.dielectric_f0 = p.f0_root * p.f0_root;
    s.specular = p.specular;
    const glm::dvec3 v = glm::normalize(view.eye - p.position);
    const double n_v = std::clamp(glm::dot(s.normal, v), 0.0, 1.0);
    const glm::dvec2 albedo = view.ambient->albedo(p.roughness, n_v);
    const glm::dvec3 f0 = glm::mix(s.dielectric_f0 * s.specular, s.base_color, s.metallic);
    s.energy = 1.0 + f0 * (1 / (albedo.x + albedo.y) - 1);
    glm::dvec3 sum(0);
    for (const shared::Light& light : view.lights) {
        glm::dvec3 l;
        const glm::dvec3 e = incident(light, p.position, l);
        if (e != glm::dvec3(0)) sum += reflected(s, v, l) * e;
    }
    const glm::dvec3 mirror =
        (f0 * albedo.x + glm::dvec3(glm::mix(s.specular, 1.0, s.metallic) * albedo.y)) * s.energy;
    const glm::dvec3 matt = s.base_color * (1 - s.metallic) * (1 - std::max({mirror.x, mirror.y, mirror.z}));
    const double alpha = p.roughness * p.roughness, shift = (1 - alpha) * (std::sqrt(1 - alpha) + alpha);
    const glm::dvec3 middle = glm::normalize(glm::mix(s.normal, glm::reflect(-v, s.normal), shift));
    return sum + p.occlusion * (matt * view.ambient->mirrored(s.normal.y, 1) +
                                mirror * view.ambient->mirrored(middle.y, p.roughness));
}

// Returns the bound of the error. Each stored number is changed by its largest error, once up and once down,
// while the other numbers stay the same. The larger change of the radiance counts. The bound is the sum of
// these changes over all numbers, times kTogether.
glm::dvec3 bound(const Stored& p, const View& view) {
    const glm::dvec3 stored = radiance(p, view);
    glm::dvec3 sum(0);
    const auto vary = [&](const std::function<void(Stored&, double)>& move) {
        glm::dvec3 most(0);
        for (const double sign : {-1.0, 1.0}) {
            Stored moved = p;
            move(moved, sign);
            most = glm::max(most, glm::abs(radiance(moved, view) - stored));
        }
        sum += most;
    };
    const auto step = [](double& number, double sign) {
        number = std::clamp(number + sign * kHalfStep, 0.0, 1.0);
    };
    for (int c = 0; c < 3; ++c) vary([&](Stored& s, double sign) { step(s.base_root[c], sign); });
    for (int c = 0; c < 3; ++c) vary([&](Stored& s, double sign) { step(s.f0_root[c], sign); });
    vary([&](Stored& s, double sign) { step(s.specular, sign); });
    vary([&](Stored& s, double sign) { step(s.occlusion, sign); });
    vary([&](Stored& s, double sign) { step(s.roughness, sign); });
    vary([&](Stored& s, double sign) { step(s.metalness, sign); });
    const glm::dvec3 aside = glm::normalize(
        glm::cross(p.normal, std::abs(p.normal.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
    for (const glm::dvec3& axis : {aside, glm::cross(p.normal, aside)})
        vary([&](Stored& s, double sign) {
            s.normal = glm::normalize(p.normal + axis * (sign * kNormalRad));
        });
    const glm::dvec3 away = (p.position - view.eye) * kDepthShare;
    vary([&](Stored& s, double sign) { s.position += away * sign; });
    return sum * kTogether;
}

Stored stored_at(const Rendered& r, size_t i, const glm::dmat4& to_world) {
    const glm::dvec4 orm = r.images.at("orm")[i], coat = r.images.at("specular")[i];
    const double u = (double(i % kPrecisionSize.width) + 0.5) / kPrecisionSize.width,
                 v = (double(i / kPrecisionSize.width) + 0.5) / kPrecisionSize.height;
    const glm::dvec4 world = to_world * glm::dvec4(u * 2 - 1, v * 2 - 1, r.images.at("depth")[i].r, 1);
    Stored p;
    p.base_root = glm::dvec3(r.images.at("albedo")[i]);
    p.occlusion = orm.r;
    p.roughness = orm.g;
    p.metalness = orm.b;
    p.f0_root = glm::dvec3(coat);
    p.specular = coat.a;
    p.normal = octahedral_normal(r.images.at("normal")[i]);
    p.position = glm::dvec3(world) / world.w;
    return p;
}

class Precision : public SessionTest {};

TEST_F(Precision, DeferredIsAsFarFromForwardAsTheGBufferAllows) {
    for (const char* name : {"spheres", "cornell", "atrium", "brushed"}) {
        SCOPED_TRACE(name);
        Result<scene::Scene> scene = scene::make_builtin(name);
        ASSERT_TRUE(scene);
        std::erase_if(scene->instances, [&](const scene::Instance& i) {
            return scene->materials[i.material].alpha_mode == scene::AlphaMode::blend;
        });
        const scene::Camera camera = scene->cameras.at(0);
        const Rendered deferred = render(*scene, camera, kPrecisionSize, scene->exposure_ev,
                                         {"albedo", "normal", "orm", "specular", "depth", "hdr"});
        const Rendered forward = render(*scene, camera, kPrecisionSize, scene->exposure_ev, {"hdr"},
                                        WEFT_SOURCE_DIR "/graphs/forward.json");
        ASSERT_EQ(deferred.images.size(), 6u);
        ASSERT_EQ(forward.images.size(), 1u);
        const Ambient ambient(*scene);
        const View view{&ambient, deferred.lights, glm::dvec3(deferred.view.eye)};
        const glm::dmat4 to_world =
            glm::inverse(glm::dmat4(deferred.view.projection) * glm::dmat4(deferred.view.view));
        const double gain = deferred.pre_exposure;
        size_t surfaces = 0, beyond = 0;
        double worst_use = 0, widest = 0;
        for (size_t i = 0; i < deferred.images.at("hdr").size(); ++i) {
            if (deferred.images.at("depth")[i].r <= 0) continue;
            ++surfaces;
            const glm::dvec3 a(deferred.images.at("hdr")[i]), b(forward.images.at("hdr")[i]);
            // The constant 1.2e-7 is two steps of the smallest half floats, 2⁻²⁴ each.
            const glm::dvec3 allowed =
                bound(stored_at(deferred, i, to_world), view) * gain + glm::max(a, b) * kRounding + 1.2e-7;
            for (int c = 0; c < 3; ++c) {
                worst_use = std::max(worst_use, std::abs(a[c] - b[c]) / allowed[c]);
                widest = std::max(widest, std::abs(a[c] - b[c]) / std::max(a[c], 1e-3));
                beyond += std::abs(a[c] - b[c]) > allowed[c] ? 1 : 0;
            }
        }
        std::printf("%s: %zu surface pixels, at most %.2f of the bound used, largest difference %.2f %%\n",
                    name, surfaces, worst_use, widest * 100);
        EXPECT_GT(surfaces, 3000u);
        EXPECT_EQ(beyond, 0u);
    }
}

}  // namespace
}  // namespace weft::test
