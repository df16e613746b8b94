// Purpose: finds duplicate keys in an object of a glTF's JSON. JSON parsers accept duplicate keys; some
// parsers use the first value and some the last. Keys are compared after their escapes are decoded. Malformed
// JSON is not reported here: the JSON parser reports it. Errors: S114, with line and column of the second
// key; at most 16 are reported.
#pragma once

#include <string_view>

#include "scene/loading/gltf_report.h"

namespace weft::scene::gltf {

void check_keys(std::string_view json, Report& report);

}  // namespace weft::scene::gltf
