// Purpose: what a program asks of a graph: which file and tier, which parameters, which size, and which
// resources it reads back. The command line fills it once; load_graph() and resolve() read it. Units: pixels.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft {

struct GraphRequest {
    std::string path = {};                      // the graph file
    std::string tier = {};                      // empty: the graph as it is written
    std::map<std::string, double> params = {};  // values that replace the graph's defaults, by name
    Extent3D size{1280, 720, 1};                // of the output
    std::vector<std::string> observed =
        {};  // references ("name@pass.mip(e)") that are read back in every frame
    // A debug view of the graph, or any resource. It is drawn as "debugView", which can be observed.
    std::string debug = {};
};

}  // namespace weft
