// Purpose: checks the images with live sizes, and the areas of the images that a pass uses. Private to
// follow_areas(). Errors: W236.
#pragma once

#include "graph/resolve/version.h"

namespace weft {

// Checks the declaration of an image with a live size. It cannot keep content from earlier frames, because
// their area can differ, and it cannot have cube faces.
void check_live_image(const ResourceDecl& image, const ResourceDesc& desc, Reporter& reporter);
// Checks that the attachments of a pass have the same area, and so do source and target of a copy. Checks
// that a blit reads only the area, and that the pass writes the whole area in the frame in which the area
// changes.
void check_pass_areas(const Declared& declared, const VersionedGraph& versioned, PassId pass,
                      const ResolvedGraph& graph, PassReporter& report);
// Returns the area of the first mip that a port uses. Its `image` is kNoId if the image has no live size.
[[nodiscard]] LiveArea area_of(const ResolvedGraph& graph, const UseDecl& use);

}  // namespace weft
