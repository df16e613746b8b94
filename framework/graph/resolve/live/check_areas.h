// Purpose: checks the images with live sizes, and the areas of the images that a pass uses. Private to
// follow_areas(). Errors: W236.
#pragma once

#include "graph/resolve/version.h"

namespace weft {

// Checks the declaration of an image with a live size. The content of the image must not come from a file,
// from another tier or (with "history" and "keep") from the last frame, because the area of that content can
// differ. The image cannot have cube faces.
void check_live_image(const ResourceDecl& image, const ResourceDesc& desc, Reporter& reporter);
// Checks that all attachments of a pass have the same area, and that source and target of a copy have the
// same area. Checks that a blit reads no texels outside of the area. Checks that a change of the area leaves
// no content that was written for another area.
void check_pass_areas(const Declared& declared, const VersionedGraph& versioned, PassId pass,
                      const ResolvedGraph& graph, PassReporter& report);
// Returns the area of the first mip that a port uses. In the result, `image` is kNoId if the image has no
// live size.
[[nodiscard]] LiveArea area_of(const ResolvedGraph& graph, const UseDecl& use);

}  // namespace weft
