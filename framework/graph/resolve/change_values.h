// Purpose: gives a resolved graph new parameter values, without resolving the graph again. This is possible
// for parameters that are only values in `Params` of shaders or in C++ passes.
#pragma once

#include <optional>

#include "graph/resolve/resolve.h"

namespace weft {

// Returns true if the requests differ only in values of parameters, and only in parameters whose change costs
// at most ParamCost::live. `params` are the parameters of the graph that was resolved for one of the
// requests.
[[nodiscard]] bool only_values_differ(const GraphRequest& a, const GraphRequest& b,
                                      const std::vector<GraphParam>& params);

// Returns the graph that resolve(input) would return. `known` must be the result of resolve() for an input
// that differs from `input` only in its request. For the two requests, only_values_differ() must be true.
// Returns nullopt if a value has an error; then call resolve(), which reports it.
[[nodiscard]] std::optional<ResolvedGraph> change_values(const ResolveInput& input,
                                                         const ResolvedGraph& known);

}  // namespace weft
