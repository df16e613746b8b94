// Purpose: checks the JSON of a glTF before any buffer is read: types, ranges, indices, extents of accessors
// and views, the node tree, extensions. The result is a reduced JSON text for tinygltf. In this text each
// buffer has a number instead of a URI, so tinygltf never sees a URI.
#pragma once

#include <cstdint>
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

struct CheckedJson {
    // The JSON without images, animations, skins, extras and unknown extensions. The URI of buffer i is the
    // text "i".
    std::string text;
    std::vector<BufferSource> buffers;
    std::vector<ImageSource> images;
    std::vector<LightSource> lights;  // One entry per light of the glTF file; empty when no light has extras.
};

// Checks the JSON of a glTF file. Returns nullopt after errors were reported.
[[nodiscard]] std::optional<CheckedJson> check_gltf(std::string_view json, const SceneLimits& limits,
                                                    Report& report);

}  // namespace weft::scene::gltf
