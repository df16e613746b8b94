// Purpose: compares the imports of a graph with those that the program provides. Private to
// shape_resources().
#pragma once

#include "graph/resolve/shape_resources.h"

namespace weft {

// Fills in the resource of an import from the program's import catalogue. Errors: W118.
void shape_import(const ResolveInput& input, const ImportDesc& desc, ResourceId id, Shapes& shapes,
                  Reporter& reporter);
// Checks that the program offers the imported draw lists and lists of views. Errors: W118.
void check_list_imports(const ResolveInput& input, Reporter& reporter);
[[nodiscard]] bool is_draw_list(const ImportDesc& import);
[[nodiscard]] bool is_view_list(const ImportDesc& import);
// Returns true for an import of kind "turns": the rounds that a group runs in a frame. The program gives them
// with each frame, so its import catalogue does not contain them.
[[nodiscard]] bool is_turns(const ImportDesc& import);

}  // namespace weft
