#include "render/graph_loader.h"

namespace weft::render {

Result<LoadedGraph> GraphLoader::load(const GraphRequest& request, const ParsedGraph* parsed,
                                      Diagnostics& warnings, std::set<std::filesystem::path>& files) {
    std::optional<ParsedGraph> own;
    if (parsed == nullptr) {
        Result<ParsedGraph> made = parse_graph(request, settings_, &files);
        if (!made) return made.take_errors();
        parsed = &own.emplace(std::move(*made));
    }
    files.insert(parsed->files.begin(), parsed->files.end());
    memory_.begin();
    const ImportCatalog imports = imports_at(request.size);
    Result<LoadedGraph> loaded = load_graph(*parsed,
                                            {.request = request,
                                             .settings = settings_,
                                             .passes = passes_,
                                             .imports = imports,
                                             .profile = profile_,
                                             .memory = &memory_},
                                            warnings);
    files.insert(memory_.files().begin(), memory_.files().end());
    if (loaded) memory_.forget_unused();
    return loaded;
}

Result<ResolvedGraph> GraphLoader::resolve_again(const LoadedGraph& loaded, const GraphRequest& request,
                                                 Diagnostics& warnings) const {
    const ImportCatalog imports = imports_at(request.size);
    return weft::resolve_again(loaded,
                               {.request = request,
                                .settings = settings_,
                                .passes = passes_,
                                .imports = imports,
                                .profile = profile_},
                               warnings);
}

ImportCatalog GraphLoader::imports_at(Extent3D size) const {
    ImportCatalog imports = imports_;
    imports.imports.at("backbuffer").resource.extent = size;
    return imports;
}

}  // namespace weft::render
