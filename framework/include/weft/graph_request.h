// Purpose: describes which graph a program wants: the file and tier, parameters, output size, the resources
// to read back, and the resources that the program itself uses between frames. The command line fills a
// GraphRequest once; load_graph() and resolve() read it. Units: pixels.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "weft/declaration.h"
#include "weft/output_format.h"

namespace weft {

// The size of an import. An image uses `extent`, a buffer `size_bytes`.
struct ImportSize {
    Extent3D extent;
    uint64_t size_bytes = 0;
    bool operator==(const ImportSize&) const = default;
};

// The way in which a program uses a resource of the graph between two frames.
struct ExportUse {
    Access access = Access::sampled_read;
    // The shader stages that access the resource; accesses without shaders ignore them.
    ShaderStageMask stages = stage_bit(ShaderStage::fragment) | stage_bit(ShaderStage::compute);
    bool operator==(const ExportUse&) const = default;
};

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
    // Sizes of imports by name. They replace the sizes in the catalogue of imports.
    std::map<std::string, ImportSize> import_sizes = {};
    // Resources of the graph that the program uses after each frame, by name. The passes that write them are
    // never removed, the resources get memory of their own, and at the end of the frame they are in the state
    // that the access needs. At the start of the next frame, a resource with "keep" or "history" still has
    // its content, and the program may only read it; the content of all others is discarded. Error: W243.
    std::map<std::string, ExportUse> exports = {};
    bool rests = true;  // False: passes with "rest" run in every frame.
    bool operator==(const GraphRequest&) const = default;
};

}  // namespace weft
