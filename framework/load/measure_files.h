// Purpose: finds the files of a graph's resources and reads their sizes. Only the header of a picture is
// read. Errors: W145 a file does not exist, cannot be read, has a damaged header, or is too large.
#pragma once

#include <filesystem>
#include <set>

#include "weft/graph_desc.h"
#include "weft/load/load_graph.h"

namespace weft {

// Sets the members of FileDesc in all resources with a file. Adds all searched paths to `searched`, if it is
// not null.
void measure_files(GraphDesc& graph, const LoadSettings& settings, std::set<std::filesystem::path>* searched,
                   Diagnostics& faults);

}  // namespace weft
