// Purpose: loads a graph file in two steps. parse_graph() reads the file with its includes, merges and parses
// it. load_graph() compiles the shaders and resolves the graph. Each step reports all faults that it finds
// together.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "weft/declaration.h"
#include "weft/file_reader.h"
#include "weft/graph_desc.h"
#include "weft/graph_request.h"
#include "weft/imports.h"
#include "weft/limits.h"
#include "weft/pass.h"
#include "weft/result.h"
#include "weft/shader/compile_shader.h"
#include "weft/syntax/json_doc.h"

namespace weft {

// Key: name of an image. Value: how many formats at the start of its list of alternatives are skipped, even
// if the device supports them. Example: with the value 1, "rg16_snorm|rg16f" becomes rg16f. So an image can
// have the same format in all tiers. See ResolveInput.
using SkippedFormats = std::map<std::string, size_t>;

// Key: name of a resource with `"keep": "shared"`. Value: the usages of the resource in all tiers.
using SharedUsages = std::map<std::string, UsageMask>;

// Settings for loading graphs: the folders of graphs and shaders, and the limits.
struct LoadSettings {
    // Function that reads the texts of graph files. Empty: they are read from disk.
    FileReader reader;
    // True: `reader` returns the contents of files on disk. Then a session looks only at the times and sizes
    // of the files to see that a graph has not changed.
    bool reads_disk = false;
    // The folder graphs/ that is shipped with Weft. Included files are searched there last.
    std::filesystem::path graph_root;
    // The folder shaders/ that is shipped with Weft. Its subfolder include/ is the root of includes in
    // shaders.
    std::filesystem::path shader_root;
    std::filesystem::path shader_cache;  // Folder for the cache of compiled shaders; empty: no cache.
    // Path of the program weft-shader-worker, from find_shader_worker(). Empty: glslang runs in this process.
    std::filesystem::path shader_worker;
    Limits limits;
    // Folders with graphs and their shaders. Included files are searched there after the folder of the
    // including file and before `graph_root`. The program trusts these folders like the folder of the graph.
    std::vector<std::filesystem::path> graph_path = {};
};

// A graph that was read with all its includes, merged for the tier of the request, and parsed.
struct ParsedGraph {
    JsonDoc document;
    GraphDesc desc;  // The parsed graph, without the debug view of the request.
    // Absolute paths of all graph files and files of resources that were searched, including files that do
    // not exist.
    std::set<std::filesystem::path> files;
};

struct LoadInput {
    GraphRequest request;
    const LoadSettings& settings;
    const PassCatalog& passes;
    const ImportCatalog& imports;
    const DeviceProfile& profile;
    // Results of earlier loads, so that unchanged shaders are not compiled again; null: none.
    ShaderMemory* memory = nullptr;
    // The result of common_formats(). Use it only if the request has no observed resources and no parameters,
    // because common_formats() ignores them. Null: load_graph() finds the formats itself, and loads all other
    // tiers for this.
    const SkippedFormats* common_formats = nullptr;
    // Receives the paths of the files that load_graph(document) searched for resources, even after an error;
    // null: not needed. parse_graph() lists them in ParsedGraph::files.
    std::set<std::filesystem::path>* searched = nullptr;
    // True: the caller loads all tiers and compares their warnings. False: if the graph has tiers, warnings
    // that something is unused are left out, because another tier may use it.
    bool compares_tiers = false;
};

// True for warnings that something is unused, such as a resource or a pass.
[[nodiscard]] bool says_unused(const Diagnostic& diagnostic);

struct LoadedGraph {
    GraphDesc desc;
    ShaderCatalog shaders;
    ResolvedGraph graph;
    // The formats that were skipped so that each image has the same format in all tiers.
    SkippedFormats skipped_formats;
    SharedUsages shared_usages;
};

// Reads a graph file and its includes. No tier is applied.
[[nodiscard]] Result<JsonDoc> read_graph(const std::string& path, const LoadSettings& settings);

// Reads, merges and parses the graph file of `request`. If `files` is not null, the function adds
// ParsedGraph::files to it, even after an error.
[[nodiscard]] Result<ParsedGraph> parse_graph(const GraphRequest& request, const LoadSettings& settings,
                                              std::set<std::filesystem::path>* files = nullptr);

// Checks the debug view and the parameters of the request. This is fast, because no shader is compiled: call
// it before slow work.
[[nodiscard]] Status check_request(const ParsedGraph& parsed, const GraphRequest& request,
                                   const ImportCatalog& imports);

// Returns the formats to skip so that each image has the same format in all tiers of the document. Call this
// function once, and pass the result to load_graph() for every tier. The function loads every tier. It
// ignores the tier, parameters, observed resources and debug view of the request.
[[nodiscard]] SkippedFormats common_formats(const JsonDoc& document, const LoadInput& input);

// Compiles the shaders of a parsed graph and resolves the graph. `parsed` must be the result of parse_graph()
// for `input.request`. Warnings are added to `warnings`.
[[nodiscard]] Result<LoadedGraph> load_graph(const ParsedGraph& parsed, const LoadInput& input,
                                             Diagnostics& warnings);
// Merges and parses a document for the tier of the request, compiles its shaders and resolves the graph.
[[nodiscard]] Result<LoadedGraph> load_graph(const JsonDoc& document, const LoadInput& input,
                                             Diagnostics& warnings);

// Resolves a loaded graph again, for another output size or other parameters. Shaders are not compiled again.
[[nodiscard]] Result<ResolvedGraph> resolve_again(const LoadedGraph& loaded, const LoadInput& input,
                                                  Diagnostics& warnings);

// Gives a loaded graph the parameter values of another request. `from` is the request of the loaded graph.
// Returns nullopt in two cases: the requests differ in something else than parameters of ParamCost::live, or
// a value has an error. In both cases, load the graph again.
[[nodiscard]] std::optional<ResolvedGraph> change_values(const LoadedGraph& loaded, const GraphRequest& from,
                                                         const LoadInput& input);

}  // namespace weft
