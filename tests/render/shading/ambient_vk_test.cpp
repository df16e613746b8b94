// Tests the modules dfg.json and environment.json, and the functions of the shader library that use them. The
// results are compared with sums over many directions and with closed forms.
#include <algorithm>
#include <cstring>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/reference_ambient.h"

namespace weft::test {
namespace {

constexpr const char* kAmbientGraph = WEFT_SOURCE_DIR "/tests/render/ambient/ambient.json";
constexpr size_t kDirections = 384;

// Direction of a column of the picture `mirrored`.
glm::dvec3 spiral(size_t i) {
    const double y = 1 - (2.0 * double(i) + 1) / kDirections, azimuth = 2.39996323 * double(i),
                 across = std::sqrt(1 - y * y);
    return {across * std::cos(azimuth), y, across * std::sin(azimuth)};
}

// Returns a picture of the surroundings. Each texel is the mean of 3 × 3 samples.
scene::Environment picture_of(const Surroundings& light, uint32_t width = 512) {
    const uint32_t height = width / 2;
    std::vector<glm::vec3> texels;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            double sum = 0;
            for (int i = 0; i < 9; ++i) {
                const double polar = kPi * (y + (i / 3 + 0.5) / 3) / height,
                             azimuth = 2 * kPi * ((x + (i % 3 + 0.5) / 3) / width - 0.5);
                sum += light({std::sin(polar) * std::sin(azimuth), std::cos(polar),
                              -std::sin(polar) * std::cos(azimuth)}) /
                       9;
            }
            texels.push_back(glm::vec3(float(sum)));
        }
    return scene::build_environment(width, height, texels);
}

// A smooth sky: bright towards the sun and the horizon, over a ground of constant radiance.
double smooth_sky(const glm::dvec3& d) {
    if (d.y < 0) return 1;
    const glm::dvec3 sun = glm::normalize(glm::dvec3(0.6, 0.58, -0.5));
    return 1.5 + 2.5 * std::exp(-4 * d.y) + 6 * std::exp(-6 * (1 - glm::dot(d, sun)));
}
double half_sky(const glm::dvec3& d) {
    return glm::dot(d, glm::dvec3(1, 2, 3)) > 0 ? 1 : 0;
}
double spot_sky(const glm::dvec3& d) {
    const double cosine = glm::dot(d, glm::normalize(glm::dvec3(1, 2, 3)));
    return cosine > std::cos(2.5 * kPi / 180) ? 1000 : 1;
}

// Root of the mean square, and the largest error, as shares of the root mean square of the reference.
struct Errors {
    double rms = 0, most = 0;
};

class AmbientLight : public SessionTest {
 protected:
    // Runs the graph once. Keys of the result: "mirrored", "diffuse", "albedo", "fitted" and "sh".
    std::map<std::string, std::vector<glm::vec4>> run(const scene::Scene& scene,
                                                      std::vector<std::string> observed = {"mirrored",
                                                                                           "diffuse"}) {
        const std::unique_ptr<render::Session> session =
            start(scene, scene::Camera{}, kAmbientGraph, {16, 16, 1}, std::move(observed));
        std::map<std::string, std::vector<glm::vec4>> found;
        if (!session || !draw_frame(*session) || !session->finish()) {
            ADD_FAILURE() << "the graph cannot run";
            return found;
        }
        for (const vk::ReadbackData& data : session->take_readbacks()) {
            if (data.pass == "keepSh") {
                found["sh"].resize(data.bytes.size() / sizeof(glm::vec4));
                std::memcpy(found["sh"].data(), data.bytes.data(), data.bytes.size());
            } else {
                found[data.pass.substr(std::string("observe:").size())] =
                    render::decode_texels(data.format, data.bytes);
            }
        }
        return found;
    }
    std::map<std::string, std::vector<glm::vec4>> run(const Surroundings& light,
                                                      std::vector<std::string> observed = {"mirrored",
                                                                                           "diffuse"}) {
        scene::Scene scene;
        scene.environment = picture_of(light);
        return run(scene, std::move(observed));
    }
};

// `expected` returns the reference for a direction.
Errors errors_of(const std::vector<glm::vec4>& found, int roughness10, const Surroundings& expected) {
    double squares = 0, reference = 0, most = 0;
    for (size_t i = 0; i < kDirections; ++i) {
        const double wanted = expected(spiral(i));
        const double error = found[size_t(roughness10 - 1) * kDirections + i].g - wanted;
        squares += error * error;
        reference += wanted * wanted;
        most = std::max(most, std::abs(error));
    }
    const double scale = std::sqrt(reference / kDirections);
    return {std::sqrt(squares / kDirections) / scale, most / scale};
}

// Compares the filtered light of the roughnesses 0.1, 0.2, 0.4, 0.6, 0.8 and 1 with references.
void expect_errors(const char* name, const std::vector<glm::vec4>& found, const Surroundings& light,
                   const std::array<Errors, 6>& allowed) {
    ASSERT_EQ(found.size(), kDirections * 10);
    const CubeSum cube = cube_sum(light);
    constexpr std::array kTenths{1, 2, 4, 6, 8, 10};
    for (size_t i = 0; i < kTenths.size(); ++i) {
        const double roughness = kTenths[i] / 10.0;
        const Errors e = errors_of(found, kTenths[i], [&](const glm::dvec3& n) {
            return kTenths[i] == 1 ? sampled(light, n, roughness) : filtered(cube, n, roughness);
        });
        std::printf("%s, roughness %.1f: RMS %.2f %%, largest %.2f %%\n", name, roughness, e.rms * 100,
                    e.most * 100);
        EXPECT_LE(e.rms, allowed[i].rms);
        EXPECT_LE(e.most, allowed[i].most);
    }
}

TEST_F(AmbientLight, ASmoothSkyIsFilteredWithThirtyTwoSamples) {
    expect_errors(
        "sky", run(smooth_sky)["mirrored"], smooth_sky,
        {{{0.013, 0.1}, {0.01, 0.045}, {0.008, 0.03}, {0.006, 0.03}, {0.008, 0.035}, {0.007, 0.02}}});
}
TEST_F(AmbientLight, AHalfWhiteSphereIsFilteredWithThirtyTwoSamples) {
    expect_errors(
        "half", run(half_sky)["mirrored"], half_sky,
        {{{0.02, 0.1}, {0.013, 0.05}, {0.009, 0.03}, {0.006, 0.025}, {0.01, 0.035}, {0.002, 0.004}}});
}
// A spot of 5° that is 1000 times as bright as its surroundings has large errors with 32 samples, so such
// sources must not stay in the picture. Harmonics have no such errors.
TEST_F(AmbientLight, ASpotIsFilteredWithThirtyTwoSamples) {
    expect_errors("spot", run(spot_sky)["mirrored"], spot_sky,
                  {{{0.4, 8}, {0.1, 1.4}, {0.16, 2}, {0.16, 1}, {0.18, 1.2}, {0.05, 0.12}}});
}

// Direction of the middle of a texel of a cube map, in the order of Vulkan's faces.
glm::dvec3 cube_direction(size_t face, double u, double v) {
    const std::array<glm::dvec3, 6> directions{glm::dvec3(1, -v, -u), {-1, -v, u}, {u, 1, v},
                                               {u, -1, -v},           {u, -v, 1},  {-u, -v, -1}};
    return glm::normalize(directions[face]);
}

// The lobe of each mip multiplies harmonics of order l by c_l: the table is computed from GGX with N = V.
TEST_F(AmbientLight, ZonalHarmonicsAreMultipliedByTheTable) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, -2));
    struct Row {
        const char* mip;
        double c1, c2;
    };
    constexpr std::array kTable{
        Row{"environmentCube.mip(2)", 0.98765, 0.96526}, Row{"environmentCube.mip(3)", 0.91816, 0.78420},
        Row{"environmentCube.mip(4)", 0.81509, 0.54473}, Row{"environmentCube.mip(5)", 0.72549, 0.36014}};
    const auto order = [&](int l, const glm::dvec3& d) {
        const double x = glm::dot(d, axis);
        return l == 1 ? x : 1.5 * x * x - 0.5;
    };
    for (const int l : {1, 2}) {
        std::vector<std::string> observed;
        for (const Row& row : kTable) observed.emplace_back(row.mip);
        auto found = run([&](const glm::dvec3& d) { return 2 + order(l, d); }, observed);
        for (const Row& row : kTable) {
            const std::vector<glm::vec4>& texels = found[row.mip];
            ASSERT_FALSE(texels.empty());
            const auto side = static_cast<size_t>(std::lround(std::sqrt(double(texels.size()) / 6)));
            ASSERT_EQ(texels.size(), side * side * 6);
            double product = 0, squares = 0;
            for (size_t i = 0; i < texels.size(); ++i) {
                const double u = (2.0 * double(i % side) + 1) / double(side) - 1,
                             v = (2.0 * double(i / side % side) + 1) / double(side) - 1,
                             weight = std::pow(1 + u * u + v * v, -1.5);
                const double y = order(l, cube_direction(i / (side * side), u, v));
                // The texels are divided by the unit of the cube, which is 2⁻¹² for values up to 3.
                product += weight * y * (texels[i].g / 4096 - 2);
                squares += weight * y * y;
            }
            const double expected = l == 1 ? row.c1 : row.c2;
            std::printf("%s: c%d = %.5f, expected %.5f\n", row.mip, l, product / squares, expected);
            EXPECT_NEAR(product / squares, expected, expected * 0.005);
        }
    }
}

// Returns the largest error of the diffuse light, and checks that no value is negative.
double diffuse_error(const std::vector<glm::vec4>& found, const Surroundings& expected) {
    double most = 0;
    for (size_t i = 0; i < found.size(); ++i) {
        EXPECT_GE(found[i].g, 0);
        most = std::max(most, std::abs(found[i].g - expected(spiral(i))));
    }
    return most;
}

TEST_F(AmbientLight, HarmonicsOfNineTermsAreExactWhereTheyShouldBe) {
    EXPECT_LT(diffuse_error(run([](const glm::dvec3&) { return 3; })["diffuse"],
                            [](const glm::dvec3&) { return 3; }),
              0.002);
    const glm::dvec3 b(0.5, -0.7, 0.9);
    EXPECT_LT(diffuse_error(run([&](const glm::dvec3& d) { return 2 + glm::dot(b, d); })["diffuse"],
                            [&](const glm::dvec3& n) { return 2 + glm::dot(b, n) * 2 / 3; }),
              0.004);
    EXPECT_LT(diffuse_error(run([](const glm::dvec3& d) { return d.z * d.z; })["diffuse"],
                            [](const glm::dvec3& n) { return 1 / 3.0 + (n.z * n.z - 1 / 3.0) / 4; }),
              0.001);
    EXPECT_LT(diffuse_error(run([](const glm::dvec3& d) { return d.y > 0 ? 1.0 : 0.0; })["diffuse"],
                            [](const glm::dvec3& n) { return (1 + n.y) / 2; }),
              0.003);
}

// An overcast sky over black ground: exact upwards 7/9, downwards 0. The sum of nine terms would be negative
// downwards.
TEST_F(AmbientLight, AnOvercastSkyDoesNotRing) {
    const auto sky = [](const glm::dvec3& d) { return d.y > 0 ? (1 + 2 * d.y) / 3 : 0; };
    const std::vector<glm::vec4> found = run(sky)["diffuse"];
    const CubeSum cube = cube_sum(sky);
    EXPECT_LT(diffuse_error(found, [&](const glm::dvec3& n) { return filtered(cube, n, 1); }), 0.012);
}

// The harmonics of the GPU are those that the CPU computes from the whole picture, also where both are
// reduced because of a small bright source.
TEST_F(AmbientLight, TheGpuComputesTheHarmonicsOfTheCpu) {
    for (const Surroundings& light : {Surroundings(smooth_sky), Surroundings(spot_sky)}) {
        scene::Scene scene;
        scene.environment = picture_of(light);
        const std::vector<glm::vec4> found = run(scene)["sh"];
        ASSERT_EQ(found.size(), 9u);
        const std::array<glm::vec3, 9>& expected = scene.environment.irradiance_over_pi;
        for (size_t i = 0; i < 9; ++i)
            EXPECT_NEAR(found[i].g, expected[i].g, expected[0].g * 0.01) << "coefficient " << i;
    }
}

TEST_F(AmbientLight, TheGradientSkyLightsWithoutAPicture) {
    scene::Scene scene;
    scene.sky_zenith = glm::vec3(4000);
    scene.sky_horizon = glm::vec3(9000);
    const auto found = run(scene);
    const CubeSum cube = cube_sum([](const glm::dvec3& d) {
        if (d.y >= 0) return glm::mix(9000.0, 4000.0, std::sqrt(d.y));
        const double t = std::min(-d.y / 0.15, 1.0);
        return glm::mix(9000.0, 2250.0, t * t * (3 - 2 * t));
    });
    for (const int roughness10 : {2, 4, 6, 8, 10}) {
        const Errors e = errors_of(found.at("mirrored"), roughness10, [&](const glm::dvec3& n) {
            return filtered(cube, n, roughness10 / 10.0);
        });
        EXPECT_LT(e.rms, 0.02) << roughness10;
    }
}

// Scale and bias of the directional albedo. Source: numerical integration with 2^20 samples.
TEST_F(AmbientLight, TheTableOfTheAlbedoHasTheIntegrals) {
    constexpr std::array kRoughness{10, 30, 50, 80, 100};
    constexpr std::array kCosines{10, 25, 50, 75, 100};
    constexpr double kScale[5][5] = {{.4158, .7629, .9683, .9989, .9999},
                                     {.5630, .7535, .9427, .9847, .9907},
                                     {.7519, .7593, .8349, .8888, .9158},
                                     {.7889, .6952, .6143, .5741, .5551},
                                     {.7363, .5868, .4477, .3639, .3068}};
    constexpr double kBias[5][5] = {{.5784, .2362, .0314, .0010, 0},
                                    {.3214, .1783, .0324, .0018, 0},
                                    {.1397, .0808, .0223, .0027, 0},
                                    {.0442, .0229, .0069, .0014, 0},
                                    {.0239, .0109, .0030, .0006, 0}};
    scene::Scene scene;
    auto found = run(scene, {"albedo", "fitted"});
    ASSERT_EQ(found["albedo"].size(), 10100u);
    double worst = 0, worst_share = 0;
    for (size_t i = 0; i < 5; ++i)
        for (size_t k = 0; k < 5; ++k) {
            const glm::vec4 texel = found["albedo"][size_t(kRoughness[i]) * 100 + size_t(kCosines[k]) - 1];
            for (const auto& [value, expected] :
                 {std::pair(texel.r, kScale[i][k]), std::pair(texel.g, kBias[i][k])}) {
                worst = std::max(worst, std::abs(value - expected));
                if (expected > 0.1) worst_share = std::max(worst_share, std::abs(value / expected - 1));
            }
            EXPECT_NEAR(texel.b * (texel.r + texel.g), 1, 1e-3);
        }
    std::printf("table: largest error %.5f, relative %.5f\n", worst, worst_share);
    EXPECT_LT(worst, 1e-3);
    EXPECT_LT(worst_share, 5e-3);
    glm::dvec2 fit(0);
    for (int r = 0; r <= 100; r += 4)
        for (int c = 2; c <= 100; c += 7) {
            const glm::dvec2 expected = reference_albedo(r / 100.0, c / 100.0);
            const glm::vec4 texel = found["fitted"][size_t(r) * 100 + size_t(c) - 1];
            fit = glm::max(fit, glm::abs(glm::dvec2(texel) - expected));
        }
    std::printf("fit: largest errors %.5f and %.5f\n", fit.x, fit.y);
    EXPECT_LT(fit.x, 0.01);
    EXPECT_LT(fit.y, 0.01);
}

// Every surface of white spheres with all roughnesses reflects all light of a constant environment, so
// the spheres cannot be seen.
TEST_F(AmbientLight, WhiteSpheresVanishInAWhiteFurnace) {
    Result<scene::Scene> scene = scene::make_builtin("spheres");
    ASSERT_TRUE(scene);
    scene->lights.clear();
    scene->environment = picture_of([](const glm::dvec3&) { return 1; }, 32);
    for (size_t i = 0; i < scene->materials.size(); ++i) {
        scene::Material& material = scene->materials[i];
        material.base_color = glm::vec4(1);
        material.metallic = i % 2 == 0 ? 1.0f : 0.0f;
        material.roughness = float(i / 2) / float((scene->materials.size() - 1) / 2);
    }
    for (const char* graph : {"deferred", "forward"}) {
        const Rendered r =
            render(*scene, scene->cameras.at(0), {160, 90, 1}, 0, {"hdr", "depth"}, graph_path(graph));
        ASSERT_EQ(r.images.size(), 2u);
        size_t surfaces = 0;
        for (size_t i = 0; i < r.images.at("hdr").size(); ++i) {
            surfaces += r.images.at("depth")[i].r > 0 ? 1 : 0;
            ASSERT_NEAR(r.images.at("hdr")[i].g, 1, 0.005) << graph << ", pixel " << i;
        }
        EXPECT_GT(surfaces, 3000u);
    }
}

// Reads the module of the table with the light of single reflections only.
std::optional<std::string> read_single_reflections(const std::string& path) {
    std::optional<std::string> text = read_text(path);
    const std::string key = "\"default\": true";
    if (text && path.ends_with("modules/dfg.json"))
        text->replace(text->find(key), key.size(), "\"default\": false");
    return text;
}

TEST_F(AmbientLight, SingleReflectionsLoseTheLightOfTheTable) {
    scene::Scene scene;
    const std::unique_ptr<render::Session> session =
        start(scene, scene::Camera{}, kAmbientGraph, {16, 16, 1}, {"albedo"}, 0, read_single_reflections);
    ASSERT_TRUE(session && draw_frame(*session) && session->finish());
    const std::vector<vk::ReadbackData> read = session->take_readbacks();
    const auto albedo = std::ranges::find(read, "observe:albedo", &vk::ReadbackData::pass);
    ASSERT_TRUE(albedo != read.end());
    for (const glm::vec4& texel : render::decode_texels(albedo->format, albedo->bytes)) ASSERT_EQ(texel.b, 1);
}

// Renders the spheres with an environment, and returns the picture.
class AmbientPicture : public AmbientLight {
 protected:
    std::vector<glm::vec4> spheres(const Surroundings& light, float turn_rad, float exposure_ev) {
        Result<scene::Scene> scene = scene::make_builtin("spheres");
        if (!scene) return {};
        scene->lights.clear();
        scene->environment = picture_of(light);
        for (scene::Material& material : scene->materials) material.metallic = 1;
        const glm::mat4 turn = glm::rotate(glm::mat4(1), turn_rad, glm::vec3(0, 1, 0));
        for (scene::Instance& instance : scene->instances) instance.transform = turn * instance.transform;
        scene::Camera camera = scene->cameras.at(0);
        camera.transform = turn * camera.transform;
        return render(*scene, camera, {160, 90, 1}, exposure_ev, {"hdr"}).images["hdr"];
    }
};

void expect_same(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b, double mean_share,
                 double most_share) {
    ASSERT_EQ(a.size(), b.size());
    ASSERT_FALSE(a.empty());
    double sum = 0, most = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        const double share = std::abs(a[i].g - b[i].g) / b[i].g;
        sum += share / double(a.size());
        most = std::max(most, share);
    }
    std::printf("mean difference %.4f %%, largest %.4f %%\n", sum * 100, most * 100);
    EXPECT_LT(sum, mean_share);
    EXPECT_LT(most, most_share);
}

TEST_F(AmbientPicture, ATurnedSceneInATurnedEnvironmentLooksTheSame) {
    const float angle = 37 * float(kPi) / 180;
    const glm::dmat3 back(glm::rotate(glm::dmat4(1), -double(angle), glm::dvec3(0, 1, 0)));
    expect_same(spheres([&](const glm::dvec3& d) { return smooth_sky(back * d); }, angle, 0),
                spheres(smooth_sky, 0, 0), 0.004, 0.1);
}

TEST_F(AmbientPicture, AThousandTimesTheLightWithLessExposureLooksTheSame) {
    expect_same(spheres([](const glm::dvec3& d) { return smooth_sky(d) * 1000; }, 0, -std::log2(1000.0f)),
                spheres(smooth_sky, 0, 0), 0.0005, 0.004);
}

TEST_F(AmbientLight, ThePassesRestFromTheSecondFrameOn) {
    Result<scene::Scene> scene = scene::make_builtin("spheres");
    ASSERT_TRUE(scene);
    const std::unique_ptr<render::Session> session =
        start(*scene, scene->cameras.at(0), kDeferredGraph, {32, 18, 1}, {});
    ASSERT_TRUE(session);
    for (int frame = 0; frame < 3; ++frame) {
        frame_of(*session).exposure_ev = float(frame);  // The cube does not depend on the exposure.
        ASSERT_TRUE(draw_frame(*session, frame, 1));
        ASSERT_TRUE(session->finish());
        size_t found = 0;
        for (const vk::FrameTiming& timing : session->take_timings())
            for (const vk::PassTiming& pass : timing.passes) {
                if (!pass.pass.starts_with("environment") && pass.pass != "dfg") continue;
                ++found;
                EXPECT_EQ(pass.woken_by.empty(), frame > 0) << pass.pass << ", frame " << frame;
            }
        EXPECT_EQ(found, 17u);
    }
}

}  // namespace
}  // namespace weft::test
