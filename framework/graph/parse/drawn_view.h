// Purpose: for the debug view of a depth image, finds the view that a pass drew it from. The distances in
// metres follow from the depth values and the projection of this view.
#pragma once

#include "weft/graph_desc.h"

namespace weft {

// Sets the view of `pass`, the pass of a debug view that shows `shown`, to the view that raster passes draw
// to `shown`. If they draw all views of a list to layers, this is the view with the number of the layer that
// is shown; if they draw them to rectangles, it is the first view. `pass` keeps the camera if no raster pass
// draws to `shown`, or if the raster passes draw different views to it.
void set_drawn_view(const GraphDesc& graph, const RefDesc& shown, PassDesc& pass);

}  // namespace weft
