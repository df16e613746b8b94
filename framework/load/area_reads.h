// Purpose: warns about shaders that sample an image with a live size as if the whole image had content. In
// each frame, only an area of such an image has content. Warnings: W237.
#pragma once

#include "weft/declaration.h"
#include "weft/result.h"
#include "weft/shader_interface.h"

namespace weft {

// Warns about a shader that samples the image at texture coordinates, but reads none of these three: a member
// of `Params` that depends on the area of this port (the part of the image that has content), a value that
// depends on the scale of a live size, the size of the image. `sources` are the files of the graph.
void warn_area_reads(const SourceMap& sources, const ResolvedGraph& graph, const ShaderCatalog& shaders,
                     Diagnostics& warnings);

}  // namespace weft
