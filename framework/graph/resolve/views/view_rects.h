// Purpose: finds the rectangles of the attachments to which the views of a list are drawn. Private to
// attach().
#pragma once

#include "graph/resolve/evaluator.h"

namespace weft {

// Returns the rectangle of view `number` of a list in attachments of this extent: the rectangle in the key
// "rect" of the list, or the rectangle that the program gives, or a cell of a grid. The grid has as few
// columns as possible, but not fewer columns than rows. Its cells are numbered from left to right and from
// top to bottom.
// If an expression has an error, this error is reported, and the result contains an empty list of errors. If
// the rectangle does not fit the attachments, the result contains one error without a place.
[[nodiscard]] Result<RectPx> view_rect(const ViewList& list, uint32_t number, const Extent3D& extent,
                                       const Evaluator& evaluator);

}  // namespace weft
