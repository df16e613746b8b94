// Compares the near field of floors beside walls, in corners, in pits and under plates with rays, and the
// rays with the closed forms of a wall and of a corner. The surfaces emit light of 1 cd/m² and reflect none,
// so that the light of near objects must be 1 minus the visibility.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/near_field/near_reference.h"
#include "tests/render/session_fixture.h"
#include "tests/render/shading/quad_scene.h"
#include "tests/render/sun/box_outline.h"
#include "weft/render/session.h"

namespace weft::test {
namespace {

constexpr Extent3D kNearSize{240, 180, 1};
const std::string kExactGraph = WEFT_SOURCE_DIR "/tests/render/near_field/exact.json";

// A floor with objects. The points of the floor from `least` to `most` are compared.
struct NearCase {
    const char* name = "";
    std::vector<Box> boxes;
    glm::vec3 eye{0}, at{0};
    float fov_y_deg = 0;
    glm::dvec2 least{0}, most{0};  // x and z.
    double steps = 64, radius_m = 20;
    double thickness = 1;  // Of objects, as a share of the radius.
};

const std::vector<NearCase> kNearCases{
    {"low wall", {{{-0.5, 0, -4}, {0, 0.25, 4}}}, {2, 3, 0}, {0.6f, 0, 0}, 100, {0.1, -0.5}, {1.5, 0.5}},
    {"wall", {{{-0.5, 0, -4}, {0, 1, 4}}}, {3, 3, 0}, {0.6f, 0, 0}, 100, {0.25, -0.5}, {2, 0.5}},
    {"corner",
     {{{-0.5, 0, -0.5}, {0, 1, 4}}, {{-0.5, 0, -0.5}, {4, 1, 0}}},
     {3, 3, 3},
     {0.8f, 0, 0.8f},
     90,
     {0.25, 0.25},
     {2, 2}},
    {"pit",
     {{{-1, 0, -1}, {-0.5, 0.5, 1}},
      {{0.5, 0, -1}, {1, 0.5, 1}},
      {{-1, 0, -1}, {1, 0.5, -0.5}},
      {{-1, 0, 0.5}, {1, 0.5, 1}}},
     {0, 1.2f, 0.01f},
     {0, 0, 0},
     95,
     {-0.45, -0.45},
     {0.45, 0.45}},
    {"plate",
     {{{-0.5, 1, -0.5}, {0.5, 1.02, 0.5}}},
     {0, 2.5f, 4},
     {0, 0.4f, 0.5f},
     60,
     {-1.5, 0},
     {1.5, 2},
     256,
     4,
     0.0125}};

struct NearPicture {
    std::vector<glm::vec4> depths, lights, shapes;
    shared::ViewConstants view{};
    float pre_exposure = 1;
};

struct NearErrors {
    size_t count = 0;
    double visibility = 0, light = 0, angle_deg = 0;
};

class NearField : public SessionTest, public testing::WithParamInterface<size_t> {
 protected:
    static scene::Scene scene_of(const NearCase& test) {
        scene::Scene scene;
        scene.meshes = {ground_mesh()};
        scene.instances = {{"ground", 0, 0, glm::mat4(1)}};
        scene::Material glowing;
        glowing.base_color = {0, 0, 0, 1};
        glowing.specular = 0;
        glowing.metallic = 0;
        glowing.emissive = glm::vec3(1);
        scene.materials = {glowing};
        for (const Box& box : test.boxes) {
            scene.instances.push_back({"box", uint32_t(scene.meshes.size()), 0, glm::mat4(1)});
            scene.meshes.push_back(box_mesh(glm::vec3(box.least), glm::vec3(box.most)));
        }
        return scene;
    }

    NearPicture draw(const NearCase& test) {
        scene::Camera camera;
        camera.transform = glm::inverse(glm::lookAt(test.eye, test.at, glm::vec3(0, 1, 0)));
        camera.fov_y_rad = glm::radians(test.fov_y_deg);
        NearPicture picture;
        const auto session = start(scene_of(test), camera, kExactGraph, kNearSize,
                                   {"depth", "nearField.layer(0)", "nearField.layer(1)"});
        if (!session) return picture;
        frame_of(*session).parameters = {
            {"nearSteps", test.steps}, {"nearRadius", test.radius_m}, {"nearThickness", test.thickness}};
        // The light of near objects comes from the picture of the frame before.
        if (!draw_frame(*session) || !draw_frame(*session) || !session->finish()) {
            ADD_FAILURE() << "no picture";
            return picture;
        }
        for (const vk::ReadbackData& data : session->take_readbacks()) {
            std::vector<glm::vec4> texels = render::decode_texels(data.format, data.bytes);
            if (data.pass == "observe:depth")
                picture.depths = std::move(texels);
            else if (data.pass == "observe:nearField.layer(0)")
                picture.lights = std::move(texels);
            else
                picture.shapes = std::move(texels);
        }
        picture.view = session->parts().frames.view();
        picture.pre_exposure = session->pre_exposure();
        return picture;
    }

    static glm::dvec3 point_of(const NearPicture& picture, size_t i) {
        const double x = (double(i % kNearSize.width) + 0.5) / kNearSize.width;
        const double y = (double(i / kNearSize.width) + 0.5) / kNearSize.height;
        const glm::dvec4 world = glm::dmat4(picture.view.inverse_view_projection) *
                                 glm::dvec4(2 * x - 1, 2 * y - 1, picture.depths[i].r, 1);
        return glm::dvec3(world) / world.w;
    }

    static glm::dvec3 decoded(const glm::vec4& shape) {
        glm::dvec3 n(shape.x, shape.y, 1 - std::abs(shape.x) - std::abs(shape.y));
        if (n.z < 0) {
            const glm::dvec2 folded = 1.0 - glm::abs(glm::dvec2(n.y, n.x));
            n.x = std::copysign(folded.x, n.x);
            n.y = std::copysign(folded.y, n.y);
        }
        return glm::normalize(n);
    }

    static NearErrors errors_of(const NearCase& test, const NearPicture& picture) {
        NearErrors worst;
        for (size_t i = 0; i < picture.depths.size(); i += 7) {
            if (picture.depths[i].r <= 0) continue;
            const glm::dvec3 point = point_of(picture, i);
            if (std::abs(point.y) > 1e-3 || point.x < test.least.x || point.x > test.most.x ||
                point.z < test.least.y || point.z > test.most.y)
                continue;
            const Openness open = openness_of(point, test.boxes);
            const glm::dvec4 light(picture.lights[i]);
            const double cosine = glm::dot(decoded(picture.shapes[i]), open.direction);
            ++worst.count;
            worst.visibility = std::max(worst.visibility, std::abs(light.a - open.visibility));
            worst.light = std::max(worst.light, std::abs(light.r / picture.pre_exposure - (1 - light.a)));
            worst.angle_deg =
                std::max(worst.angle_deg, glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))));
        }
        return worst;
    }
};

TEST_P(NearField, AgreesWithRays) {
    const NearCase& test = kNearCases.at(GetParam());
    const NearPicture picture = draw(test);
    ASSERT_FALSE(picture.depths.empty());
    const NearErrors errors = errors_of(test, picture);
    std::printf(
        "%s: %zu points, at most %.4f off in the visibility, %.2f° in the direction, %.4f in the light\n",
        test.name, errors.count, errors.visibility, errors.angle_deg, errors.light);
    EXPECT_GT(errors.count, 100u);
    EXPECT_LE(errors.visibility, 0.03);
    EXPECT_LE(errors.angle_deg, 5);
    EXPECT_LE(errors.light, 0.01);
}

INSTANTIATE_TEST_SUITE_P(All, NearField, testing::Range(size_t{0}, kNearCases.size()), [](const auto& i) {
    std::string name = kNearCases[i.param].name;
    std::ranges::replace(name, ' ', '_');
    return name;
});

// Endless walls of the height h at the distance d: the visibility is (1 + d / √(d² + h²)) / 2, and the light
// comes from the normal turned away from the wall by atan(sin²β / (π − β + sin β cos β)), β = atan(h / d).
TEST(NearReference, SeesAnEndlessWallAsTheClosedFormSays) {
    for (const double h : {0.25, 0.5, 1.0, 2.0, 4.0}) {
        const Openness open = openness_of({1, 0, 0}, {{{-1, 0, -1e4}, {0, h, 1e4}}});
        const double beta = std::atan(h);
        const double tilt = std::atan(std::pow(std::sin(beta), 2) /
                                      (glm::pi<double>() - beta + std::sin(beta) * std::cos(beta)));
        EXPECT_NEAR(open.visibility, (1 + 1 / std::sqrt(1 + h * h)) / 2, 0.002) << h;
        EXPECT_NEAR(glm::degrees(std::atan2(open.direction.x, open.direction.y)), glm::degrees(tilt), 0.2)
            << h;
    }
}

// Floor points in a square pit: Σ of the closed form at the centre, V = 4/π · X/√(1 + X²) · atan(X/√(1 +
// X²)), X = w/2h.
TEST(NearReference, SeesASquarePitAsTheClosedFormSays) {
    for (const double h : {0.25, 0.5, 1.0, 2.0}) {
        const Openness open = openness_of({0, 0, 0}, {{{-9, 0, -9}, {-0.5, h, 9}},
                                                      {{0.5, 0, -9}, {9, h, 9}},
                                                      {{-9, 0, -9}, {9, h, -0.5}},
                                                      {{-9, 0, 0.5}, {9, h, 9}}});
        const double x = 1 / (2 * h), root = x / std::sqrt(1 + x * x);
        EXPECT_NEAR(open.visibility, 4 / glm::pi<double>() * root * std::atan(root), 0.003) << h;
    }
}

}  // namespace
}  // namespace weft::test
