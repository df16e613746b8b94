// Purpose: the stage of resolve() that lists the attachments of each raster and fullscreen pass, with their
// clear values and blending, and finds the extent that all attachments of a pass must share. Finds the
// rectangles of views. Errors: W119, W169, W174, W179 to W182, W192.
#pragma once

#include <optional>
#include <vector>

#include "graph/resolve/version.h"

namespace weft {

struct PassAttachments {
    // Colour attachments, sorted by their location in the fragment shader.
    std::vector<AttachmentDecl> colors;
    std::optional<AttachmentDecl> depth;
    Extent3D render_extent;
    // The rectangle of the pass's view, for a pass with "into": "rects".
    std::optional<RectPx> rect;
};
struct Attachments {
    // The attachments of each pass, indexed by PassId.
    std::vector<PassAttachments> passes;
    Suspects suspects;
};
[[nodiscard]] Attachments attach(const Declared& declared, const VersionedGraph& graph, Reporter& reporter);

}  // namespace weft
