#include "render/graph_loader.h"

#include <algorithm>
#include <utility>

#include "load/text_reader.h"
#include "render/imports/output_import.h"

namespace weft::render {

bool GraphLoader::has_document(const GraphRequest& request) const {
    return reads_disk(settings_) && last_ && last_->request.path == request.path && last_->stamps.hold();
}

// Compiles the shaders of the graph and resolves it. If `parsed` is null, the function merges and parses the
// document of the last load for the tier of the request.
Result<LoadedGraph> GraphLoader::resolve(const GraphRequest& request, const ParsedGraph* parsed,
                                         Diagnostics& warnings) {
    ++work_.resolved;
    memory_.begin();
    searched_.clear();
    const ImportCatalog imports = imports_at(request);
    const LoadInput input{.request = request,
                          .settings = settings_,
                          .passes = passes_,
                          .imports = imports,
                          .profile = profile_,
                          .memory = &memory_,
                          .searched = &searched_};
    Result<LoadedGraph> loaded = parsed != nullptr ? load_graph(*parsed, input, warnings)
                                                   : load_graph(last_->document, input, warnings);
    if (loaded) memory_.forget_unused();
    return loaded;
}

Result<LoadedVersion> GraphLoader::load(const GraphRequest& request, const ParsedGraph* parsed,
                                        uint64_t known, Diagnostics& warnings,
                                        std::set<std::filesystem::path>& files) {
    ++work_.loads;
    const bool same_files = parsed == nullptr && has_document(request);
    if (same_files && last_->number == known) {
        std::optional<ResolvedGraph> values = change_values(request);
        if (values || last_->request == request) {
            files.insert(last_->files.begin(), last_->files.end());
            warnings.insert(warnings.end(), last_->warnings.begin(), last_->warnings.end());
            return LoadedVersion{last_->number, std::nullopt, std::move(values)};
        }
    }
    // Created before the files are read, so that the stamps reveal a change during the reading.
    FileStamps stamps;
    std::optional<ParsedGraph> own;
    if (!same_files && parsed == nullptr) {
        ++work_.read;
        Result<ParsedGraph> made = parse_graph(request, settings_, &files);
        if (!made) return made.take_errors();
        parsed = &own.emplace(std::move(*made));
    }
    const std::set<std::filesystem::path>& graph_files = parsed ? parsed->files : last_->graph_files;
    files.insert(graph_files.begin(), graph_files.end());
    Diagnostics found;
    Result<LoadedGraph> loaded = resolve(request, parsed, found);
    warnings.insert(warnings.end(), found.begin(), found.end());
    files.insert(memory_.files().begin(), memory_.files().end());
    files.insert(searched_.begin(), searched_.end());
    if (!loaded) return loaded.take_errors();
    if (own) {
        last_.emplace();
        last_->stamps = std::move(stamps);
        last_->document = std::move(own->document);
        last_->graph_files = std::move(own->files);
    }
    // If the caller parsed the document, the files may have changed since then. So `last_` keeps only a
    // document that load() has read itself, in this call or in an earlier one.
    if (own || same_files) remember(request, std::move(found), *loaded);
    return LoadedVersion{work_.loads, std::move(*loaded), std::nullopt};
}

std::optional<ResolvedGraph> GraphLoader::change_values(const GraphRequest& request) {
    if (!last_->loaded || last_->request == request) return std::nullopt;
    const ImportCatalog imports = imports_at(request);
    std::optional<ResolvedGraph> graph = weft::change_values(*last_->loaded, last_->request,
                                                             {.request = request,
                                                              .settings = settings_,
                                                              .passes = passes_,
                                                              .imports = imports,
                                                              .profile = profile_});
    if (!graph) return std::nullopt;
    ++work_.changed_values;
    last_->request = request;
    last_->number = work_.loads;
    last_->loaded->graph = *graph;
    return graph;
}

void GraphLoader::remember(const GraphRequest& request, Diagnostics warnings, const LoadedGraph& loaded) {
    last_->request = request;
    last_->loaded.reset();
    const auto is_value = [](const GraphParam& param) { return param.cost <= ParamCost::live; };
    if (std::ranges::any_of(loaded.graph.params, is_value)) last_->loaded = loaded;
    last_->number = work_.loads;
    last_->warnings = std::move(warnings);
    last_->files = last_->graph_files;
    last_->files.insert(memory_.files().begin(), memory_.files().end());
    last_->files.insert(searched_.begin(), searched_.end());
    last_->stamps.take(last_->files);
}

Result<ResolvedGraph> GraphLoader::resolve_again(const LoadedGraph& loaded, const GraphRequest& request,
                                                 Diagnostics& warnings) const {
    const ImportCatalog imports = imports_at(request);
    return weft::resolve_again(loaded,
                               {.request = request,
                                .settings = settings_,
                                .passes = passes_,
                                .imports = imports,
                                .profile = profile_},
                               warnings);
}

std::optional<ResolvedGraph> GraphLoader::with_values(const LoadedGraph& loaded, const GraphRequest& from,
                                                      const GraphRequest& to) const {
    const ImportCatalog imports = imports_at(to);
    return weft::change_values(
        loaded, from,
        {.request = to, .settings = settings_, .passes = passes_, .imports = imports, .profile = profile_});
}

ImportCatalog GraphLoader::imports_at(const GraphRequest& request) const {
    ImportCatalog imports = imports_;
    set_output(imports, request, profile_);
    return imports;
}

}  // namespace weft::render
