// Purpose: the shipped graphs and shaders, as every command loads them.
#pragma once

#include "weft/limits.h"
#include "weft/load/load_graph.h"

namespace weft::viewer {

[[nodiscard]] LoadSettings load_settings(const Limits& limits);

}  // namespace weft::viewer
