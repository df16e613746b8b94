// Purpose: the settings with which every command loads graphs and shaders: the folders of the shipped files,
// the shader cache, the limits and the folders of --graph-path.
#pragma once

#include <string>
#include <vector>

#include "weft/limits.h"
#include "weft/load/load_graph.h"

namespace weft::viewer {

[[nodiscard]] LoadSettings load_settings(const Limits& limits, const std::vector<std::string>& graph_path);

}  // namespace weft::viewer
