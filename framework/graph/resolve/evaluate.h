// Purpose: the first stage of resolve(). Finds the values of parameters, constants and sizes, which all later
// expressions can name. Also finds the lists of views.
// Errors: W106, W107, W109, W118, W120, W191, W230, W236.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "graph/parse/expression.h"
#include "graph/resolve/reporter.h"
#include "graph/resolve/resolve.h"

namespace weft {

// A list of views that passes may use. View i of the list is view `first` + i of `base`. `base` is the name
// of a single view, or of a list of views in the plan. If a list in the section "views" has no mirror, cube
// or buffer, it is only a part of another list, and both lists have the same `base`.
struct ViewList {
    std::string base;
    uint32_t first = 0;
    uint32_t count = 0;
    bool single = false;  // True for a view without a number, such as "camera".
    ViewListDecl decl;    // The declaration of the list `base`; unused for a single view.
    // The sources of the rectangles of the views: the list in the section "views" of the graph, and the list
    // of the program. Null if the list does not come from there.
    const ViewListDesc* desc = nullptr;
    const ImportDecl* import = nullptr;
};

struct Values {
    // The values by name. Live sizes and their scales have the values for scale 1, because the plan is made
    // for scale 1.
    std::map<std::string, ExprValue> by_name;
    // Names without a value, because an error in their definition was reported.
    std::set<std::string, std::less<>> faulty;
    // The parameters of the graph, sorted by name. weigh_params() fills in their costs later.
    std::vector<GraphParam> params;
    std::set<std::string> scales;  // The parameters that are scales of live sizes.
    uint32_t frames = 1;
    std::map<std::string, ViewList, std::less<>> views;  // All lists of views, by name.
};
[[nodiscard]] Values evaluate(const ResolveInput& input, Reporter& reporter);

}  // namespace weft
