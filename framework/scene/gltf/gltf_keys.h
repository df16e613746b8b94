// Purpose: finds duplicate keys in one object of a glTF's JSON. JSON parsers accept them, and some use the
// first and some the last. Keys are compared after their escapes are decoded. Malformed JSON is not reported
// here but by the JSON parser. Errors: S114, with line and column of the second key; at most 16 are reported.
#pragma once

#include <string_view>

#include "scene/loading/gltf_report.h"

namespace weft::scene::gltf {

void check_keys(std::string_view json, Report& report);

}  // namespace weft::scene::gltf
