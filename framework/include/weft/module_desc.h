// Purpose: an instance of a module, which is a graph file that another graph includes with a name.
#pragma once

#include <map>
#include <string>

namespace weft {

// The passes, resources and other parts of an instance are in the maps of GraphDesc, with names such as
// "glass::cull".
struct ModuleDesc {
    std::string parent;  // Name of the module that includes this one; empty: the graph includes it.
    // The ports that "with" replaces by a parameter, constant or size of the graph. Key: name of the port.
    // Value: full name of the parameter, constant or size.
    std::map<std::string, std::string> values;
};

}  // namespace weft
