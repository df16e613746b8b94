// Purpose: warns about shaders that sample an image with a live size as if the whole image had content.
// Warnings: W237.
#pragma once

#include "weft/declaration.h"
#include "weft/result.h"
#include "weft/shader_interface.h"

namespace weft {

// Warns about a shader that samples the image at texture coordinates, but reads none of these three: a member
// of `Params` that follows the area of this port, a value that follows a scale, the size of the image.
// `sources` are the files of the graph.
void warn_area_reads(const SourceMap& sources, const ResolvedGraph& graph, const ShaderCatalog& shaders,
                     Diagnostics& warnings);

}  // namespace weft
