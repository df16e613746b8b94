// Purpose: what a scene offers to graphs, known without a device: the draw lists opaque, masked and
// transparent, the output image, the element type Light, and the view "camera".
#pragma once

#include "weft/imports.h"

namespace weft::render {

// The output is a UNORM image that the last pass encodes; after the frame it is copied, blitted or read back.
[[nodiscard]] ImportCatalog scene_imports(Extent3D output_extent);

}  // namespace weft::render
