// Purpose: finds the lists of views that passes may use: those that the program offers, and those in the
// section "views" of the graph. Part of evaluate(), because expressions can name the numbers of views.
#pragma once

#include <map>
#include <string>

#include "graph/resolve/evaluator.h"

namespace weft {

// Returns the expressions for the numbers of views of the lists in the section "views", by name:
// "mirrorViews" for the list "mirror". Adds the numbers of views of the program's lists to `values`. Errors:
// W109, W118, W191, W230.
[[nodiscard]] std::map<std::string, Expr> count_views(const ResolveInput& input, Values& values,
                                                      Reporter& reporter);
// Returns all lists of views, by name. Call this function when all names have their values. Errors: W109.
[[nodiscard]] std::map<std::string, ViewList, std::less<>> list_views(const ResolveInput& input,
                                                                      Values& values, Reporter& reporter);
// Returns the list that a pass names in "view" or "views". Returns null after reporting an error, now or
// earlier. Errors: W118.
[[nodiscard]] const ViewList* find_view_list(const ResolveInput& input, const Values& values,
                                             const PassDesc& pass, Reporter& reporter);
// Returns the name of a view of a list: "sun(1)", or "camera".
[[nodiscard]] std::string view_name(const ViewList& list, uint32_t number);
// For a list of the program, or a part of such a list, whose number of views is only assumed: adds a help
// text about this to the last error. Adds nothing if there are at most `errors` errors. The caller has
// counted the errors earlier, so only a newer error gets the text.
void help_with_count(const ViewList& list, size_t errors, Reporter& reporter);
// Returns the buffer from which passes read the views of the list, as an input of these passes; null if the
// views do not come from a buffer.
[[nodiscard]] const PortDesc* find_view_buffer(const ResolveInput& input, const ViewList& list);
// Returns the lists that the passes of the graph use, sorted by name. For a mirror, also includes the list
// that the mirror shows.
[[nodiscard]] std::vector<ViewListDecl> used_view_lists(const Values& values,
                                                        const std::vector<PassDecl>& passes);

}  // namespace weft
