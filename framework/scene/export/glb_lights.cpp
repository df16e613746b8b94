#include "scene/export/glb_lights.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>

#include "scene/export/glb_nodes.h"
#include "scene/model/lamp_area.h"

namespace weft::scene::glb {
namespace {

using Object = tinygltf::Value::Object;

// The largest door and picture that the loader accepts: in radians, and in metres for parallel light.
constexpr float kWidestAngle = 1.5707963f, kWidestLength_m = 1e6f;

bool has_shape(const Light& light) {
    return light.type == LightType::capsule || light.type == LightType::rectangle;
}

const char* type_name(LightType type) {
    if (type == LightType::directional) return "directional";
    return type == LightType::spot ? "spot" : "point";
}

// Returns the transform of the light's node. See place_light(): the light faces along −z, and the width of
// its shape and of its picture is along x.
glm::mat4 node_transform(const Light& light) {
    const bool capsule = light.type == LightType::capsule;
    const glm::vec3& along = light.direction;
    const glm::vec3 steep = std::abs(along.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 side = light.side - along * glm::dot(light.side, along);
    const glm::vec3 across = glm::normalize(glm::length(side) > 1e-3f ? side : glm::cross(along, steep));
    const glm::vec3 x = capsule ? along : across;
    const glm::vec3 z = capsule ? -across : -along;
    return {glm::vec4(x, 0), glm::vec4(glm::cross(z, x), 0), glm::vec4(z, 0),
            glm::vec4(position_at(light, 0), 1)};
}

Object function_of(const LightFunction& from, TextureTable& textures) {
    Object out;
    const float widest = from.parallel ? kWidestLength_m : kWidestAngle;
    if (from.doors != glm::vec4(LightFunction::kNoDoor))
        out["doors"] = json_array(glm::clamp(from.doors, -widest, widest));
    out["softness"] = json_number(from.softness);
    if (from.curve != glm::vec4(1))
        out["falloff"] =
            tinygltf::Value(Object{{"curve", json_array(from.curve)}, {"reach", json_number(from.reach_m)}});
    if (from.picture != kNone)
        out["picture"] =
            tinygltf::Value(Object{{"index", tinygltf::Value(textures.texture_without_sampler(from.picture))},
                                   {"halfSize", json_array(from.picture_half_size)}});
    return out;
}

// Returns the object `extras.weft` of the light. It is empty if glTF expresses all of the light.
Object extras_of(const Light& light, const Scene& scene, TextureTable& textures) {
    Object out;
    if (light.type == LightType::rectangle) {
        out["type"] = tinygltf::Value(std::string("rectangle"));
        out["size"] = json_array(light.half_size_m * 2.0f);
    } else if (light.type == LightType::capsule) {
        out["type"] = tinygltf::Value(std::string("capsule"));
        out["length"] = json_number(light.half_size_m.x * 2);
        out["radius"] = json_number(light.half_size_m.y);
    }
    if (light.function != kNone)
        out["function"] = tinygltf::Value(function_of(scene.light_functions[light.function], textures));
    return out;
}

tinygltf::Light light_of(const Light& from, const Scene& scene, TextureTable& textures) {
    tinygltf::Light to;
    to.name = from.name;
    to.type = type_name(from.type);
    // A colour of glTF is at most 1.
    const float brightest = std::max({1.0f, from.color.r, from.color.g, from.color.b});
    to.color = numbers_of(from.color / brightest);
    const float area_m2 = has_shape(from) ? seen_area_m2(from.type, from.half_size_m) : 1;
    to.intensity = double{from.intensity * brightest * area_m2};
    to.range = double{from.range_m};
    to.spot.innerConeAngle = double{from.inner_cone_rad};
    to.spot.outerConeAngle = double{from.outer_cone_rad};
    if (Object extras = extras_of(from, scene, textures); !extras.empty())
        to.extras = tinygltf::Value(Object{{"weft", tinygltf::Value(std::move(extras))}});
    return to;
}

}  // namespace

void add_lights(const Scene& scene, TextureTable& textures, tinygltf::Model& out) {
    for (const Light& light : scene.lights) {
        const int index = static_cast<int>(out.lights.size());
        out.lights.push_back(light_of(light, scene, textures));
        tinygltf::Node& node = add_node(light.name, node_transform(light), out);
        add_extension(out, node.extensions, "KHR_lights_punctual", {{"light", tinygltf::Value(index)}});
    }
}

}  // namespace weft::scene::glb
