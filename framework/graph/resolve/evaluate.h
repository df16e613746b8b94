// Purpose: the first stage of resolve(). Makes parameters, constants and sizes available as names for all
// later expressions. Errors: W106, W107, W109, W120.
#pragma once

#include <functional>
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
    std::set<std::string, std::less<>> faulty;  // names whose faults are reported
    std::vector<GraphParam> params;             // sorted by name; their costs come later
    uint32_t frames = 1;
};
[[nodiscard]] Values evaluate(const ResolveInput& input, Reporter& reporter);

}  // namespace weft
