// Purpose: loads graphs repeatedly for one device and scene. Shaders that did not change since the last load
// are not compiled again. load() may run on only one thread at a time; the other functions may run on any
// thread.
#pragma once

#include <filesystem>
#include <set>

#include "shader/shader_memory.h"
#include "weft/load/load_graph.h"

namespace weft::render {

class GraphLoader {
 public:
    // `profile` must outlive the loader. `imports` are the imports of the scene. Their output size does not
    // matter, because imports_at() replaces it.
    GraphLoader(const DeviceProfile& profile, LoadSettings settings, PassCatalog passes,
                ImportCatalog imports)
        : profile_(profile),
          settings_(std::move(settings)),
          passes_(std::move(passes)),
          imports_(std::move(imports)) {}

    // Loads the graph of `request`. Parses the graph file, unless `parsed` contains the result already. Adds
    // to `files` the files that were searched.
    [[nodiscard]] Result<LoadedGraph> load(const GraphRequest& request, const ParsedGraph* parsed,
                                           Diagnostics& warnings, std::set<std::filesystem::path>& files);
    [[nodiscard]] Result<ResolvedGraph> resolve_again(const LoadedGraph& loaded, const GraphRequest& request,
                                                      Diagnostics& warnings) const;

    [[nodiscard]] const LoadSettings& settings() const { return settings_; }
    [[nodiscard]] const PassCatalog& passes() const { return passes_; }
    // Returns the scene's imports with an output of this size.
    [[nodiscard]] ImportCatalog imports_at(Extent3D size) const;

 private:
    const DeviceProfile& profile_;
    const LoadSettings settings_;
    const PassCatalog passes_;
    const ImportCatalog imports_;
    ShaderMemory memory_;
};

}  // namespace weft::render
