// Purpose: loads a graph file: read, merge, parse, compile its shaders, resolve. All faults of the file and
// its shaders are reported together.
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

// For each image, the number of its alternative formats that are skipped; see ResolveInput.
using SkippedFormats = std::map<std::string, size_t>;

struct LoadInput {
    std::string path;
    FileReader reader;                   // reads the graph file
    std::filesystem::path shader_root;   // the shaders/ folder; its include/ is the include root
    std::filesystem::path shader_cache;  // empty: no cache
    const PassCatalog& passes;
    const ImportCatalog& imports;
    const DeviceProfile& profile;
    Extent3D output_extent{1280, 720, 1};
    std::map<std::string, double> params;
    std::vector<std::string> observed;
    std::filesystem::path shader_worker = {};  // find_shader_worker(); empty: glslang runs in this process
    Limits limits = {};
    std::filesystem::path graph_root = {};  // the graphs/ folder, where included files are also searched
    std::string tier = {};                  // empty: the graph without a tier
    std::string debug = {};                 // a debug view to add as kDebugView and observe; empty: none
    ShaderMemory* memory = nullptr;         // data kept from earlier loads
    // The result of common_formats(), for loads without observers and parameters. Null: the other tiers are
    // loaded to compute it.
    const SkippedFormats* common_formats = nullptr;
};

struct LoadedGraph {
    GraphDesc desc;
    ShaderCatalog shaders;
    ResolvedGraph graph;
    SkippedFormats skipped_formats;  // makes formats equal in all tiers
};

// Reads the graph's file and all files that it includes. load_graph() applies the tier.
[[nodiscard]] Result<JsonDoc> read_graph(const LoadInput& input);

// Checks the file, and the requested tier, view and parameters, before any shader is compiled. For callers
// that do slow work before load_graph().
[[nodiscard]] Status check_request(const LoadInput& input);

// The formats common to all tiers of a document, computed once for load_graph() of each tier. Loads every
// tier; ignores the tier, parameters and observers of `input`.
[[nodiscard]] SkippedFormats common_formats(const JsonDoc& document, const LoadInput& input);

// Warnings are added to `warnings`.
[[nodiscard]] Result<LoadedGraph> load_graph(const JsonDoc& document, const LoadInput& input,
                                             Diagnostics& warnings);
// Reads the file and loads the graph.
[[nodiscard]] Result<LoadedGraph> load_graph(const LoadInput& input, Diagnostics& warnings);

// Resolves the same graph for another output size or other parameters, without compiling shaders.
[[nodiscard]] Result<ResolvedGraph> resolve_again(const LoadedGraph& loaded, const LoadInput& input,
                                                  Diagnostics& warnings);

}  // namespace weft
