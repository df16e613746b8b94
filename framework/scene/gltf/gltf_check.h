// Purpose: everything that can be checked in a glTF's JSON before any buffer is read: types, ranges, indices,
// extents of accessors and views, the shape of the node tree, extensions. What passes is handed on as a
// smaller JSON text whose buffers are named by number, so that the parser behind it never sees a URI.
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
    std::optional<std::string> uri;  // none: the binary chunk of the .glb
    uint64_t length_bytes = 0;
};

struct ImageSource {
    std::string name;
    std::string uri;
    uint32_t view = kNone;  // used when `uri` is empty
};

// What `extras.weft` says of a light, within the ranges of light_check.h.
struct LightSource {
    std::optional<LightType> shape;         // capsule or rectangle, in place of the light's own type
    glm::vec2 half_size_m{0};               // as Light's
    std::optional<LightFunction> function;  // its picture is the index of a glTF texture
};

struct CheckedJson {
    std::string text;  // without images, animations, skins and extras; buffer i has the URI "i"
    std::vector<BufferSource> buffers;
    std::vector<ImageSource> images;
    std::vector<LightSource> lights;  // by light; empty: none says anything
};

// nullopt after errors were reported.
[[nodiscard]] std::optional<CheckedJson> check_gltf(std::string_view json, const SceneLimits& limits,
                                                    Report& report);

}  // namespace weft::scene::gltf
