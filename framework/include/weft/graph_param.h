// Purpose: the parameters of a graph, and the work that a change of their values causes.
#pragma once

#include <cstdint>
#include <string>

namespace weft {

// The work that a change of a graph parameter causes. The list goes from the cheapest to the most expensive.
enum class ParamCost : uint8_t {
    nothing,   // No pass uses the parameter, so that nothing has to be done.
    live,      // The parameter is used in `Params`, `frames` or `cost`: the next frame uses the new value.
    pipeline,  // The parameter is a specialisation constant: pipelines are created again.
    graph,     // The parameter changes sizes, ranges or conditions: the graph is compiled again.
};

struct GraphParam {
    std::string name;
    double value = 0;
    ParamCost cost = ParamCost::nothing;
};

}  // namespace weft
