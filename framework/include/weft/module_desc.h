// Purpose: an instance of a module, which is a graph file that another graph includes with a name.
#pragma once

#include <map>
#include <string>

namespace weft {

// The passes, resources and other parts of an instance are in the maps of GraphDesc, with names such as
// "glass::cull".
struct ModuleDesc {
    std::string parent;  // Name of the module that includes this one; empty: the graph.
    // For each port that "with" replaces by a parameter, constant or size of the graph: its full name.
    std::map<std::string, std::string> values;
};

}  // namespace weft
