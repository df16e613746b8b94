// Purpose: the settings with which every command loads graphs and shaders: the folders of the shipped files,
// the shader cache and the limits.
#pragma once

#include "weft/limits.h"
#include "weft/load/load_graph.h"

namespace weft::viewer {

[[nodiscard]] LoadSettings load_settings(const Limits& limits);

}  // namespace weft::viewer
