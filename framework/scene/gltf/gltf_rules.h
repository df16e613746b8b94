// Purpose: state that the rules for the parts of a glTF share while its JSON is checked.
#pragma once

#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "scene/gltf/gltf_check.h"
#include "scene/gltf/gltf_fields.h"

namespace weft::scene::gltf {

inline constexpr double kUnbounded = 1e18;
inline constexpr double kHalfPi = std::numbers::pi / 2;

struct AccessorShape {
    uint64_t count = 0;
    uint64_t component_type = 0;
    uint32_t components = 0;
    bool has_view = false;
};

struct Checker {
    Fields root;
    const SceneLimits& limits;
    Report& report;
    CheckedJson out{};
    std::map<std::string, size_t> sizes{};  // sizes of the file's arrays, by the array's name
    std::vector<uint64_t> view_lengths{};
    std::vector<uint64_t> view_strides{};
    std::vector<AccessorShape> accessors{};
    uint64_t sparse_values = 0;  // of all accessors checked so far
};

[[nodiscard]] bool is_known_extension(std::string_view name);

void check_header(Checker& c);     // asset, extensions, array sizes
void check_geometry(Checker& c);   // buffers, views, accessors, meshes
void check_materials(Checker& c);  // images, textures, samplers, materials
void check_nodes(Checker& c);      // lights, cameras, nodes, scenes
// `extras` has one entry per light: its `extras.weft`, or null.
void check_light_extras(Checker& c, const nlohmann::json& extras);
void check_motion(Checker& c);  // skins, morph targets and animations: warns that they are drawn in their
                                // rest pose

}  // namespace weft::scene::gltf
