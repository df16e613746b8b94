// Deferred shading reads a surface from the G-buffer; forward shading uses the surface itself. Tests that
// their difference in each pixel stays within the bound that the formats of the G-buffer imply
// (docs/precision.md).
#include <algorithm>
#include <functional>
#include <glm/gtc/packing.hpp>

#include "tests/render/light/sunny_spheres.h"
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

glm::dvec3 gradient_sky(const scene::Scene& scene, const glm::dvec3& w) {
    const glm::dvec3 zenith(scene.sky_zenith), horizon(scene.sky_horizon);
    if (w.y >= 0) return glm::mix(horizon, zenith, std::sqrt(w.y));
    const double t = std::clamp(-w.y / 0.15, 0.0, 1.0);
    return glm::mix(horizon, horizon * 0.25, t * t * (3 - 2 * t));
}

// Returns the value of the picture for lighting, which does not contain the suns.
glm::dvec3 picture_light(const scene::LightPicture& picture, const glm::dvec3& w) {
    const double x = (0.5 + std::atan2(w.x, -w.z) / (2 * kPi)) * picture.width_px - 0.5,
                 y = std::acos(std::clamp(w.y, -1.0, 1.0)) / kPi * picture.height_px - 0.5;
    const auto texel = [&](double column, double row) {
        const auto width = int64_t{picture.width_px}, height = int64_t{picture.height_px};
        const auto i = size_t((int64_t(column) + width) % width),
                   k = size_t(std::clamp(int64_t(row), int64_t{0}, height - 1));
        return glm::dvec3(glm::unpackF3x9_E1x5(picture.mips[0][k * picture.width_px + i])) *
               double(picture.scale);
    };
    const double column = std::floor(x), row = std::floor(y);
    return glm::mix(glm::mix(texel(column, row), texel(column + 1, row), x - column),
                    glm::mix(texel(column, row + 1), texel(column + 1, row + 1), x - column), y - row);
}

// The mean radiance of the surroundings that a surface mirrors, and the directional albedo, on grids of
// values.
class Ambient {
 public:
    // The gradient sky looks the same in all horizontal directions, a picture does not.
    explicit Ambient(const scene::Scene& scene)
        : radiance_([&scene](const glm::dvec3& w) {
              const scene::LightPicture& picture = scene.environment.light;
              return picture.mips.empty() ? gradient_sky(scene, w) : picture_light(picture, w);
          }),
          azimuths_(scene.environment.light.mips.empty() ? 1 : 8) {
        mirrored_.resize(size_t(azimuths_));
        for (int channel = 0; channel < 3; ++channel) {
            const CubeSum cube = cube_sum([&](const glm::dvec3& w) { return radiance_(w)[channel]; });
            for (int azimuth = 0; azimuth < azimuths_; ++azimuth)
                for (int r = kLeastStep; r <= kSteps; ++r)
                    for (int y = 0; y <= kSteps; ++y) {
                        const double height = 2.0 * y / kSteps - 1, turn = 2 * kPi * azimuth / azimuths_;
                        const double across = std::sqrt(1 - height * height);
                        mirrored_[size_t(azimuth)][size_t(r)][size_t(y)][channel] = filtered(
                            cube, {across * std::cos(turn), height, across * std::sin(turn)}, r * 0.05);
                    }
        }
        for (int r = 0; r <= kSteps; ++r)
            for (int c = 0; c <= kSteps; ++c)
                albedo_[size_t(r)][size_t(c)] =
                    reference_albedo(r * 0.05, std::max(c * c / double(kSteps * kSteps), 1e-3), 40, 8);
    }
    [[nodiscard]] glm::dvec3 mirrored(const glm::dvec3& w, double roughness) const {
        const double least = kLeastStep * 0.05;
        const glm::dvec3 rough = filtered_at(w, std::max(roughness, least));
        // For smaller roughnesses, the texels of the sum are too large.
        return roughness >= least ? rough : glm::mix(radiance_(w), rough, roughness / least);
    }
    [[nodiscard]] glm::dvec2 albedo(double roughness, double n_v) const {
        return between(albedo_, roughness, std::sqrt(n_v));
    }

 private:
    static constexpr int kSteps = 20, kLeastStep = 3;
    template <typename T>
    using Grid = std::array<std::array<T, kSteps + 1>, kSteps + 1>;

    [[nodiscard]] glm::dvec3 filtered_at(const glm::dvec3& w, double roughness) const {
        const double place = (std::atan2(w.z, w.x) / (2 * kPi) + 1) * azimuths_, before = std::floor(place);
        const auto grid = [&](double i) -> const Grid<glm::dvec3>& {
            return mirrored_[size_t(i) % mirrored_.size()];
        };
        return glm::mix(between(grid(before), roughness, 0.5 + 0.5 * w.y),
                        between(grid(before + 1), roughness, 0.5 + 0.5 * w.y), place - before);
    }
    template <typename T>
    static T between(const Grid<T>& grid, double row, double column) {
        const double r = std::clamp(row, 0.0, 1.0) * kSteps, c = std::clamp(column, 0.0, 1.0) * kSteps;
        const auto i = std::min(size_t(r), size_t(kSteps - 1)), k = std::min(size_t(c), size_t(kSteps - 1));
        return glm::mix(glm::mix(grid[i][k], grid[i][k + 1], c - double(k)),
                        glm::mix(grid[i + 1][k], grid[i + 1][k + 1], c - double(k)), r - double(i));
    }

    std::function<glm::dvec3(const glm::dvec3&)> radiance_;
    int azimuths_;
    // One grid for each azimuth. First index: 20 × roughness. Second: height of the direction.
    std::vector<Grid<glm::dvec3>> mirrored_;
    Grid<glm::dvec2> albedo_;  // First index: 20 × roughness. Second: 20 × √(n·v).
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
    const glm::dvec3 matt =
        glm::min(s.base_color * (1 - s.metallic), glm::dvec3(1 - std::max({mirror.x, mirror.y, mirror.z})));
    const double alpha = p.roughness * p.roughness, shift = (1 - alpha) * (std::sqrt(1 - alpha) + alpha);
    const glm::dvec3 middle = glm::normalize(glm::mix(s.normal, glm::reflect(-v, s.normal), shift));
    return sum + p.occlusion * (matt * view.ambient->mirrored(s.normal, 1) +
                                mirror * view.ambient->mirrored(middle, p.roughness));
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

// Replaces a directional light that is a disc by parallel lights in directions that are spread over the disc.
std::vector<shared::Light> with_split_discs(const std::vector<shared::Light>& lights) {
    constexpr int kRings = 4;
    std::vector<shared::Light> split;
    for (const shared::Light& light : lights) {
        const double radius = light.type == shared::kLightDirectional ? double(light.cone_scale) : 0;
        const glm::dvec3 to_light = -glm::dvec3(light.direction);
        const glm::dvec3 x = glm::normalize(glm::cross(to_light, std::abs(to_light.y) < 0.9
                                                                     ? glm::dvec3(0, 1, 0)
                                                                     : glm::dvec3(1, 0, 0))),
                         y = glm::cross(to_light, x);
        for (int ring = 0; ring < (radius > 0 ? kRings : 1); ++ring) {
            const int sectors = ring == 0 ? 1 : 6 * ring;
            for (int sector = 0; sector < sectors; ++sector) {
                const double away = radius * ring / (kRings - 0.5), turn = 2 * kPi * sector / sectors;
                shared::Light part = light;
                part.direction = glm::vec3(
                    -glm::normalize(to_light + std::tan(away) * (std::cos(turn) * x + std::sin(turn) * y)));
                if (radius > 0) part.intensity /= float(1 + 3 * kRings * (kRings - 1));
                split.push_back(part);
            }
        }
    }
    return split;
}

class Precision : public SessionTest {
 protected:
    void expect_within_bound(const scene::Scene& scene, float exposure_ev);
};

void Precision::expect_within_bound(const scene::Scene& scene, float exposure_ev) {
    const scene::Camera camera = scene.cameras.at(0);
    const Rendered deferred = render(scene, camera, kPrecisionSize, exposure_ev,
                                     {"albedo", "normal", "orm", "specular", "depth", "hdr"});
    const Rendered forward =
        render(scene, camera, kPrecisionSize, exposure_ev, {"hdr"}, WEFT_SOURCE_DIR "/graphs/forward.json");
    ASSERT_EQ(deferred.images.size(), 6u);
    ASSERT_EQ(forward.images.size(), 1u);
    const Ambient ambient(scene);
    const View view{&ambient, with_split_discs(deferred.lights), glm::dvec3(deferred.view.eye)};
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
            if (std::abs(a[c] - b[c]) <= allowed[c]) continue;
            if (++beyond <= 12)
                std::printf("pixel %zu, %zu, channel %d: %g deferred, %g forward, %g allowed\n",
                            i % kPrecisionSize.width, i / kPrecisionSize.width, c, a[c], b[c], allowed[c]);
        }
    }
    std::printf("%s: %zu surface pixels, at most %.2f of the bound used, largest difference %.2f %%\n",
                scene.name.c_str(), surfaces, worst_use, widest * 100);
    EXPECT_GT(surfaces, 3000u);
    EXPECT_EQ(beyond, 0u);
}

TEST_F(Precision, DeferredIsAsFarFromForwardAsTheGBufferAllows) {
    for (const char* name : {"spheres", "cornell", "atrium", "brushed"}) {
        SCOPED_TRACE(name);
        Result<scene::Scene> scene = scene::make_builtin(name);
        ASSERT_TRUE(scene);
        std::erase_if(scene->instances, [&](const scene::Instance& i) {
            return scene->materials[i.material].alpha_mode == scene::AlphaMode::blend;
        });
        expect_within_bound(*scene, scene->exposure_ev);
    }
}

// The light comes from a picture and its sun.
TEST_F(Precision, DeferredIsAsFarFromForwardUnderAPictureWithASun) {
    scene::Scene scene = sunny_spheres();
    ASSERT_EQ(scene.lights.size(), 1u);
    expect_within_bound(scene, 0);
}

}  // namespace
}  // namespace weft::test
