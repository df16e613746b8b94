#include <cmath>

#include "tests/scene/gltf/gltf_fixture.h"

namespace weft::scene::test {
namespace {

glm::vec3 apply(const glm::mat4& m, const glm::vec3& p) {
    return glm::vec3(m * glm::vec4(p, 1));
}

class GltfNodes : public GltfTest {};

TEST_F(GltfNodes, ComposesTranslationRotationScale) {
    GltfText text;
    // The child node is rotated by 90° about z and scaled by 2 along x.
    text.members["nodes"] = R"([{"translation":[1,2,3],"children":[1]},
        {"mesh":0,"rotation":[0,0,0.70710678,0.70710678],"scale":[2,1,1]}])";
    const Scene scene = load(text);
    expect_near(apply(scene.instances.at(0).transform, {1, 0, 0}), {1, 4, 3});
    expect_near(scene.bounds.min, {0, 2, 3});
    expect_near(scene.bounds.max, {1, 4, 3});
    // Within one node, the scale applies first, then the rotation, then the translation.
    text.members["nodes"] =
        R"([{"mesh":0,"translation":[1,2,3],"rotation":[0,0,0.70710678,0.70710678],"scale":[2,1,1]}])";
    expect_near(apply(load(text).instances.at(0).transform, {1, 0, 0}), {1, 4, 3});
}

TEST_F(GltfNodes, ReadsMatricesByColumn) {
    GltfText text;
    text.members["nodes"] = R"([{"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,7,1]}])";
    expect_near(apply(load(text).instances.at(0).transform, {0, 0, 0}), {5, 6, 7});
}

TEST_F(GltfNodes, NegativeScaleStaysInTheTransform) {
    GltfText text;
    text.members["nodes"] = R"([{"mesh":0,"scale":[-1,1,1]}])";
    EXPECT_LT(glm::determinant(glm::mat3(load(text).instances.at(0).transform)), 0);
}

TEST_F(GltfNodes, OneMeshOfTwoPrimitivesBecomesTwo) {
    GltfText text;
    text.members["meshes"] = R"([{"name":"m","primitives":[{"attributes":{"POSITION":0},"material":0},
        {"attributes":{"POSITION":0}}]}])";
    const Scene scene = load(text);
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.meshes[1].name, "m/1");
    EXPECT_EQ(scene.materials.at(scene.instances[0].material).name, "plain");
    EXPECT_EQ(scene.materials.at(scene.instances[1].material).name, "default");
}

TEST_F(GltfNodes, LightsTakeTheirPlaceFromTheTree) {
    GltfText text;
    text.members["extensionsUsed"] = R"(["KHR_lights_punctual"])";
    text.members["extensions"] = R"({"KHR_lights_punctual":{"lights":[
        {"type":"spot","color":[1,0.5,0],"intensity":40,"range":9,"spot":{"innerConeAngle":0.1,"outerConeAngle":0.3}},
        {"type":"directional","intensity":100000}]}})";
    // The rotation of the parent node maps -z to -x, so the spot must face -x.
    text.members["nodes"] = R"([{"rotation":[0,0.70710678,0,0.70710678],"children":[1,2],"scale":[3,3,3]},
        {"translation":[0,0,1],"extensions":{"KHR_lights_punctual":{"light":0}}},
        {"name":"sun","extensions":{"KHR_lights_punctual":{"light":1}}}])";
    const Scene scene = load(text);
    ASSERT_EQ(scene.lights.size(), 2u);
    const Light& spot = scene.lights[0];
    EXPECT_EQ(spot.type, LightType::spot);
    expect_near(spot.position, {3, 0, 0});
    expect_near(spot.direction, {-1, 0, 0});
    EXPECT_FLOAT_EQ(spot.intensity, 40);
    EXPECT_FLOAT_EQ(spot.range_m, 9);
    EXPECT_FLOAT_EQ(spot.inner_cone_rad, 0.1f);
    EXPECT_FLOAT_EQ(spot.outer_cone_rad, 0.3f);
    EXPECT_FLOAT_EQ(spot.color.y, 0.5f);
    EXPECT_EQ(scene.lights[1].type, LightType::directional);
    EXPECT_EQ(scene.lights[1].name, "sun");
    EXPECT_FLOAT_EQ(scene.lights[1].range_m, 0);
}

TEST_F(GltfNodes, CamerasLoseScale) {
    GltfText text;
    text.members["cameras"] = R"([{"type":"perspective","perspective":{"yfov":0.7,"znear":0.1}},
        {"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"zfar":9,"znear":0}}])";
    text.members["nodes"] = R"([{"name":"front","camera":0,"scale":[4,4,4],"translation":[1,2,3]}])";
    const Scene scene = load(text);
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].name, "front");
    EXPECT_FLOAT_EQ(scene.cameras[0].fov_y_rad, 0.7f);
    EXPECT_FLOAT_EQ(glm::determinant(glm::mat3(scene.cameras[0].transform)), 1);
    expect_near(glm::vec3(scene.cameras[0].transform[3]), {1, 2, 3});
    EXPECT_TRUE(warned("S153"));
}

TEST_F(GltfNodes, OnlyTheChosenSceneIsLoaded) {
    GltfText text;
    text.members["nodes"] = R"([{"mesh":0},{"mesh":0,"name":"second"}])";
    text.members["scenes"] = R"([{"nodes":[0]},{"name":"other","nodes":[1]}])";
    text.members["scene"] = "1";
    const Scene scene = load(text);
    EXPECT_EQ(scene.name, "other");
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances[0].name, "second");
}

TEST_F(GltfNodes, RejectsCycles) {
    GltfText text;
    text.members["nodes"] = R"([{"children":[1]},{"children":[2]},{"children":[0]}])";
    text.members["scenes"] = R"([{"nodes":[]}])";
    EXPECT_EQ(where(fail(text)), "S109 /nodes/0/children");
    text.members["nodes"] = R"([{"children":[0]}])";
    EXPECT_EQ(where(fail(text)), "S109 /nodes/0/children");
    text.members["nodes"] = R"([{"children":[2]},{"children":[2]},{}])";
    EXPECT_EQ(where(fail(text)), "S109 /nodes/1/children");
}

TEST_F(GltfNodes, RejectsDeepTrees) {
    GltfText text;
    std::string nodes = "[";
    for (int i = 0; i < 2000; ++i) nodes += R"({"children":[)" + std::to_string(i + 1) + "]},";
    text.members["nodes"] = nodes + "{}]";
    EXPECT_EQ(fail(text).code, "S109");
}

TEST_F(GltfNodes, TransformsOutOfRangeAreLeftOut) {
    GltfText text;
    text.members["nodes"] = R"([{"scale":[1e10,1,1],"children":[1]},{"mesh":0,"scale":[1e10,1,1]}])";
    EXPECT_TRUE(load(text).instances.empty());
    EXPECT_TRUE(warned("S152"));
}

TEST_F(GltfNodes, TheFramingCameraSeesTheWholeScene) {
    const Scene scene = load(GltfText());
    const Camera camera = framing_camera(scene, 16.0f / 9);
    const glm::vec3 centre(0.5f, 0.5f, 0);
    const glm::vec3 eye(camera.transform[3]);
    const float radius = std::sqrt(2.0f) / 2;
    EXPECT_NEAR(glm::length(eye - centre), 1.9f * radius, 1e-4f);
    expect_near(-glm::vec3(camera.transform[2]), glm::normalize(centre - eye));
    EXPECT_NEAR(2 * std::atan(std::tan(camera.fov_y_rad / 2) * 16 / 9), 0.785398f, 1e-5f);
    EXPECT_NEAR(glm::determinant(glm::mat3(camera.transform)), 1, 1e-5f);
}

// The whole bounding sphere must be visible: the angle between the view axis and the edge of the sphere must
// be at most half of the smaller field of view, which is the horizontal one in a portrait.
TEST_F(GltfNodes, TheFramingCameraOfAPortraitHoldsTheBoundingSphere) {
    const Scene scene = load(GltfText());
    const float radius = glm::length(scene.bounds.max - scene.bounds.min) / 2;
    for (const float aspect : {0.99f, 9.0f / 16, 0.25f, 0.01f}) {
        const Camera camera = framing_camera(scene, aspect);
        const glm::vec3 centre = (scene.bounds.min + scene.bounds.max) * 0.5f;
        const float distance = glm::length(glm::vec3(camera.transform[3]) - centre);
        EXPECT_NEAR(distance, 1.9f * radius, 1e-4f);
        const float half_width = std::atan(std::tan(camera.fov_y_rad / 2) * aspect);
        EXPECT_GE(half_width, std::asin(radius / distance) - 1e-5f) << aspect;
        EXPECT_GE(camera.fov_y_rad / 2, half_width) << aspect;
    }
    // For aspect ratios of 1 and above, the horizontal field of view is always 45°.
    EXPECT_NEAR(framing_camera(scene, 1).fov_y_rad, 0.785398f, 1e-5f);
}

struct Odd {
    const char* name;
    const char* nodes;
    const char* place;  // Code and JSON pointer of the expected warning.
};

class OddTransform : public GltfTest, public ::testing::WithParamInterface<Odd> {};

TEST_P(OddTransform, IsNamedAndDrawn) {
    GltfText text;
    text.members["nodes"] = GetParam().nodes;
    const Scene scene = load(text);
    EXPECT_EQ(scene.instances.size(), 1u);
    ASSERT_EQ(warnings_.size(), 1u);
    EXPECT_EQ(where(warnings_[0]), GetParam().place);
    EXPECT_FALSE(warnings_[0].help.empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, OddTransform,
    ::testing::Values(Odd{"ZeroRotation", R"([{"mesh":0,"rotation":[0,0,0,0]}])", "S152 /nodes/0/rotation"},
                      Odd{"LongRotation", R"([{"mesh":0,"rotation":[0,0,0,2]}])", "S154 /nodes/0/rotation"},
                      Odd{"ZeroScale", R"([{"mesh":0,"scale":[0,0,0]}])", "S152 /nodes/0/scale"},
                      Odd{"FlatMatrix", R"([{"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,0,0, 0,0,0,1]}])",
                          "S152 /nodes/0/matrix"},
                      Odd{"OddLastRow", R"([{"mesh":0,"matrix":[1,0,0,0.5, 0,1,0,0, 0,0,1,0, 0,0,0,1]}])",
                          "S154 /nodes/0/matrix"},
                      Odd{"FlatScale", R"([{"mesh":0,"scale":[1,0,1]}])", "S152 /nodes/0/scale"}),
    [](const auto& row) { return std::string(row.param.name); });

TEST_F(GltfNodes, AZeroRotationTurnsNothing) {
    GltfText text;
    text.members["nodes"] = R"([{"mesh":0,"rotation":[0,0,0,0],"translation":[1,0,0]}])";
    expect_near(apply(load(text).instances.at(0).transform, {1, 0, 0}), {2, 0, 0});
    warnings_.clear();
    text.members["nodes"] = R"([{"mesh":0,"rotation":[0,0,0.7071,0.7071]}])";
    (void)load(text);
    EXPECT_TRUE(warnings_.empty()) << "rounding is no fault";
}

TEST_F(GltfNodes, AFarPlaneThatIsNearerThanTheNearOneIsNamed) {
    GltfText text;
    const auto camera = [&](const std::string& planes) {
        text.members["cameras"] = R"([{"type":"perspective","perspective":{"yfov":0.7,)" + planes + "}}]";
        text.members["nodes"] = R"([{"mesh":0,"camera":0}])";
        warnings_.clear();
    };
    camera(R"("znear":1,"zfar":0.5)");
    EXPECT_EQ(load(text).cameras.size(), 1u);
    ASSERT_EQ(warnings_.size(), 1u);
    EXPECT_EQ(where(warnings_[0]), "S154 /cameras/0/perspective/zfar");
    camera(R"("znear":1,"zfar":2,"aspectRatio":0)");
    (void)load(text);
    ASSERT_EQ(warnings_.size(), 1u);
    EXPECT_EQ(where(warnings_[0]), "S154 /cameras/0/perspective/aspectRatio");
    camera(R"("znear":1,"zfar":2)");
    (void)load(text);
    EXPECT_TRUE(warnings_.empty());
    camera(R"("znear":-1,"zfar":2)");
    EXPECT_EQ(where(fail(text)), "S108 /cameras/0/perspective/znear");
}

}  // namespace
}  // namespace weft::scene::test
