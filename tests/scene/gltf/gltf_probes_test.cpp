// Purpose: tests reflection probes of glTF nodes, and light probes of a scene from another program.
#include "tests/scene/gltf/gltf_fixture.h"
#include "weft/scene/place_probes.h"

namespace weft::scene::test {
namespace {

class GltfProbes : public GltfTest {
 protected:
    static GltfText with_nodes(const std::string& nodes, const std::string& roots) {
        GltfText text;
        text.members["nodes"] = nodes;
        text.members["scenes"] = R"([{"nodes":[)" + roots + "]}]";
        return text;
    }
};

TEST_F(GltfProbes, AnEmptyNodeIsACubeOfItsScale) {
    const Scene scene = load(with_nodes(
        R"([{"mesh":0},{"name":"hall","translation":[1,2,3],"scale":[4,2,-3],"rotation":[0,0.70710678,0,0.70710678],
            "extras":{"weft":{"probe":{}}}}])",
        "0,1"));
    ASSERT_EQ(scene.probes.reflections.size(), 1u);
    const ReflectionProbe& probe = scene.probes.reflections[0];
    EXPECT_EQ(probe.name, "hall");
    expect_near(probe.position, {1, 2, 3});
    ASSERT_TRUE(probe.box);
    expect_near(probe.box->center, {1, 2, 3});
    expect_near(probe.box->half_size_m, {4, 2, 3});
    // The x axis of the box lies along the z axis of the world, in one of the two directions.
    const glm::vec3 x = probe.box->rotation * glm::vec3(1, 0, 0);
    EXPECT_NEAR(std::abs(x.z), 1, 1e-5f);
    EXPECT_TRUE(warnings_.empty());
}

TEST_F(GltfProbes, ANodeWithAMeshHasTheBoxOfTheMesh) {
    GltfText text = with_nodes(
        R"([{"children":[1],"scale":[2,2,2]},{"mesh":0,"rotation":[0.5,0.5,0.5,0.5],"extras":{"weft":{"probe":{"position":[0.5,0.25,0]}}}}])",
        "0");
    // The triangle of the fixture is flat, so the probe is ignored.
    EXPECT_TRUE(load(text).probes.reflections.empty());
    EXPECT_TRUE(warned("S198"));
    warnings_.clear();
    const float positions[] = {0, 0, 0, 1, 0, 1, 0, 1, 3};
    std::memcpy(text.buffer.data(), positions, sizeof positions);
    const Scene scene = load(text);
    ASSERT_EQ(scene.probes.reflections.size(), 1u);
    const ReflectionProbe& probe = scene.probes.reflections[0];
    // The rotation maps x to y, y to z and z to x.
    expect_near(probe.box->center, {3, 1, 1});
    expect_near(probe.box->half_size_m, {1, 1, 3});
    expect_near(probe.position, {0, 1, 0.5f});
    expect_near(probe.box->rotation * glm::vec3(1, 0, 0), {0, 1, 0});
}

TEST_F(GltfProbes, ProbesBeyondTheLimitAreIgnored) {
    std::string nodes = R"([{"mesh":0})", roots = "0";
    for (int i = 1; i <= 25; ++i) {
        nodes += R"(,{"extras":{"weft":{"probe":{}}}})";
        roots += "," + std::to_string(i);
    }
    EXPECT_EQ(load(with_nodes(nodes + "]", roots)).probes.reflections.size(), kMostReflectionProbes);
    EXPECT_TRUE(warned("S198"));
}

TEST_F(GltfProbes, FaultsAreNamedWithTheirPlace) {
    EXPECT_EQ(where(fail(with_nodes(R"([{"mesh":0,"extras":{"weft":{"probe":3}}}])", "0"))),
              "S108 /nodes/0/extras/weft/probe");
    EXPECT_EQ(where(fail(with_nodes(R"([{"mesh":0,"extras":{"weft":{"probe":{"position":[1,2]}}}}])", "0"))),
              "S108 /nodes/0/extras/weft/probe/position");
    load(with_nodes(R"([{"mesh":0,"scale":[1,1,1],"extras":{"weft":{"probe":{"size":[1,1,1]}}}}])", "0"));
    EXPECT_TRUE(warned("S153"));
}

TEST_F(GltfProbes, ExtrasOfOtherProgramsAreIgnored) {
    const Scene scene = load(with_nodes(R"([{"mesh":0,"extras":{"probe":true,"other":{"probe":{}}}}])", "0"));
    EXPECT_TRUE(scene.probes.reflections.empty());
    EXPECT_TRUE(warnings_.empty());
}

// A room as other programs export it: one cube that is drawn with several nodes, some of them mirrored or
// turned, and a part of the walls by instancing.
TEST_F(GltfProbes, AForeignRoomHasProbesInside) {
    GltfText text = with_nodes(
        R"([{"name":"building","rotation":[0,0.38268343,0,0.92387953],"children":[1,2,3,4,5]},
            {"mesh":0,"translation":[0,-0.1,0],"scale":[4,0.1,3]},
            {"mesh":0,"translation":[0,3.1,0],"scale":[-4,0.1,3]},
            {"mesh":0,"translation":[4.1,1.5,0],"scale":[0.1,1.7,-3.2]},
            {"mesh":0,"translation":[-4.1,1.5,0],"scale":[-0.1,-1.7,-3.2]},
            {"mesh":0,"translation":[0,1.5,0],"scale":[4.2,1.7,0.1],
             "extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":3}}}}])",
        "0");
    text.members["extensionsUsed"] = R"(["EXT_mesh_gpu_instancing"])";
    text.buffer.clear();
    append<float>(text.buffer,
                  {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1});
    append<uint16_t>(text.buffer, {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                   2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5});
    append<float>(text.buffer, {0, 0, 31, 0, 0, -31});
    text.members["bufferViews"] =
        R"([{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72},{"buffer":0,"byteOffset":168,"byteLength":24}])";
    text.members["accessors"] =
        R"([{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[-1,-1,-1],"max":[1,1,1]},
            {"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"},
            {"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[-1,-1,-1],"max":[1,1,1]},
            {"bufferView":2,"componentType":5126,"count":2,"type":"VEC3"}])";
    text.members["meshes"] = R"([{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])";
    const Scene scene = load(text);
    ASSERT_EQ(scene.instances.size(), 6u);
    const Result<Probes> probes = place_probes(scene);
    ASSERT_TRUE(probes);
    const glm::mat4 to_room =
        glm::inverse(glm::mat4(glm::mat3_cast(glm::angleAxis(0.78539816f, glm::vec3(0, 1, 0)))));
    uint32_t inside = 0;
    for (const Probe& probe : probes->volume.probes) {
        if (probe.state == ProbeState::dropped) continue;
        const glm::vec3 place(to_room * glm::vec4(position_of(probes->volume, probe), 1));
        const glm::vec3 from_middle = glm::abs(place - glm::vec3(0, 1.5f, 0));
        const bool in_room = glm::all(glm::lessThan(from_middle, glm::vec3(4, 1.5f, 3)));
        const bool outside = glm::any(glm::greaterThan(from_middle, glm::vec3(4.2f, 1.7f, 3.2f)));
        EXPECT_TRUE(in_room || outside) << place.x << ", " << place.y << ", " << place.z;
        inside += in_room ? 1 : 0;
    }
    EXPECT_GT(inside, 30u);
}

}  // namespace
}  // namespace weft::scene::test
