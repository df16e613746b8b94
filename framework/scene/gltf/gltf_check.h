// Purpose: checks the JSON of a glTF before any buffer is read: types, ranges, indices, extents of accessors
// and views, the node tree, extensions. The result is a reduced JSON text for tinygltf. In this text each
// buffer has a number instead of a URI, so tinygltf never sees a URI.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/loading/gltf_report.h"
#include "weft/scene/load_gltf.h"

namespace weft::scene::gltf {

struct BufferSource {
    // URI of the buffer. Without a URI, the buffer is the binary chunk of the .glb file.
    std::optional<std::string> uri;
    uint64_t length_bytes = 0;
};

struct ImageSource {
    std::string name;
    std::string uri;
    uint32_t view = kNone;  // Index of the buffer view that contains the image; used when `uri` is empty.
};

// The values that a light has in its JSON member `extras.weft`. Values out of range are already clamped.
struct LightSource {
    // Shape of the light, capsule or rectangle. If present, it replaces the light's glTF type.
    std::optional<LightType> shape;
    // Half of the light's size in metres, with the same meaning as Light::half_size_m.
    glm::vec2 half_size_m{0};
    std::optional<LightFunction> function;  // Light function. Its `picture` is the index of a glTF texture.
};

// Indices of the accessors of an animation's sampler; kNone after an error.
struct AnimationSamplerSource {
    uint32_t input = kNone;
    uint32_t output = kNone;
    Interpolation interpolation = Interpolation::linear;
};

struct AnimationChannelSource {
    uint32_t node = 0;
    MotionPath path = MotionPath::translation;
    uint32_t sampler = 0;
};

// An animation that Weft plays.
struct AnimationSource {
    std::string name;
    size_t index = 0;  // Index in the "animations" of the file.
    std::vector<AnimationSamplerSource> samplers;
    std::vector<AnimationChannelSource> channels;
};

// The accessors of EXT_mesh_gpu_instancing of one node. Those that are not kNone have the same number of
// elements, and at least one is not kNone.
struct InstancingSource {
    uint32_t translation = kNone;
    uint32_t rotation = kNone;
    uint32_t scale = kNone;
};

// The values of the JSON member `extras.weft.probe` of a node.
struct ProbeSource {
    std::optional<glm::vec3> position;  // In the space of the node; nullopt: the middle of the box.
};

struct CheckedJson {
    // The JSON without images, animations, skins, extras and unknown extensions. The URI of buffer i is the
    // text "i".
    std::string text;
    std::vector<BufferSource> buffers;
    std::vector<ImageSource> images;
    std::vector<LightSource> lights;  // One entry per light of the glTF file; empty when no light has extras.
    std::map<uint32_t, float>
        diffuse_roughness_rad;              // `extras.weft.diffuseRoughness`. Key: index of a material.
    std::map<uint32_t, glm::vec4> ripples;  // `extras.weft.ripples`. Key: index of a material.
    std::vector<AnimationSource> animations;
    std::map<uint32_t, InstancingSource> instancing;  // Key: index of a node.
    std::map<uint32_t, ProbeSource> probes;           // Key: index of a node.
};

// Checks the JSON of a glTF file. Returns nullopt after errors were reported.
[[nodiscard]] std::optional<CheckedJson> check_gltf(std::string_view json, const SceneLimits& limits,
                                                    Report& report);

}  // namespace weft::scene::gltf
