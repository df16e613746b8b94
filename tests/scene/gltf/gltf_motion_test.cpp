// Purpose: tests that meshes with skins and morph targets are shown in their rest pose, and that warnings name
// these objects. gltf_animation_test.cpp tests animations.
#include "tests/scene/gltf/gltf_fixture.h"

namespace weft::scene::test {
namespace {

class GltfMotion : public GltfTest {};

TEST_F(GltfMotion, ASkinNamesItsNodeAndMesh) {
    GltfText text;
    text.members["nodes"] = R"([{"name":"body","mesh":0,"skin":0,"children":[1]},{}])";
    text.members["skins"] = R"([{"joints":[1]}])";
    const Scene scene = load(text);
    ASSERT_EQ(warnings_.size(), 1u);
    EXPECT_EQ(where(warnings_[0]), "S153 /nodes/0/skin");
    EXPECT_EQ(warnings_[0].message,
              "node \"body\": the skin is ignored, so mesh \"tri\" is shown without a pose");
    EXPECT_EQ(scene.meshes.at(0).positions.at(1), glm::vec3(1, 0, 0));
}

TEST_F(GltfMotion, MorphTargetsNameTheirMeshAndLeaveTheBase) {
    GltfText text;
    text.members["meshes"] =
        R"([{"primitives":[{"attributes":{"POSITION":0},"targets":[{"POSITION":1},{"POSITION":1}]},
        {"attributes":{"POSITION":0},"targets":[{"POSITION":1}]}],"weights":[1,1]}])";
    const Scene scene = load(text);
    ASSERT_EQ(warnings_.size(), 1u) << "one for each mesh";
    EXPECT_EQ(where(warnings_[0]), "S153 /meshes/0");
    EXPECT_EQ(warnings_[0].message, "mesh 0: morph targets (2) are ignored, so the base shape is shown");
    EXPECT_EQ(scene.meshes.at(0).positions.at(1), glm::vec3(1, 0, 0));
}

TEST_F(GltfMotion, NodesThatAreNotThereAreErrors) {
    GltfText text;
    text.members["animations"] = R"([{"samplers":[{"input":0,"output":0}],"channels":[{"sampler":0,"target":{"node":7,"path":"scale"}}]}])";
    (void)fail(text);
    EXPECT_EQ(where(errors_.back()), "S110 /animations/0/channels/0/target/node");
    text.members.erase("animations");
    text.members["nodes"] = R"([{"mesh":0,"skin":3}])";
    EXPECT_EQ(where(fail(text)), "S110 /nodes/0/skin");
}

TEST_F(GltfMotion, WarningsNameTheirMeshOrNode) {
    GltfText text;
    text.members["meshes"] =
        R"([{"name":"wire","primitives":[{"mode":1,"attributes":{"POSITION":0}},{"attributes":{"POSITION":0}}]}])";
    load(text);
    EXPECT_EQ(warnings_.at(0).message,
              "part 0 of mesh \"wire\" consists of lines and is ignored, because Weft draws only triangles");
    GltfText far;
    far.members["nodes"] = R"([{"name":"far","mesh":0,"scale":[1e17,1,1]}])";
    load(far);
    EXPECT_EQ(warnings_.at(0).message,
              "node \"far\": the transform in the scene is too large or not finite; the node and its "
              "descendants are ignored");
}

}  // namespace
}  // namespace weft::scene::test
