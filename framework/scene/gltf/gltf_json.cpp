#include <iterator>
#include <new>
#include <nlohmann/json.hpp>

#include "scene/gltf/gltf_container.h"
#include "scene/gltf/gltf_keys.h"
#include "scene/gltf/gltf_rules.h"

namespace weft::scene::gltf {
namespace {

using nlohmann::json;

// Removes extras and unknown extensions, so that a small file cannot become a large model in memory. Converts
// numbers to the types that tinygltf expects. Outside extensions, whole numbers become integers (3.0 becomes
// 3). Inside extensions, all numbers become floating point.
void normalise(json& value, bool in_extension) {
    if (value.is_object()) {
        value.erase("extras");
        for (auto& [key, member] : value.items()) {
            if (key == "extensions" && member.is_object()) {
                for (auto it = member.begin(); it != member.end();) {
                    it = is_kept_extension(it.key()) ? std::next(it) : member.erase(it);
                }
            }
            normalise(member, in_extension || key == "extensions");
        }
    } else if (value.is_array()) {
        for (json& item : value) normalise(item, in_extension);
    } else if (in_extension && value.is_number_integer()) {
        value = value.get<double>();
    } else if (!in_extension && value.is_number_float()) {
        if (const std::optional<int64_t> whole = whole_number(value)) {
            if (*whole >= 0) value = static_cast<uint64_t>(*whole);
            if (*whole < 0) value = *whole;
        }
    }
}

// Returns an array with one item per item of the array at `place`: the item's member `ours`, or null if the
// item has no such member.
json members_at(const json& root, const json::json_pointer& place, const json::json_pointer& ours) {
    json members = json::array();
    if (!root.contains(place) || !root[place].is_array()) return members;
    for (const json& item : root[place])
        members.push_back(item.is_object() && item.contains(ours) ? item[ours] : json());
    return members;
}

std::optional<json> parse_json(std::string_view text, Report& report) {
    try {
        json root = json::parse(text.begin(), text.end());
        if (root.is_object()) return root;
        report.error("S102", {}, "the JSON is " + describe(root) + "; wanted an object",
                     "name a .gltf or .glb file; this file is not glTF");
    } catch (const json::parse_error& fault) {
        const TextPosition at = position_of(text, fault.byte > 0 ? fault.byte - 1 : 0);
        const bool cut = fault.byte > text.size();
        report.error_at("S102", at.line, at.column,
                        cut ? "the JSON ends inside an object, array or string"
                            : "the text is not valid JSON from this place on",
                        cut ? "copy or export the file again, because it is truncated"
                            : "correct the syntax at this place, or name a .gltf or .glb file");
    } catch (const std::bad_alloc&) {
        // Memory that runs out is not a fault of the file. load_gltf() catches this exception and reports it.
        throw;
    } catch (const std::exception& fault) {
        report.error("S102", {}, std::string("the JSON cannot be read: ") + fault.what(),
                     "export the scene again");
    }
    return std::nullopt;
}

}  // namespace

std::optional<CheckedJson> check_gltf(std::string_view text, const SceneLimits& limits, Report& report) {
    std::optional<json> root = parse_json(text, report);
    if (!root) return std::nullopt;
    check_keys(text, report);
    // No other extras are read.
    const json::json_pointer ours("/extras/weft");
    const json lights = members_at(*root, json::json_pointer("/extensions/KHR_lights_punctual/lights"), ours);
    const json probes = members_at(*root, json::json_pointer("/nodes"), ours / "probe");
    const json materials = members_at(*root, json::json_pointer("/materials"), ours);
    normalise(*root, false);
    Checker c{Fields(*root, "", report), limits, report};
    check_header(c);
    // If an array is wrong, its size counts as 0. Then every index into this array would cause one more error
    // for the same fault. So checking stops here.
    if (report.failed()) return std::nullopt;
    check_geometry(c);
    check_materials(c);
    if (!report.failed()) check_material_extras(c, materials);
    check_nodes(c);
    check_light_extras(c, lights);
    if (!report.failed()) check_probe_extras(c, probes);
    check_motion(c);
    check_animations(c);
    check_instancing(c);
    if (report.failed()) return std::nullopt;
    for (const char* key : {"images", "animations", "skins"}) root->erase(key);
    for (size_t i = 0; i < c.out.buffers.size(); ++i) (*root)["buffers"][i]["uri"] = std::to_string(i);
    c.out.text = root->dump(-1, ' ', false, json::error_handler_t::replace);
    return std::move(c.out);
}

}  // namespace weft::scene::gltf
