// Purpose: checks everything that the JSON of a glTF alone can show, before any buffer is read: types,
// ranges, indices, extents of accessors and views, the node tree, extensions. The result is a reduced JSON
// text whose buffers have numbers instead of names, so the JSON parser used later never sees a URI.
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
    std::optional<std::string> uri;  // none: the buffer is the binary chunk of the .glb
    uint64_t length_bytes = 0;
};

struct ImageSource {
    std::string name;
    std::string uri;
    uint32_t view = kNone;  // buffer view of the image; used when `uri` is empty
};

// The light's `extras.weft`, with values inside the ranges of light_check.h.
struct LightSource {
    std::optional<LightType> shape;         // capsule or rectangle; replaces the light's own type
    glm::vec2 half_size_m{0};               // same meaning as Light::half_size_m
    std::optional<LightFunction> function;  // its picture is the index of a glTF texture
};

struct CheckedJson {
    std::string text;  // without images, animations, skins and extras; buffer i has the URI "i"
    std::vector<BufferSource> buffers;
    std::vector<ImageSource> images;
    std::vector<LightSource> lights;  // one entry per light; empty when no light has extras
};

// nullopt after errors were reported.
[[nodiscard]] std::optional<CheckedJson> check_gltf(std::string_view json, const SceneLimits& limits,
                                                    Report& report);

}  // namespace weft::scene::gltf
