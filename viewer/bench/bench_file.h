// Purpose: writes a generated graph as the text of a graph file, so that `weft bench compile` can measure how
// long such a file takes to read, to merge, to parse and to resolve.
#pragma once

#include <string>

#include "weft/device_profile.h"
#include "weft/plan.h"
#include "weft/shader_interface.h"

namespace weft::viewer {

// Returns the text of a graph file with the passes and images of `graph`, a result of make_bench_graph(). When
// it is read and resolved, the result has the same passes, uses, images and edges.
[[nodiscard]] std::string bench_file_text(const ResolvedGraph& graph);
// The interfaces of the shaders that the text names. They have no code.
[[nodiscard]] ShaderCatalog bench_shaders();
// Describes a device that can do all that the passes need.
[[nodiscard]] DeviceProfile bench_profile();

}  // namespace weft::viewer
