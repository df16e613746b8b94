// Purpose: loads a graph file in two steps: parse_graph() reads, merges and parses the file, load_graph()
// compiles its shaders and resolves it. All faults of the file and its shaders are reported at once.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "weft/declaration.h"
#include "weft/graph_desc.h"
#include "weft/graph_request.h"
#include "weft/imports.h"
#include "weft/limits.h"
#include "weft/pass.h"
#include "weft/result.h"
#include "weft/shader/compile_shader.h"
#include "weft/source.h"
#include "weft/syntax/json_doc.h"

namespace weft {

// How many of an image's alternative formats are skipped, by the image's name; see ResolveInput.
using SkippedFormats = std::map<std::string, size_t>;

// The folders of graphs and shaders, and their limits.
struct LoadSettings {
    FileReader reader;                    // for graph files
    std::filesystem::path graph_root;     // the graphs/ folder, in which included files are searched too
    std::filesystem::path shader_root;    // the shaders/ folder; its include/ is the include root
    std::filesystem::path shader_cache;   // empty: none
    std::filesystem::path shader_worker;  // find_shader_worker(); empty: glslang runs in this process
    Limits limits;
};

// The graph file of a request: read with all its includes, merged for its tier, and parsed.
struct ParsedGraph {
    JsonDoc document;
    GraphDesc desc;                         // without the debug view of the request
    std::set<std::filesystem::path> files;  // the graph files that were searched, absolute, existing or not
};

struct LoadInput {
    GraphRequest request;
    const LoadSettings& settings;
    const PassCatalog& passes;
    const ImportCatalog& imports;
    const DeviceProfile& profile;
    ShaderMemory* memory = nullptr;  // results of earlier loads
    // The result of common_formats(), for loads without observers and parameters. Null: load_graph() loads
    // the other tiers to find the formats.
    const SkippedFormats* common_formats = nullptr;
};

struct LoadedGraph {
    GraphDesc desc;
    ShaderCatalog shaders;
    ResolvedGraph graph;
    SkippedFormats skipped_formats;  // makes formats equal in all tiers
};

// The graph file and its includes, before a tier is chosen.
[[nodiscard]] Result<JsonDoc> read_graph(const std::string& path, const LoadSettings& settings);

// `files`, if not null, receives ParsedGraph::files, also after an error.
[[nodiscard]] Result<ParsedGraph> parse_graph(const GraphRequest& request, const LoadSettings& settings,
                                              std::set<std::filesystem::path>* files = nullptr);

// Checks the request's debug view and parameters without compiling shaders: call this before slow work.
[[nodiscard]] Status check_request(const ParsedGraph& parsed, const GraphRequest& request,
                                   const ImportCatalog& imports);

// The formats that all tiers of a document share, found once for load_graph() of each. Loads every tier; the
// tier, parameters and observers of the request are ignored.
[[nodiscard]] SkippedFormats common_formats(const JsonDoc& document, const LoadInput& input);

// Warnings are added to `warnings`. `parsed` must be the result for `input.request`.
[[nodiscard]] Result<LoadedGraph> load_graph(const ParsedGraph& parsed, const LoadInput& input,
                                             Diagnostics& warnings);
// The same from a document, merged and parsed for the tier of the request.
[[nodiscard]] Result<LoadedGraph> load_graph(const JsonDoc& document, const LoadInput& input,
                                             Diagnostics& warnings);

// The same graph for another output size or other parameters. Shaders are not compiled again.
[[nodiscard]] Result<ResolvedGraph> resolve_again(const LoadedGraph& loaded, const LoadInput& input,
                                                  Diagnostics& warnings);

}  // namespace weft
