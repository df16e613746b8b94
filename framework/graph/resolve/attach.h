// Purpose: the stage of resolve() that makes attachments of the uses of raster and fullscreen passes, and
// finds the one extent that the attachments of a pass share. Errors: W119, W169, W174, W179 to W182.
#pragma once

#include <optional>
#include <vector>

#include "graph/resolve/version.h"

namespace weft {

struct PassAttachments {
    std::vector<AttachmentDecl> colors;  // by location
    std::optional<AttachmentDecl> depth;
    Extent3D render_extent;
};
struct Attachments {
    std::vector<PassAttachments> passes;  // by PassId
    Suspects suspects;
};
[[nodiscard]] Attachments attach(const Declared& declared, const VersionedGraph& graph, Reporter& reporter);

}  // namespace weft
