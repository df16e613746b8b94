// Purpose: for the debug view of a depth image, finds the view from which a pass draws the depth image. The
// debug view computes distances in metres from the depth values and the projection of this view.
#pragma once

#include "weft/graph_desc.h"

namespace weft {

// `pass` is the pass of a debug view that shows `shown`. Sets the view of `pass` to the view that raster
// passes draw to `shown`. If raster passes draw all views of a list to layers, sets the view whose number is
// the number of the shown layer. If they draw all views of a list to rectangles, sets the first view. `pass`
// keeps the camera if no raster pass draws to `shown`, or if the raster passes draw different views to
// `shown`.
void set_drawn_view(const GraphDesc& graph, const RefDesc& shown, PassDesc& pass);

}  // namespace weft
