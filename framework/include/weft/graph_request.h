// Purpose: describes which graph a program wants: the file and tier, parameters, output size, and the
// resources to read back. The command line fills a GraphRequest once; load_graph() and resolve() read it.
// Units: pixels.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "weft/declaration.h"
#include "weft/output_format.h"

namespace weft {

struct GraphRequest {
    std::string path = {};  // Path of the graph file.
    std::string tier = {};  // Name of the quality tier; empty: the graph without a tier.
    // Parameter values by name. They replace the defaults in the graph.
    std::map<std::string, double> params = {};
    Extent3D size{1280, 720, 1};  // Size of the output image.
    OutputFormat output = {};     // Format of the output image, and its layout after the frame.
    // References such as "name@pass.mip(e)". These resources are read back in every frame.
    std::vector<std::string> observed = {};
    // Name of a debug view of the graph, or a reference to any resource; empty: none. The view is rendered to
    // the resource "debugView", which `observed` may contain.
    std::string debug = {};
    bool rests = true;  // False: passes with "rest" run in every frame.
    bool operator==(const GraphRequest&) const = default;
};

}  // namespace weft
