// Purpose: finds the shaders that lie beside an included file. A shader is searched first in the folder of
// the file that names it, then in the folder of the graph and among the shipped shaders.
#pragma once

#include "weft/graph_desc.h"
#include "weft/load/load_graph.h"

namespace weft {

// Sets PassDesc::shader_folder for each shader that an included file in another folder names. If the shader
// exists there, its name gets the folder as a prefix, so that shaders of the same name in different folders
// differ: "fogbank/fog.comp". The prefix is relative to the folder of the graph or to a folder of the graph
// path, so it does not depend on where these folders are. A second call does not change passes again.
void place_shaders(GraphDesc& graph, const LoadSettings& settings);

}  // namespace weft
