// Purpose: the state that all check functions share while the JSON of a glTF is checked, and the list of
// these functions.
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

// Largest accepted value of numbers for which glTF sets no upper limit. Fields::number() accepts no larger
// number.
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
    // Number of items in each top-level array of the file, by the name of the array ("meshes"). The entry
    // "lights" is the array of KHR_lights_punctual.
    std::map<std::string, size_t> sizes{};
    // Lengths and strides of the buffer views in bytes; a stride of 0 means that the file gives none.
    std::vector<uint64_t> view_lengths{};
    std::vector<uint64_t> view_strides{};
    std::vector<AccessorShape> accessors{};
    uint64_t sparse_values = 0;  // Number of sparse values in all accessors that were checked so far.
};

[[nodiscard]] bool is_known_extension(std::string_view name);
// Returns true if the checks read the content of this extension. This is so for the extensions that Weft
// supports, and for KHR_texture_basisu, which Weft reads only to name it in messages.
[[nodiscard]] bool is_kept_extension(std::string_view name);

void check_header(Checker& c);     // Checks `asset`, the extensions, and the sizes of the arrays.
void check_geometry(Checker& c);   // Checks buffers, buffer views, accessors and meshes.
void check_materials(Checker& c);  // Checks images, textures, samplers and materials.
// Checks the objects `extras.weft` of the materials. `objects` has one entry for each material: the object,
// or null if the material has no such object.
void check_material_extras(Checker& c, const nlohmann::json& objects);
void check_nodes(Checker& c);  // Checks lights, cameras, nodes and scenes.
// Checks the objects `extras.weft` of the lights of the file. `objects` has one entry for each light: the
// object, or null if the light has no such object.
void check_light_extras(Checker& c, const nlohmann::json& objects);
// Checks the objects `extras.weft.probe` of the nodes. `objects` has one entry for each node: the object, or
// null if the node has no such object.
void check_probe_extras(Checker& c, const nlohmann::json& objects);
// Returns the fields of `ours`, an object of Weft in the extras of the file, whose place is the JSON pointer
// `place`. Returns nullopt if it is null, or, with an error, if it is not an object. `example` is the help
// for the error.
[[nodiscard]] std::optional<Fields> extras_object(Checker& c, const nlohmann::json& ours,
                                                  const std::string& place, const std::string& example);
// Warns of keys that are not known.
void warn_of_other_keys(Checker& c, const Fields& fields, std::initializer_list<const char*> known);
// Warns that skins and morph targets are ignored: the meshes are drawn in their rest pose.
void check_motion(Checker& c);
// Checks the animations. Warns of each animation that is not played because an earlier animation moves the
// same node.
void check_animations(Checker& c);
void check_instancing(Checker& c);  // Checks EXT_mesh_gpu_instancing of all nodes.

}  // namespace weft::scene::gltf
