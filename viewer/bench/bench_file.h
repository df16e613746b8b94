// Purpose: writes a generated graph as the text of a graph file, so that `weft bench compile` can measure the
// times of reading, merging, parsing and resolving this file.
#pragma once

#include <map>
#include <string>

#include "weft/device_profile.h"
#include "weft/limits.h"
#include "weft/plan.h"
#include "weft/shader_interface.h"

namespace weft::viewer {

// Returns the text of a graph file with the passes and images of `graph`, a result of make_bench_graph(). If
// this text is read and resolved, the result has the same passes, uses, images and edges as `graph`.
[[nodiscard]] std::string bench_file_text(const ResolvedGraph& graph);
// Returns the interfaces of the shaders that the graph file names. The catalog has no compiled code.
[[nodiscard]] ShaderCatalog bench_shaders();
// Returns the GLSL source of the shaders in bench_shaders(). The key is the file name, such as "read0.comp".
[[nodiscard]] std::map<std::string, std::string> bench_shader_texts();
// Describes a device that can do all that the passes need.
[[nodiscard]] DeviceProfile bench_profile();
// Returns limits that a generated file with a million passes does not exceed.
[[nodiscard]] GraphLimits bench_limits();

}  // namespace weft::viewer
