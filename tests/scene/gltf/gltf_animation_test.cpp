// Purpose: tests how animations and EXT_mesh_gpu_instancing are read: what moves, which animations are played,
// and that wrong data give located errors.
#include <limits>

#include "tests/scene/gltf/gltf_fixture.h"

namespace weft::scene::test {
namespace {

// A triangle, and accessors of keys: 4 has the times 0 and 2; 5 has two translations (0,0,0) and (4,0,0); 6
// has two rotations, none and 180° about y; 7 has three scales.
class GltfAnimation : public GltfTest {
 protected:
    GltfAnimation() {
        view("SCALAR", 5126, 2, {0, 2});
        view("VEC3", 5126, 2, {0, 0, 0, 4, 0, 0});
        view("VEC4", 5126, 2, {0, 0, 0, 1, 0, 1, 0, 0});
        view("VEC3", 5126, 3, {1, 1, 1, 2, 2, 2, 3, 3, 3});
        text_.members["animations"] = kMoves;
    }

    void view(const std::string& type, int component, int count, std::initializer_list<float> values) {
        const size_t begin = text_.buffer.size();
        append<float>(text_.buffer, values);
        add_view(begin, type, component, count, "");
    }
    // Adds a view from `begin` to the end of the buffer, with an accessor for it. Returns the accessor's index.
    int add_view(size_t begin, const std::string& type, int component, int count, const std::string& more) {
        std::string& views = text_.members["bufferViews"];
        std::string& accessors = text_.members["accessors"];
        views.pop_back();
        views += ",{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) +
                 ",\"byteLength\":" + std::to_string(text_.buffer.size() - begin) + "}]";
        accessors.pop_back();
        accessors += ",{\"bufferView\":" + std::to_string(next_) + ",\"componentType\":" +
                     std::to_string(component) + ",\"count\":" + std::to_string(count) + ",\"type\":\"" +
                     type + "\"" + more + "}]";
        return next_++;
    }
    void set_key(size_t index, float value) {
        const size_t first_key = 104;  // The data of the triangle.
        std::memcpy(&text_.buffer[first_key + 4 * index], &value, sizeof value);
    }

    static constexpr const char* kMoves = R"([{"name":"go","samplers":[{"input":4,"output":5}],
        "channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}]}])";
    GltfText text_;
    int next_ = 4;
};

TEST_F(GltfAnimation, ANodeMovesWithItsMeshLightAndCamera) {
    text_.members["extensionsUsed"] = R"(["KHR_lights_punctual"])";
    text_.members["extensions"] = R"({"KHR_lights_punctual":{"lights":[{"type":"point"}]}})";
    text_.members["cameras"] = R"([{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}])";
    text_.members["nodes"] = R"([{"translation":[9,9,9],"children":[1,2]},
        {"mesh":0,"camera":0,"translation":[0,1,0],"extensions":{"KHR_lights_punctual":{"light":0}}},
        {"mesh":0,"matrix":[2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,5,1]}])";
    Scene scene = load(text_);
    EXPECT_TRUE(warnings_.empty());
    ASSERT_EQ(scene.motion.nodes.size(), 3u);
    EXPECT_EQ(scene.motion.animations.at(0).length_s, 2);
    // At time 0 the first key replaces the translation of the node.
    expect_near(glm::vec3(scene.instances.at(0).transform[3]), {0, 1, 0});
    expect_near(scene.lights.at(0).position, {0, 1, 0});
    const std::vector<glm::mat4> at_1s = transforms_at(scene.motion, 1);
    expect_near(glm::vec3(at_1s.at(scene.instances[0].node)[3]), {2, 1, 0});
    expect_near(glm::vec3(at_1s.at(scene.instances[1].node) * glm::vec4(1, 0, 0, 1)), {4, 0, 5});
    EXPECT_EQ(scene.lights[0].node, scene.instances[0].node);
    EXPECT_EQ(scene.cameras.at(0).node, scene.instances[0].node);
}

TEST_F(GltfAnimation, OnlyNodesBelowAnAnimatedOneMove) {
    text_.members["nodes"] = R"([{"children":[1,2],"translation":[0,3,0]},{"mesh":0},{"mesh":0}])";
    text_.members["animations"] = R"([{"samplers":[{"input":4,"output":6}],
        "channels":[{"sampler":0,"target":{"node":2,"path":"rotation"}}]}])";
    const Scene scene = load(text_);
    ASSERT_EQ(scene.motion.nodes.size(), 1u);
    EXPECT_EQ(scene.instances.at(0).node, kNone);
    EXPECT_EQ(scene.instances.at(1).node, 0u);
    // Half of 180° about y maps x to −z. The parent does not move, but its transform counts.
    expect_near(glm::vec3(transforms_at(scene.motion, 1)[0] * glm::vec4(1, 0, 0, 1)), {0, 3, -1});
}

TEST_F(GltfAnimation, RotationsMayBeNormalisedIntegers) {
    const size_t begin = text_.buffer.size();
    append<int16_t>(text_.buffer, {0, 0, 0, 32767, 0, 32767, 0, 0});
    const int accessor = add_view(begin, "VEC4", 5122, 2, ",\"normalized\":true");
    text_.members["animations"] = R"([{"samplers":[{"input":4,"output":)" + std::to_string(accessor) +
                                  R"(}],"channels":[{"sampler":0,"target":{"node":0,"path":"rotation"}}]}])";
    const Scene scene = load(text_);
    expect_near(glm::vec3(transforms_at(scene.motion, 1).at(0) * glm::vec4(1, 0, 0, 1)), {0, 0, -1});
    std::string& accessors = text_.members["accessors"];
    accessors.replace(accessors.find(",\"normalized\":true"), 18, "");
    EXPECT_EQ(where(fail(text_)), "S115 /animations/0/samplers/0/output");
}

TEST_F(GltfAnimation, AnimationsOfDifferentNodesPlayTogether) {
    text_.members["nodes"] = R"([{"mesh":0},{"mesh":0}])";
    text_.members["scenes"] = R"([{"nodes":[0,1]}])";
    const std::string samplers = R"("samplers":[{"input":4,"output":5}],"channels":[{"sampler":0,"target":)";
    text_.members["animations"] = "[{" + samplers + R"({"node":0,"path":"translation"}}]},{)" + samplers +
                                  R"({"node":1,"path":"translation"}}]},{"name":"run",)" + samplers +
                                  R"({"node":0,"path":"translation"}}]},{"name":"face",)" + samplers +
                                  R"({"node":0,"path":"weights"}}]}])";
    const Scene scene = load(text_);
    EXPECT_EQ(scene.motion.animations.size(), 2u);
    ASSERT_EQ(warnings_.size(), 2u);
    EXPECT_EQ(where(warnings_[0]), "S153 /animations/2");
    EXPECT_EQ(warnings_[0].message,
              "animation \"run\" is not played, because an earlier animation moves the same node");
    EXPECT_EQ(warnings_[1].message, "animation \"face\" is not played, because it moves no node");
}

TEST_F(GltfAnimation, IgnoredChannelsAreNamed) {
    text_.members["animations"] = R"([{"name":"go","samplers":[{"input":4,"output":5}],"channels":[
        {"sampler":0,"target":{"node":0,"path":"translation"}},{"sampler":0,"target":{"node":0,"path":"weights"}},
        {"sampler":0,"target":{"path":"translation"}}]}])";
    EXPECT_EQ(load(text_).motion.animations.at(0).channels.size(), 1u);
    ASSERT_EQ(warnings_.size(), 1u);
    EXPECT_EQ(warnings_[0].message,
              "animation \"go\": channels (2) that do not move, rotate or scale a node are ignored");
}

TEST_F(GltfAnimation, WrongKeysAreErrorsAtTheirSampler) {
    const char* input = "S115 /animations/0/samplers/0/input";
    const char* output = "S115 /animations/0/samplers/0/output";
    for (const float second : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(),
                               std::numeric_limits<float>::infinity()}) {
        set_key(1, second);
        EXPECT_EQ(where(fail(text_)), input) << second;
    }
    set_key(1, 2);
    set_key(0, -1);
    EXPECT_EQ(where(fail(text_)), input) << "negative";
    set_key(0, 0);
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), 1e16f}) {
        set_key(4, value);
        EXPECT_EQ(where(fail(text_)), output) << value;
    }
    set_key(4, 0);
    (void)load(text_);
}

TEST_F(GltfAnimation, WrongAccessorsAreErrors) {
    const auto with = [&](const std::string& sampler, const std::string& path) {
        text_.members["animations"] = R"([{"samplers":[)" + sampler +
                                      R"(],"channels":[{"sampler":0,"target":{"node":0,"path":")" + path +
                                      R"("}}]}])";
        return where(fail(text_));
    };
    const std::string at = "/animations/0/samplers/0/";
    EXPECT_EQ(with(R"({"input":4,"output":7})", "scale"), "S115 " + at + "output") << "three for two keys";
    EXPECT_EQ(with(R"({"input":4,"output":5,"interpolation":"CUBICSPLINE"})", "scale"), "S115 " + at + "output");
    EXPECT_EQ(with(R"({"input":5,"output":5})", "scale"), "S115 " + at + "input") << "no scalars";
    EXPECT_EQ(with(R"({"input":4,"output":6})", "scale"), "S115 " + at + "output") << "four components";
    EXPECT_EQ(with(R"({"input":4,"output":5})", "rotation"), "S115 " + at + "output");
    EXPECT_EQ(with(R"({"input":4,"output":99})", "scale"), "S110 " + at + "output");
    EXPECT_EQ(with(R"({"input":4})", "scale"), "S108 /animations/0/samplers/0");
    EXPECT_EQ(with(R"({"input":4,"output":5,"interpolation":"BEZIER"})", "scale"), "S108 " + at + "interpolation");
    EXPECT_EQ(with(R"({"input":4,"output":5})", "colour"), "S108 /animations/0/channels/0/target/path");
}

TEST_F(GltfAnimation, WrongTargetsAreErrors) {
    const auto with = [&](const std::string& channels) {
        text_.members["animations"] =
            R"([{"samplers":[{"input":4,"output":5}],"channels":[)" + channels + "]}]";
        return where(fail(text_));
    };
    const std::string good = R"({"sampler":0,"target":{"node":0,"path":"scale"}})";
    EXPECT_EQ(with(R"({"sampler":0,"target":{"node":5,"path":"scale"}})"),
              "S110 /animations/0/channels/0/target/node");
    EXPECT_EQ(with(R"({"sampler":3,"target":{"node":0,"path":"scale"}})"),
              "S110 /animations/0/channels/0/sampler");
    EXPECT_EQ(with(good + "," + good), "S115 /animations/0/channels/1/target/path");
    text_.members["nodes"] = R"([{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}])";
    EXPECT_EQ(with(good), "S115 /animations/0/channels/0/target/node");
}

TEST_F(GltfAnimation, HugeCountsAreRefusedBeforeMemoryIsUsed) {
    // Accessors without a buffer view: the file is small, but it asks for many keys.
    std::string& accessors = text_.members["accessors"];
    accessors.pop_back();
    accessors += R"(,{"componentType":5126,"count":3999999,"type":"SCALAR"},
        {"componentType":5126,"count":3999999,"type":"VEC3"}])";
    SceneLimits limits;
    limits.memory_bytes = 64ull << 20;
    text_.members["animations"] = R"([{"samplers":[{"input":8,"output":9}],
        "channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}]}])";
    EXPECT_EQ(where(fail(text_, limits)), "S107 /animations/0/samplers/0");
    text_.members.erase("animations");
    text_.members["nodes"] = R"([{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":
        {"TRANSLATION":9}}}}])";
    EXPECT_EQ(where(fail(text_)), "S107 /nodes/0");
}

class GltfInstancing : public GltfAnimation {
 protected:
    GltfInstancing() {
        text_.members.erase("animations");
        text_.members["extensionsUsed"] = R"(["EXT_mesh_gpu_instancing"])";
        text_.members["extensionsRequired"] = R"(["EXT_mesh_gpu_instancing"])";
    }
    void set_attributes(const std::string& attributes) {
        text_.members["nodes"] = R"([{"mesh":0,"translation":[0,10,0],
            "extensions":{"EXT_mesh_gpu_instancing":{"attributes":)" + attributes + "}}}]";
    }
};

TEST_F(GltfInstancing, EachElementIsAnInstance) {
    set_attributes(R"({"TRANSLATION":5,"ROTATION":6,"_COLOR":5})");
    const Scene scene = load(text_);
    EXPECT_TRUE(warnings_.empty());
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    expect_near(glm::vec3(scene.instances[0].transform * glm::vec4(1, 0, 0, 1)), {1, 10, 0});
    expect_near(glm::vec3(scene.instances[1].transform * glm::vec4(1, 0, 0, 1)), {3, 10, 0});
    set_attributes(R"({"SCALE":7})");
    const Scene scaled = load(text_);
    ASSERT_EQ(scaled.instances.size(), 3u);
    expect_near(glm::vec3(scaled.instances[2].transform * glm::vec4(1, 0, 0, 1)), {3, 10, 0});
}

TEST_F(GltfInstancing, InstancesFollowTheMotionOfTheirNode) {
    set_attributes(R"({"SCALE":7})");
    text_.members["animations"] = kMoves;
    const Scene scene = load(text_);
    ASSERT_EQ(scene.instances.size(), 3u);
    const std::vector<glm::mat4> nodes = transforms_at(scene.motion, 1.5);
    for (uint32_t i = 0; i < 3; ++i)
        expect_near(glm::vec3(nodes.at(scene.instances[i].node) * glm::vec4(1, 0, 0, 1)),
                    {3.0f + static_cast<float>(i + 1), 0, 0});
}

TEST_F(GltfInstancing, RotationsMayBeNormalisedBytes) {
    const size_t begin = text_.buffer.size();
    append<int8_t>(text_.buffer, {0, 127, 0, 0});
    const int accessor = add_view(begin, "VEC4", 5120, 1, ",\"normalized\":true");
    set_attributes("{\"ROTATION\":" + std::to_string(accessor) + "}");
    expect_near(glm::vec3(load(text_).instances.at(0).transform * glm::vec4(1, 0, 0, 1)), {-1, 10, 0});
    std::string& accessors = text_.members["accessors"];
    accessors.replace(accessors.find(",\"normalized\":true"), 18, "");
    EXPECT_EQ(where(fail(text_)), "S116 /nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/ROTATION");
}

TEST_F(GltfInstancing, WrongAttributesAreErrors) {
    const std::string at = "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/";
    set_attributes(R"({"TRANSLATION":5,"SCALE":7})");
    EXPECT_EQ(where(fail(text_)), "S116 " + at + "SCALE") << "counts 2 and 3";
    set_attributes(R"({"TRANSLATION":6})");
    EXPECT_EQ(where(fail(text_)), "S116 " + at + "TRANSLATION") << "four components";
    set_attributes(R"({"TRANSLATION":3})");
    EXPECT_EQ(where(fail(text_)), "S116 " + at + "TRANSLATION") << "integers";
    set_attributes(R"({"TRANSLATION":50})");
    EXPECT_EQ(where(fail(text_)), "S110 " + at + "TRANSLATION");
    SceneLimits limits;
    limits.instances = 2;
    set_attributes(R"({"SCALE":7})");
    EXPECT_EQ(where(fail(text_, limits)), "S107 /nodes/0");
}

TEST_F(GltfTest, BasisTexturesNeedAnotherImage) {
    GltfText text;
    const std::vector<uint8_t> white(4, 255);
    text.members["images"] = R"([{"uri":")" + data_uri(png(1, 1, white)) + R"("}])";
    text.members["extensionsUsed"] = R"(["KHR_texture_basisu"])";
    text.members["materials"] = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])";
    text.members["textures"] = R"([{"source":0,"extensions":{"KHR_texture_basisu":{"source":0}}}])";
    EXPECT_EQ(load(text).textures.size(), 1u);
    EXPECT_TRUE(warnings_.empty()) << "nothing is lost: the PNG is used";
    text.members["textures"] = R"([{"extensions":{"KHR_texture_basisu":{"source":0}}}])";
    EXPECT_EQ(where(fail(text)), "S117 /textures/0/extensions/KHR_texture_basisu");
    text.members["textures"] = R"([{"source":0}])";
    text.members["extensionsRequired"] = R"(["KHR_texture_basisu"])";
    const Diagnostic refused = fail(text);
    EXPECT_EQ(where(refused), "S105 /extensionsRequired/0");
    EXPECT_EQ(refused.help.at(0), "convert the textures to PNG or JPEG");
}

}  // namespace
}  // namespace weft::scene::test
