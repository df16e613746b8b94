// Purpose: finds keys that stand twice in one object of a glTF's JSON, which the parser behind would pass
// over: the last one counts there, the first one elsewhere. Keys are compared as they are meant, whatever way
// they are escaped. Malformed JSON is left to the parser. Errors: S114, with line and column of the second
// key; the first 16 are named.
#pragma once

#include <string_view>

#include "scene/loading/gltf_report.h"

namespace weft::scene::gltf {

void check_keys(std::string_view json, Report& report);

}  // namespace weft::scene::gltf
