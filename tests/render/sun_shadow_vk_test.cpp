// Shadows of the sun: where their edges lie, that they stand still, and that no light leaks.
#include <algorithm>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "quad_scene.h"
#include "ray_scene.h"
#include "reference_light.h"
#include "session_fixture.h"

namespace weft::test {
namespace {

constexpr uint32_t kGrid = 384;
const std::string kFolder = WEFT_SOURCE_DIR "/tests/render/sun/";

// Points of the world: as many rows and columns as grid.json has.
struct Grid {
    glm::vec3 corner{0}, right{0}, down{0};
    [[nodiscard]] glm::vec3 at(uint32_t i) const {
        return corner + right * static_cast<float>(i % kGrid) + down * static_cast<float>(i / kGrid);
    }
};

std::string list_of(const glm::vec3& v) {
    std::ostringstream text;
    text.precision(9);
    text << "[" << v.x << ", " << v.y << ", " << v.z << "]";
    return text.str();
}

void put(std::string& text, const std::string& word, const glm::vec3& value) {
    const size_t at = text.find("\"" + word + "\"");
    if (at != std::string::npos) text.replace(at, word.size() + 2, list_of(value));
}

struct Seen {
    std::vector<float> share;        // by point
    std::vector<glm::vec4> normals;  // octahedral, where the graph has them
    render::SunCascades sun;
    glm::vec3 eye{0};
};

class SunShadows : public SessionTest {
 protected:
    Seen look(const scene::Scene& scene, const scene::Camera& camera, const Grid& grid) {
        const FileReader reader = [&](const std::string& path) {
            std::optional<std::string> text = read_text(path);
            if (!text || !path.ends_with("grid.json")) return text;
            put(*text, "CORNER", grid.corner);
            put(*text, "RIGHT", grid.right);
            put(*text, "DOWN", grid.down);
            return text;
        };
        return run(start(scene, camera, kFolder + "grid.json", {320, 180, 1}, {"seen"}, 0, reader));
    }
    static Seen run(const std::unique_ptr<render::Session>& session) {
        Seen seen;
        if (!session || !session->render_frame(0, 0) || !session->finish()) {
            ADD_FAILURE() << "no picture";
            return seen;
        }
        for (const vk::ReadbackData& data : session->take_readbacks()) {
            const std::vector<glm::vec4> texels = render::decode_texels(data.format, data.bytes);
            if (data.pass == "observe:normal") seen.normals = texels;
            if (data.pass != "observe:seen") continue;
            for (const glm::vec4& texel : texels) seen.share.push_back(texel.r);
        }
        seen.sun = session->sun();
        seen.eye = session->view().eye;
        return seen;
    }
};

// A box of 1 m × 0.8 m × 0.7 m that floats over the ground, under a sun that is tilted both ways.
const glm::vec3 kBoxLeast{-0.5f, 0.6f, -0.35f}, kBoxMost{0.5f, 1.4f, 0.35f};

scene::Mesh box_mesh(const glm::vec3& least, const glm::vec3& most) {
    scene::Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool far : {false, true}) {
            const auto first = static_cast<uint32_t>(mesh.positions.size());
            glm::vec3 normal(0);
            normal[axis] = far ? 1.0f : -1.0f;
            for (uint32_t k = 0; k < 4; ++k) {
                glm::vec3 corner;
                corner[axis] = far ? most[axis] : least[axis];
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                corner[u] = k == 1 || k == 2 ? most[u] : least[u];
                corner[v] = k >= 2 ? most[v] : least[v];
                mesh.positions.push_back(corner);
                mesh.normals.push_back(normal);
                mesh.tangents.emplace_back(normal.y, normal.z, normal.x, 1);
                mesh.uvs.emplace_back(0, 0);
            }
            const std::array<uint32_t, 6> faces =
                far ? std::array<uint32_t, 6>{0, 1, 2, 0, 2, 3} : std::array<uint32_t, 6>{0, 2, 1, 0, 3, 2};
            for (const uint32_t i : faces) mesh.indices.push_back(first + i);
        }
    }
    mesh.bounds_min = least;
    mesh.bounds_max = most;
    return mesh;
}

scene::Scene box_scene(const glm::vec3& to_sun) {
    scene::Scene scene;
    scene.meshes = {ground_mesh(), box_mesh(kBoxLeast, kBoxMost)};
    scene.materials.emplace_back();
    scene.instances = {{"ground", 0, 0, glm::mat4(1)}, {"box", 1, 0, glm::mat4(1)}};
    scene::Light light;
    light.type = scene::LightType::directional;
    light.direction = -glm::normalize(to_sun);
    scene.lights.push_back(light);
    scene::Camera camera;
    camera.transform = glm::inverse(glm::lookAt(glm::vec3(1, 3, 4), glm::vec3(0), glm::vec3(0, 1, 0)));
    scene.cameras.push_back(camera);
    return scene;
}

// The box as the sun sees it: its outline in the plane across the light, anticlockwise.
class Outline {
 public:
    explicit Outline(const glm::dvec3& to_sun)
        : right_(glm::normalize(glm::cross(glm::dvec3(0, 1, 0), to_sun))), up_(glm::cross(to_sun, right_)) {
        std::vector<glm::dvec2> corners;
        for (int i = 0; i < 8; ++i)
            corners.push_back(
                place({(i & 1) != 0 ? kBoxMost.x : kBoxLeast.x, (i & 2) != 0 ? kBoxMost.y : kBoxLeast.y,
                       (i & 4) != 0 ? kBoxMost.z : kBoxLeast.z}));
        // A side is one that has all corners on its left.
        for (const glm::dvec2& a : corners) {
            for (const glm::dvec2& b : corners) {
                const glm::dvec2 way = b - a;
                if (glm::length(way) < 1e-9) continue;
                const glm::dvec2 left = glm::normalize(glm::dvec2(-way.y, way.x));
                const bool outside = std::ranges::any_of(
                    corners, [&](const glm::dvec2& c) { return glm::dot(c - a, left) < -1e-9; });
                if (!outside) sides_.push_back({a, left});
            }
        }
    }
    // How far a point lies within the shadow, across the light: negative outside.
    [[nodiscard]] double depth_m(const glm::dvec3& point) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Side& side : sides_) least = std::min(least, glm::dot(place(point) - side.at, side.left));
        return least;
    }

 private:
    struct Side {
        glm::dvec2 at, left;
    };
    [[nodiscard]] glm::dvec2 place(const glm::dvec3& point) const {
        return {glm::dot(point, right_), glm::dot(point, up_)};
    }
    glm::dvec3 right_, up_;
    std::vector<Side> sides_;
};

uint32_t cascade_at(const render::SunCascades& sun, double distance_m) {
    uint32_t i = 0;
    while (i + 1 < sun.count && distance_m > sun.cascades[i].end_m) ++i;
    return i;
}

// Of the map that a point is looked up in; of both where two blend.
double texel_at(const Seen& seen, const glm::vec3& point) {
    const double distance_m = glm::distance(point, seen.eye);
    const uint32_t i = cascade_at(seen.sun, distance_m);
    const bool blends =
        i + 1 < seen.sun.count && distance_m > seen.sun.cascades[i].end_m * (1 - shared::kSunBlend);
    return seen.sun.cascades[blends ? i + 1 : i].texel_m;
}

class UnderATiltedSun : public SunShadows, public ::testing::WithParamInterface<float> {};

TEST_P(UnderATiltedSun, TheUmbraOfABoxEndsWhereItShould) {
    const float tilt = GetParam();
    const glm::vec3 to_sun =
        glm::normalize(glm::vec3(std::sin(tilt) * 0.8f, std::cos(tilt), std::sin(tilt) * 0.6f));
    const scene::Scene scene = box_scene(to_sun);
    const float reach = 1.6f + 2 * std::tan(tilt);
    const glm::vec3 middle = -to_sun * (1.0f / to_sun.y);
    const float step = 2 * reach / kGrid;
    const Grid grid{{middle.x - reach, 0, middle.z - reach}, {step, 0, 0}, {0, 0, step}};
    const Seen seen = look(scene, scene.cameras[0], grid);
    ASSERT_EQ(seen.share.size(), size_t{kGrid} * kGrid);
    const Outline outline{glm::dvec3(to_sun)};
    size_t edges = 0, dark = 0, wrong = 0;
    double worst = 0;
    for (uint32_t i = 0; i < kGrid * kGrid; ++i) {
        const glm::vec3 point = grid.at(i);
        if (std::max(std::abs(point.x), std::abs(point.z)) > 3.9f) continue;
        const double texel_m = texel_at(seen, point), within = outline.depth_m(glm::dvec3(point)) / texel_m;
        dark += within > 3 ? 1 : 0;
        const float wanted = within > 0 ? 0 : 1;
        wrong += std::abs(within) > 3 && std::abs(seen.share[i] - wanted) > 1e-4f ? 1 : 0;
        // Where half of the filter is dark, between this point and its right or lower neighbour.
        for (const uint32_t j : {i + 1, i + kGrid}) {
            if (j >= kGrid * kGrid || (j == i + 1 && j % kGrid == 0)) continue;
            const float a = seen.share[i] - 0.5f, b = seen.share[j] - 0.5f;
            if (a * b >= 0) continue;
            const glm::vec3 edge = glm::mix(point, grid.at(j), a / (a - b));
            const double off = std::abs(outline.depth_m(glm::dvec3(edge))) / texel_m;
            worst = std::max(worst, off);
            ++edges;
        }
    }
    std::printf("tilt %.2f: %zu points of the edge, at most %.2f texels off; %zu points in the umbra\n",
                double{tilt}, edges, worst, dark);
    EXPECT_GT(edges, 200u);
    EXPECT_GT(dark, 1000u);
    EXPECT_EQ(wrong, 0u) << "points more than 3 texels from the edge that are neither dark nor lit";
    EXPECT_LE(worst, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Radians, UnderATiltedSun, ::testing::Values(0.2f, 0.5f, 0.8f, 1.1f),
                         [](const auto& c) {
                             return "Tilt" + std::to_string(static_cast<int>(c.param * 100));
                         });

scene::Scene atrium(float hour) {
    Result<scene::Scene> scene = scene::make_builtin("atrium", {.hour = hour});
    EXPECT_TRUE(scene);
    return std::move(*scene);
}

// Points that stand still, looked up while the camera moves by steps of less than a texel of the finest map.
TEST_F(SunShadows, StandStillWhileTheCameraCreeps) {
    constexpr int kSteps = 3;
    const scene::Scene scene = atrium(10);
    const Grid floor{{-5, 0.05f, -6}, {10.0f / kGrid, 0, 0}, {0, 0, 12.0f / kGrid}};
    const Grid wall{{-5.2f, 4, 6}, {0, 0, -12.0f / kGrid}, {0, -4.0f / kGrid, 0}};
    for (const Grid& grid : {floor, wall}) {
        scene::Camera camera = scene.cameras.at(0);
        Seen before = look(scene, camera, grid);
        ASSERT_EQ(before.share.size(), size_t{kGrid} * kGrid);
        const auto half_lit =
            std::ranges::count_if(before.share, [](float x) { return x > 0.01f && x < 0.99f; });
        const auto dark = std::ranges::count_if(before.share, [](float x) { return x < 0.01f; });
        size_t changed = 0, moved = 0;
        for (int step = 0; step < kSteps; ++step) {
            const float step_m = 0.6f * static_cast<float>(before.sun.cascades[0].texel_m);
            camera.transform[3] += glm::vec4(glm::normalize(glm::vec3(0.6f, -0.5f, 0.7f)) * step_m, 0);
            Seen after = look(scene, camera, grid);
            ASSERT_EQ(after.share.size(), before.share.size());
            for (uint32_t i = 0; i < before.sun.count; ++i)
                moved += before.sun.cascades[i].origin_texels != after.sun.cascades[i].origin_texels ? 1 : 0;
            // Half a step of 8 bits.
            for (size_t i = 0; i < after.share.size(); ++i)
                changed += std::abs(after.share[i] - before.share[i]) > 0.5f / 255 ? 1 : 0;
            before = std::move(after);
        }
        const double share = 1 - static_cast<double>(changed) / (double{kSteps} * kGrid * kGrid);
        std::printf(
            "%.4f %% of the points unchanged; the maps moved %zu times, %ld points dark, %ld half lit\n",
            share * 100, moved, dark, half_lit);
        EXPECT_GE(share, 0.999);
        EXPECT_GT(moved, 0u);
        EXPECT_GT(half_lit, 1000);
        EXPECT_GT(dark, 5000);
    }
}

// What rays say of the surface in a pixel, for the filter's reach around it.
enum class Sunlight : uint8_t { all, none, some };

struct Pixel {
    glm::dvec3 at{0}, normal{0};
};

// Rays from the point and from 24 around it on its plane, which the map has up to `reach_m` away. What casts
// a shadow but does not rise above the surface by `lift_m` may be lost. Holes decide nothing: maps see them
// coarser.
Sunlight sunlight(const RayScene& rays, const Pixel& pixel, const glm::dvec3& to_sun, double reach_m,
                  double lift_m) {
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), to_sun)),
                     up = glm::cross(to_sun, right);
    const double cos_light = glm::dot(pixel.normal, to_sun);
    int lit = 0, dark = 0;
    for (int i = 0; i < 25 && (lit == i || dark == i); ++i) {
        const glm::dvec3 across = (right * (i % 5 * 0.5 - 1) + up * (i / 5 * 0.5 - 1)) * reach_m;
        const glm::dvec3 from = pixel.at + across - to_sun * (glm::dot(across, pixel.normal) / cos_light);
        const bool is_free = !rays.is_blocked(from, to_sun, 1e-3, Masks::solid);
        lit += is_free ? 1 : 0;
        dark += !is_free && rays.is_blocked(from, to_sun, 1e-3, Masks::absent) &&
                        rays.is_blocked(from + pixel.normal * lift_m, to_sun, 0, Masks::absent)
                    ? 1
                    : 0;
    }
    return lit == 25 ? Sunlight::all : (dark == 25 ? Sunlight::none : Sunlight::some);
}

class Atrium : public SunShadows, public ::testing::WithParamInterface<std::tuple<uint32_t, float>> {};

// Every fourth pixel both ways. Where rays find the sun, or do not find it, all around, the map must say the
// same.
TEST_P(Atrium, LeaksNoLightAndShadowsNothingThatIsLit) {
    if (std::getenv("WEFT_EXTENDED") == nullptr) GTEST_SKIP() << "only with WEFT_EXTENDED";
    constexpr Extent3D kSize{480, 270, 1};
    constexpr float kTolerated = 0.1f;  // of the sun
    const auto [camera_index, hour] = GetParam();
    const scene::Scene scene = atrium(hour);
    const RayScene rays(scene);
    const scene::Camera& camera = scene.cameras.at(camera_index);
    const Seen seen = run(start(scene, camera, kFolder + "surfaces.json", kSize, {"seen", "normal"}));
    ASSERT_EQ(seen.share.size(), size_t{kSize.width} * kSize.height);
    const glm::dvec3 to_sun(seen.sun.constants.to_sun), eye(camera.transform[3]);
    const double tan_y = std::tan(double{camera.fov_y_rad} / 2), tan_x = tan_y * kSize.width / kSize.height;
    size_t lit = 0, dark = 0, leaks = 0, acne = 0;
    for (uint32_t y = 1; y < kSize.height; y += 4) {
        for (uint32_t x = 1; x < kSize.width; x += 4) {
            const glm::dvec3 ray = glm::normalize(glm::dmat3(camera.transform) *
                                                  glm::dvec3(((x + 0.5) / kSize.width * 2 - 1) * tan_x,
                                                             (1 - (y + 0.5) / kSize.height * 2) * tan_y, -1));
            const std::optional<RayHit> hit = rays.first(eye, ray, camera.near_m);
            if (!hit || glm::dot(hit->normal, to_sun) < 0.05) continue;
            // Leaves are smaller than texels, and lie on one another.
            if (scene.materials[hit->material].alpha_mode == scene::AlphaMode::mask) continue;
            const size_t i = size_t{y} * kSize.width + x;
            // What a normal map turns away from the sun is dark anyway.
            if (glm::dot(octahedral_normal(seen.normals[i]), to_sun) < 0.05) continue;
            const Pixel pixel{eye + ray * hit->distance_m, hit->normal};
            const double texel_m = texel_at(seen, glm::vec3(pixel.at));
            const Sunlight truth = sunlight(rays, pixel, to_sun, 3 * texel_m, 4 * texel_m);
            const float share = seen.share[i];
            lit += truth == Sunlight::all ? 1 : 0;
            dark += truth == Sunlight::none ? 1 : 0;
            leaks += truth == Sunlight::none && share > kTolerated ? 1 : 0;
            acne += truth == Sunlight::all && share < 1 - kTolerated ? 1 : 0;
            if ((truth == Sunlight::none && share > kTolerated) ||
                (truth == Sunlight::all && share < 1 - kTolerated))
                std::printf("%s %s %u %u share %.3f texel %.4f at %.2f %.2f %.2f n.l %.2f shading %.2f\n",
                            truth == Sunlight::none ? "LEAK" : "ACNE",
                            scene.materials[hit->material].name.c_str(), x, y, share, texel_m, pixel.at.x,
                            pixel.at.y, pixel.at.z, glm::dot(hit->normal, to_sun),
                            glm::dot(octahedral_normal(seen.normals[i]), to_sun));
        }
    }
    std::printf("camera %s, %g h: of %zu points in shadow %zu leak, of %zu in the sun %zu are darkened\n",
                camera.name.c_str(), double{hour}, dark, leaks, lit, acne);
    EXPECT_GT(dark, 300u);
    EXPECT_EQ(leaks, 0u);
    EXPECT_LE(acne, lit / 500);
}

INSTANTIATE_TEST_SUITE_P(Views, Atrium,
                         ::testing::Combine(::testing::Values(0u, 1u, 2u), ::testing::Values(10.0f, 17.0f)),
                         [](const auto& c) {
                             return "Camera" + std::to_string(std::get<0>(c.param)) + "At" +
                                    std::to_string(static_cast<int>(std::get<1>(c.param)));
                         });

}  // namespace
}  // namespace weft::test
