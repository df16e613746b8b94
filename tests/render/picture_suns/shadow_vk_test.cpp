// Tests the shadows of suns in pictures: the shadow of a box on the ground must end where the direction of
// the drawn sun says, and where the shadow of an equal light of the scene ends.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/picture_suns/sun_picture.h"
#include "tests/render/shading/quad_scene.h"
#include "tests/render/sun/box_outline.h"
#include "tests/render/sun/sun_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kGroundSize{400, 400, 1};
// The camera is so far above the ground that its rays are nearly parallel.
constexpr float kGroundEye_m = 1000, kSeenSide_m = 6;

// A sun that lights only one channel of the picture, so that its shadow can be told from the others.
struct ColoredSun {
    int channel = 0;
    double azimuth_deg = 0, height_deg = 0, radius_deg = 0, lx = 0;
    uint32_t number = 0;  // Which directional light it is, by the luminance of its light.

    [[nodiscard]] DrawnSun drawn() const {
        DrawnSun sun{towards(azimuth_deg, height_deg), glm::radians(radius_deg), glm::dvec3(0)};
        sun.radiance[channel] = 1;
        sun.radiance[channel] = lx / sun.illuminance_lx()[channel];
        return sun;
    }
};

scene::Scene with_box(scene::Scene scene) {
    scene.meshes = {ground_mesh(), box_mesh(kBoxLeast, kBoxMost)};
    scene::Material matt;
    matt.metallic = 0;
    matt.specular = 0;
    scene.materials = {matt};
    scene.instances = {{"ground", 0, 0, glm::mat4(1)}, {"box", 1, 0, glm::mat4(1)}};
    return scene;
}

// The ground as the camera above sees it.
struct Ground {
    std::vector<glm::dvec3> points;  // The point of the plane y = 0 in each pixel.
    std::vector<glm::vec4> light;    // What the pixel shows, in cd/m².
    std::vector<bool> hidden;        // The box hides the ground.
    Seen maps;                       // Only the maps of the first sun and the eye.
    render::FurtherSunMaps further;

    // Returns the side of a texel in metres in the map that a sun uses at a point.
    [[nodiscard]] double texel_m(uint32_t number, const glm::dvec3& point) const {
        return number == 1 ? texel_at(maps, glm::vec3(point))
                           : double{further.constants.items[number - 2].texel_m};
    }
};

struct Edges {
    size_t count = 0, dark = 0, wrong = 0;
    double worst = 0;  // Largest distance of the edge from its place, in texels.
};

// The directional lights 1, 2 and 4 light one channel each. The shadow of light 3 is not in the picture,
// because this sun is low.
const std::vector<ColoredSun> kColoredSuns{
    {.channel = 0, .azimuth_deg = 180, .height_deg = 50, .radius_deg = 2, .lx = 20, .number = 1},
    {.channel = 1, .azimuth_deg = 60, .height_deg = 22, .radius_deg = 0.27, .lx = 5, .number = 2},
    {.channel = 1, .azimuth_deg = 90, .height_deg = 7, .radius_deg = 2, .lx = 4, .number = 3},
    {.channel = 2, .azimuth_deg = -60, .height_deg = 65, .radius_deg = 6, .lx = 30, .number = 4}};

// Returns what a sun adds to the luminance of the ground.
double lit_by(const ColoredSun& sun) {
    const DrawnSun drawn = sun.drawn();
    return drawn.illuminance_lx()[sun.channel] * drawn.to_sun.y / kPi;
}

// Returns the luminance of the ground in the channel of a sun, in the shadow of this sun.
double rest_of(const ColoredSun& sun) {
    double rest = 0;
    for (const ColoredSun& other : kColoredSuns)
        if (other.channel == sun.channel && other.number != sun.number) rest += lit_by(other);
    return rest;
}

class PictureShadow : public PictureSuns {
 protected:
    Ground look_down(const scene::Scene& scene) {
        scene::Camera camera;
        camera.transform =
            glm::inverse(glm::lookAt(glm::vec3(0, kGroundEye_m, 0), glm::vec3(0), glm::vec3(0, 0, -1)));
        camera.fov_y_rad = 2 * std::atan(kSeenSide_m / 2 / kGroundEye_m);
        Ground ground;
        const auto session = start(scene, camera, kDeferredGraph, kGroundSize, {"hdr", "depth"});
        if (session) frame_of(*session).parameters = kSunParameters;
        if (!session || !draw_frame(*session) || !session->finish()) {
            ADD_FAILURE() << "no picture";
            return ground;
        }
        std::vector<glm::vec4> depths;
        for (const vk::ReadbackData& data : session->take_readbacks())
            (data.pass == "observe:hdr" ? ground.light : depths) =
                render::decode_texels(data.format, data.bytes);
        const double near_m = session->parts().frames.view().near_m;
        for (size_t i = 0; i < depths.size(); ++i) {
            ground.light[i] /= session->pre_exposure();
            ground.hidden.push_back(near_m / depths[i].r < kGroundEye_m - 0.3);
            const double across = kSeenSide_m / kGroundSize.width;
            ground.points.emplace_back((double(i % kGroundSize.width) + 0.5) * across - kSeenSide_m / 2, 0,
                                       (double(i / kGroundSize.width) + 0.5) * across - kSeenSide_m / 2);
        }
        ground.maps.sun = session->parts().frames.sun();
        ground.further = session->parts().frames.further_suns();
        return ground;
    }

    // Compares the shadow of a sun with the outline of the box. The share of the sun's light is 0.5 at an
    // edge. The share changes over four texels.
    static Edges edges_of(const Ground& ground, const ColoredSun& sun) {
        const DrawnSun drawn = sun.drawn();
        const Outline outline(drawn.to_sun);
        const double lit = lit_by(sun), rest = rest_of(sun);
        const auto share = [&](size_t i) { return (double(ground.light[i][sun.channel]) - rest) / lit; };
        Edges edges;
        for (size_t i = 0; i < ground.points.size(); ++i) {
            if (ground.hidden[i]) continue;
            const double texel_m = ground.texel_m(sun.number, ground.points[i]);
            const double within = outline.depth_m(ground.points[i]) / texel_m;
            edges.dark += within > 3 ? 1 : 0;
            edges.wrong += std::abs(within) > 3 && std::abs(share(i) - (within > 0 ? 0 : 1)) > 0.01 ? 1 : 0;
            for (const size_t j : {i + 1, i + kGroundSize.width}) {
                if (j >= ground.points.size() || (j == i + 1 && j % kGroundSize.width == 0)) continue;
                const double a = share(i) - 0.5, b = share(j) - 0.5;
                if (ground.hidden[j] || a * b >= 0) continue;
                const glm::dvec3 edge = glm::mix(ground.points[i], ground.points[j], a / (a - b));
                edges.worst = std::max(edges.worst, std::abs(outline.depth_m(edge)) / texel_m);
                ++edges.count;
            }
        }
        return edges;
    }
    static void expect_edges(const Ground& ground, const ColoredSun& sun, const char* what) {
        const Edges edges = edges_of(ground, sun);
        std::printf("%s, light %u: %zu points of the edge, at most %.2f texels off; %zu dark points\n", what,
                    sun.number, edges.count, edges.worst, edges.dark);
        EXPECT_GT(edges.count, 150u);
        EXPECT_GT(edges.dark, 1000u);
        EXPECT_EQ(edges.wrong, 0u) << "points more than 3 texels from the edge that are neither dark nor lit";
        EXPECT_LE(edges.worst, 1.0);
    }
};

// Lights that are equal to the drawn suns.
scene::Scene lit_by_equal_lights() {
    scene::Scene scene = with_box({});
    for (const ColoredSun& sun : kColoredSuns) {
        scene::Light light;
        light.type = scene::LightType::directional;
        light.direction = -glm::vec3(sun.drawn().to_sun);
        light.angular_radius_rad = float(sun.drawn().radius_rad);
        light.color = glm::vec3(0);
        light.color[sun.channel] = 1;
        light.intensity = float(sun.lx);
        scene.lights.push_back(light);
    }
    return scene;
}

TEST_F(PictureShadow, EndsWhereTheShadowOfAnEqualLightEnds) {
    std::vector<DrawnSun> drawn;
    for (const ColoredSun& sun : kColoredSuns) drawn.push_back(sun.drawn());
    const SunPicture picture(
        512, [](const glm::dvec3&) { return glm::dvec3(1e-4); }, drawn);
    const scene::Scene opened = with_box(surrounded_by(picture));
    ASSERT_EQ(opened.lights.size(), kColoredSuns.size());
    const Ground of_picture = look_down(opened), of_lights = look_down(lit_by_equal_lights());
    ASSERT_EQ(of_picture.light.size(), of_picture.points.size());
    ASSERT_EQ(of_lights.light.size(), of_picture.points.size());
    for (const ColoredSun& sun : kColoredSuns) {
        if (sun.number == 3) continue;
        expect_edges(of_picture, sun, "picture");
        expect_edges(of_lights, sun, "scene");
    }
}

}  // namespace
}  // namespace weft::test
