// Purpose: finds the rectangles of the attachments to which the views of a list are drawn. Private to attach().
#pragma once

#include "graph/resolve/evaluator.h"

namespace weft {

// Returns the rectangle of view `number` of a list in attachments of this extent: the one in the key "rect" of the
// list, or the one that the program gives, or a cell of a grid. The grid has the fewest columns with which it is at
// least as wide as high, and its cells are numbered from left to right and from top to bottom. After an error in an
// expression, which is reported, the result has no errors; else it has one without a place.
[[nodiscard]] Result<RectPx> view_rect(const ViewList& list, uint32_t number, const Extent3D& extent,
                                       const Evaluator& evaluator);

}  // namespace weft
