// Purpose: loads graphs repeatedly for one device and scene, and does only the work that a change needs.
// Shaders that did not change since the last load are not compiled again. If no file changed, the graph files
// are not read again, but the graph is resolved again if the request changed (for example its size). If only
// values of parameters changed, only these values are computed again. load() may run on only one thread at a
// time, and work() must not be called meanwhile. The other functions may run on any thread.
#pragma once

#include <filesystem>
#include <optional>
#include <set>

#include "load/file_stamps.h"
#include "shader/shader_memory.h"
#include "weft/load/load_graph.h"

namespace weft::render {

// The result of a load.
struct LoadedVersion {
    uint64_t number = 0;  // Number of the load. Different results have different numbers.
    // The loaded graph; absent if the caller has it already.
    std::optional<LoadedGraph> graph;
    // The graph that the caller has, with other values of parameters; absent if the values are the same, or
    // if `graph` has them.
    std::optional<ResolvedGraph> values;
};

// Counts the work that load() has done so far.
struct LoadWork {
    uint64_t loads = 0;  // Number of calls of load().
    uint64_t read = 0;   // Number of times that the graph files were read.
    // Number of times that the graph was resolved, with its shaders compiled or reused.
    uint64_t resolved = 0;
    uint64_t changed_values = 0;  // Number of times that only values of parameters were changed.
};

class GraphLoader {
 public:
    // `profile` must outlive the loader. `imports` are the imports of the scene. The size and the format
    // of their output do not matter, because imports_at() replaces them.
    GraphLoader(const DeviceProfile& profile, LoadSettings settings, PassCatalog passes,
                ImportCatalog imports)
        : profile_(profile),
          settings_(std::move(settings)),
          passes_(std::move(passes)),
          imports_(std::move(imports)) {}

    // Loads the graph of `request`. `parsed` is the parsed graph file; if it is null, load() reads the file
    // if necessary. Adds to `files` the files that were searched. `known` is the number of the load whose
    // result the caller has, or 0. If that was the last successful load, and the files and the request are
    // still the same, the result has the same number and no graph. If only the request's values of parameters
    // differ, the result has `values` and no graph.
    [[nodiscard]] Result<LoadedVersion> load(const GraphRequest& request, const ParsedGraph* parsed,
                                             uint64_t known, Diagnostics& warnings,
                                             std::set<std::filesystem::path>& files);
    [[nodiscard]] Result<ResolvedGraph> resolve_again(const LoadedGraph& loaded, const GraphRequest& request,
                                                      Diagnostics& warnings) const;

    // Returns the loaded graph with the parameter values of `to`. `from` and `to` may differ only in values
    // of parameters whose change costs at most ParamCost::live. Returns nullopt if a value has an error.
    [[nodiscard]] std::optional<ResolvedGraph> with_values(const LoadedGraph& loaded,
                                                           const GraphRequest& from,
                                                           const GraphRequest& to) const;

    [[nodiscard]] const LoadSettings& settings() const { return settings_; }
    [[nodiscard]] const DeviceProfile& profile() const { return profile_; }
    [[nodiscard]] const PassCatalog& passes() const { return passes_; }
    // Returns the scene's imports with the output of this request.
    [[nodiscard]] ImportCatalog imports_at(const GraphRequest& request) const;
    [[nodiscard]] const LoadWork& work() const { return work_; }

 private:
    // The last successful load whose document load() has read itself. A document that the caller has parsed
    // (`parsed`) is not stored.
    struct Last {
        FileStamps stamps;
        GraphRequest request;
        JsonDoc document;
        std::set<std::filesystem::path> graph_files;  // The files of the document, without shaders.
        std::set<std::filesystem::path> files;
        Diagnostics warnings;
        uint64_t number = 0;
        // A copy of the result; absent if every parameter of the graph has a higher cost than
        // ParamCost::live.
        std::optional<LoadedGraph> loaded;
    };

    // Returns true if `last_` has the document of `request`, and the files of the document have certainly not
    // changed since they were read.
    [[nodiscard]] bool has_document(const GraphRequest& request) const;
    [[nodiscard]] Result<LoadedGraph> resolve(const GraphRequest& request, const ParsedGraph* parsed,
                                              Diagnostics& warnings);
    // Stores a successful load of the document in `last_`.
    void remember(const GraphRequest& request, Diagnostics warnings, const LoadedGraph& loaded);
    // Gives the graph of the last load the parameter values of `request`. Returns nullopt if the request has
    // not changed or if the graph must be resolved again.
    [[nodiscard]] std::optional<ResolvedGraph> change_values(const GraphRequest& request);

    const DeviceProfile& profile_;
    const LoadSettings settings_;
    const PassCatalog passes_;
    const ImportCatalog imports_;
    ShaderMemory memory_;
    // The files of resources that the last call of resolve() searched.
    std::set<std::filesystem::path> searched_;
    std::optional<Last> last_;
    LoadWork work_;
};

}  // namespace weft::render
