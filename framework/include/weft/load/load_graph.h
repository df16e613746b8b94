// Purpose: from a graph file to a resolved graph: read, merge, parse, compile its shaders, resolve.
// Everything wrong with the file and its shaders is reported in one go.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "weft/declaration.h"
#include "weft/graph_desc.h"
#include "weft/imports.h"
#include "weft/limits.h"
#include "weft/pass.h"
#include "weft/result.h"
#include "weft/shader/compile_shader.h"
#include "weft/source.h"
#include "weft/syntax/json_doc.h"

namespace weft {

// How many of an image's alternative formats are passed over, by the image's name; see ResolveInput.
using SkippedFormats = std::map<std::string, size_t>;

struct LoadInput {
    std::string path;
    FileReader reader;                   // for the graph file
    std::filesystem::path shader_root;   // the shaders/ folder; its include/ is the include root
    std::filesystem::path shader_cache;  // empty: none
    const PassCatalog& passes;
    const ImportCatalog& imports;
    const DeviceProfile& profile;
    Extent3D output_extent{1280, 720, 1};
    std::map<std::string, double> params;
    std::vector<std::string> observed;
    std::filesystem::path shader_worker = {};  // find_shader_worker(); empty: glslang runs in this process
    Limits limits = {};
    std::filesystem::path graph_root = {};  // the graphs/ folder, where included files are looked for as well
    std::string tier = {};                  // empty: the file as it is
    std::string debug = {};                 // a view to add, kDebugView, to be observed; empty: none
    ShaderMemory* memory = nullptr;         // what earlier loads left for this one
    // What common_formats() found, for loads without observers and parameters. Null: the other tiers are
    // loaded to see.
    const SkippedFormats* common_formats = nullptr;
};

struct LoadedGraph {
    GraphDesc desc;
    ShaderCatalog shaders;
    ResolvedGraph graph;
    SkippedFormats skipped_formats;  // so that all tiers have the same
};

// What is written: the graph's file and all that it includes. Its tiers are load_graph()'s choice.
[[nodiscard]] Result<JsonDoc> read_graph(const LoadInput& input);

// What is wrong with the file and with the tier, view and parameters that are asked for, before any shader is
// looked at: for those who have slow work to do before they load.
[[nodiscard]] Status check_request(const LoadInput& input);

// The formats that all tiers of a document share, found once for load_graph() of each. Every tier is loaded;
// the tier, parameters and observers of `input` mean nothing.
[[nodiscard]] SkippedFormats common_formats(const JsonDoc& document, const LoadInput& input);

// Warnings go to `warnings`.
[[nodiscard]] Result<LoadedGraph> load_graph(const JsonDoc& document, const LoadInput& input,
                                             Diagnostics& warnings);
// The same from the file.
[[nodiscard]] Result<LoadedGraph> load_graph(const LoadInput& input, Diagnostics& warnings);

// The same graph for another output size or other parameters. Shaders stay as they are.
[[nodiscard]] Result<ResolvedGraph> resolve_again(const LoadedGraph& loaded, const LoadInput& input,
                                                  Diagnostics& warnings);

}  // namespace weft
