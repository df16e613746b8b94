// Purpose: the first stage of resolve(). Finds the values of parameters, constants and sizes, which all later
// expressions can name. Errors: W106, W107, W109, W120.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "graph/parse/expression.h"
#include "graph/resolve/reporter.h"
#include "graph/resolve/resolve.h"

namespace weft {

struct Values {
    std::map<std::string, ExprValue> by_name;
    // Names without a value, because an error in their definition was reported.
    std::set<std::string, std::less<>> faulty;
    // The parameters of the graph, sorted by name. weigh_params() fills in their costs later.
    std::vector<GraphParam> params;
    uint32_t frames = 1;
};
[[nodiscard]] Values evaluate(const ResolveInput& input, Reporter& reporter);

}  // namespace weft
