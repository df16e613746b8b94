// Purpose: a program's request for a graph: the file and tier, parameters, size, and the resources that are
// read back. The command line fills it once; load_graph() and resolve() read it. Units: pixels.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft {

struct GraphRequest {
    std::string path = {};                      // the graph file
    std::string tier = {};                      // empty: the graph without a tier
    std::map<std::string, double> params = {};  // values that replace the graph's defaults, by name
    Extent3D size{1280, 720, 1};                // of the output
    std::vector<std::string> observed =
        {};  // references ("name@pass.mip(e)") that are read back in every frame
    // A debug view of the graph, or any resource. It is rendered to "debugView", which can be observed.
    std::string debug = {};
};

}  // namespace weft
