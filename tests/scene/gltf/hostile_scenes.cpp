#include "tests/scene/gltf/hostile_scenes.h"

#include <nlohmann/json.hpp>
#include <random>
#include <vector>

#include "tests/scene/gltf/gltf_fixture.h"
#include "tests/viewer/pictures/bit_png.h"

namespace weft::test {
namespace {

using Json = nlohmann::json;
using scene::test::Bytes;

// Generates random numbers. Only std::mt19937 is used, because it gives the same numbers on every platform;
// the standard's distributions do not.
class Dice {
 public:
    explicit Dice(uint32_t seed) : random_(seed) {}
    uint32_t below(uint32_t count) { return static_cast<uint32_t>(random_() % count); }

 private:
    std::mt19937 random_;
};

std::string as_uri(const std::string& bytes) {
    return scene::test::data_uri({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
}

Json whole_scene() {
    Bytes bytes;
    scene::test::append<float>(bytes, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});  // Positions of four vertices.
    scene::test::append<float>(bytes, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});  // Normals of four vertices.
    scene::test::append<float>(bytes, {0, 1, 1, 1, 0, 0, 1, 0});  // Texture coordinates of four vertices.
    // Indices of two triangles, with two values of padding.
    scene::test::append<uint16_t>(bytes, {0, 1, 2, 2, 1, 3, 0, 0});
    // Colours of four vertices, 8 bits per channel.
    scene::test::append<uint8_t>(bytes, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 9, 9, 9});
    scene::test::append<float>(bytes, {0, 0.5f, 1, 2});  // Times of four keys.
    Json root = Json::parse(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,3]},{"nodes":[3]}],
      "nodes":[{"mesh":0,"children":[1,2],"name":"root","scale":[1,2,1]},
        {"camera":0,"translation":[0,0,3],"rotation":[0,0,0,1]},
        {"extensions":{"KHR_lights_punctual":{"light":0}}},
        {"mesh":1,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,2,0,0,1],
         "extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":1,"SCALE":5}}}}],
      "cameras":[{"type":"perspective","perspective":{"yfov":0.8,"znear":0.1,"zfar":100}}],
      "meshes":[{"name":"a","primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"COLOR_0":4},"indices":3,"material":0}]},
        {"primitives":[{"mode":5,"attributes":{"POSITION":5},"material":1},{"mode":6,"attributes":{"POSITION":6}}]}],
      "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"offset":[0.1,0],"scale":[2,2],"rotation":1}}},
        "metallicRoughnessTexture":{"index":1,"texCoord":1}},"normalTexture":{"index":0,"scale":0.5},"alphaMode":"MASK","alphaCutoff":0.3,
        "extensions":{"KHR_materials_specular":{"specularFactor":0.4},"KHR_materials_anisotropy":{"anisotropyStrength":0.5,"anisotropyTexture":{"index":1}}}},
        {"alphaMode":"BLEND","doubleSided":true,"emissiveFactor":[1,0.5,0],"extensions":{"KHR_materials_unlit":{},"KHR_materials_ior":{"ior":1.3}}}],
      "textures":[{"source":0,"sampler":0},{"source":1}],"samplers":[{"wrapS":33071,"magFilter":9728,"minFilter":9987}],
      "images":[{"name":"i"},{}],
      "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
        {"bufferView":1,"componentType":5126,"count":4,"type":"VEC3"},{"bufferView":2,"componentType":5126,"count":4,"type":"VEC2"},
        {"bufferView":3,"componentType":5123,"count":6,"type":"SCALAR"},{"bufferView":4,"componentType":5121,"normalized":true,"count":4,"type":"VEC4"},
        {"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":2,"indices":{"bufferView":3,"componentType":5123},"values":{"bufferView":0}}},
        {"componentType":5126,"count":5,"type":"VEC3"},{"bufferView":5,"componentType":5126,"count":4,"type":"SCALAR"}],
      "bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":48},{"buffer":0,"byteOffset":96,"byteLength":32},
        {"buffer":0,"byteOffset":128,"byteLength":16},{"buffer":0,"byteOffset":144,"byteLength":16},{"buffer":0,"byteOffset":160,"byteLength":16}],
      "animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}},{"sampler":1,"target":{"node":1,"path":"scale"}}],
        "samplers":[{"input":7,"output":1},{"input":7,"output":5,"interpolation":"STEP"}]}],
      "skins":[{"joints":[0,1]}],
      "extensionsUsed":["KHR_lights_punctual","KHR_texture_transform","KHR_materials_unlit"],
      "extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","intensity":4,"spot":{"outerConeAngle":0.5},
        "extras":{"weft":{"type":"rectangle","size":[1,2],"function":{"doors":[0.4,0.4,0.6,0.3],"picture":{"index":0}}}}}]}}})");
    root["buffers"] = {{{"byteLength", bytes.size()}, {"uri", scene::test::data_uri(bytes)}}};
    root["images"][0]["uri"] = as_uri(black_png(8, 8));
    root["images"][1]["uri"] = as_uri(black_png(16, 4));
    return root;
}

void collect(Json& value, std::vector<Json*>& all) {
    all.push_back(&value);
    if (value.is_structured())
        for (Json& item : value) collect(item, all);
}

Json odd_value(Dice& dice) {
    switch (dice.below(16)) {
        case 0:
            return 0;
        case 1:
            return -1;
        case 2:
            return 1;
        case 3:
            return 4294967295u;
        case 4:
            return 9007199254740992.0;
        case 5:
            return 1e308;
        case 6:
            return -1e308;
        case 7:
            return 0.5;
        case 8:
            return 3'000'000;
        case 9:
            return nullptr;
        case 10:
            return true;
        case 11:
            return "";
        case 12:
            return std::string(100'000, 'x');
        case 13:
            return Json::array();
        case 14:
            return Json::object();
        default:
            return as_uri(swollen_png(1'000'000));
    }
}

Json nested(uint32_t depth) {
    Json value = 0;
    for (uint32_t i = 0; i < depth; ++i) value = i % 2 == 0 ? Json::array({value}) : Json{{"a", value}};
    return value;
}

void spoil(Json& root, Dice& dice) {
    std::vector<Json*> all;
    collect(root, all);
    Json& target = *all[dice.below(static_cast<uint32_t>(all.size()))];
    Json& other = *all[dice.below(static_cast<uint32_t>(all.size()))];
    switch (dice.below(8)) {
        case 0:
        case 1:
        case 2:
            if (!target.is_structured()) target = odd_value(dice);
            break;
        case 3: {  // Copies a value from another place of the file to a place where it does not belong.
            Json copy = other;
            target = std::move(copy);
            break;
        }
        case 4:  // Removes one member or element.
            if (target.is_structured() && !target.empty())
                target.erase(std::next(target.begin(), dice.below(static_cast<uint32_t>(target.size()))));
            break;
        case 5:  // Repeats the first element of an array many times.
            if (target.is_array() && !target.empty()) {
                const Json item = target[0];
                const uint32_t times = item.is_structured() ? 500 + dice.below(20'000) : 100'000;
                if (item.dump().size() < 400)
                    for (uint32_t i = 0; i < times; ++i) target.push_back(item);
            }
            break;
        case 6:
            if (target.is_object() && &target != &root) target["extras"] = nested(dice.below(200));
            break;
        default:
            if (target.is_number()) target = target.get<double>() + dice.below(3) - 1;
            break;
    }
}

}  // namespace

std::string hostile_scene(uint32_t seed) {
    Dice dice(seed);
    Json root = whole_scene();
    const uint32_t faults = 1 + dice.below(4);
    for (uint32_t i = 0; i < faults; ++i) spoil(root, dice);
    std::string text = root.dump();
    if (dice.below(16) == 0) text.resize(dice.below(static_cast<uint32_t>(text.size())));
    if (dice.below(16) == 0) text[dice.below(static_cast<uint32_t>(text.size()))] = '{';
    return text;
}

}  // namespace weft::test
