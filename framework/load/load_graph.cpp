#include "weft/load/load_graph.h"

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include "graph/parse/debug_view.h"
#include "graph/resolve/change_values.h"
#include "graph/syntax/read_graph.h"
#include "load/area_reads.h"
#include "load/load_steps.h"
#include "load/place_shaders.h"
#include "load/shared_resources.h"
#include "load/text_reader.h"
#include "load/tier_formats.h"

namespace weft {
namespace {

// Adds to each error the name of the tier and, if the error has a line and column, the JSON pointer of the
// value at this place in the document.
void complete(const JsonDoc& document, const std::string& tier, Diagnostics& faults) {
    for (Diagnostic& fault : faults) {
        fault.tier = tier;
        if (fault.line == 0) continue;
        std::string pointer = pointer_at(document, fault.file, fault.line, fault.column);
        if (!pointer.empty()) fault.pointer = std::move(pointer);
    }
}

Diagnostics with_places(const JsonDoc& document, const std::string& tier, Diagnostics faults) {
    complete(document, tier, faults);
    return faults;
}

// Adds the absolute path of a file to `files`. If the path is or contains a link, the real path is added too.
void add_place(const std::string& path, std::set<std::filesystem::path>& files) {
    files.insert(std::filesystem::absolute(path).lexically_normal());
    std::error_code error;
    std::filesystem::path real = std::filesystem::canonical(path, error);
    if (!error) files.insert(std::move(real));
}

GraphReading reading_of(const LoadSettings& settings) {
    GraphReading reading{settings.graph_root.string(), settings.limits.graph};
    for (const std::filesystem::path& folder : settings.graph_path)
        reading.graph_path.push_back(folder.string());
    return reading;
}

Result<LoadedGraph> load_desc(const JsonDoc& document, GraphDesc desc, const LoadInput& input,
                              Diagnostics& warnings) {
    const GraphRequest& request = input.request;
    const auto known = static_cast<ptrdiff_t>(warnings.size());
    if (!request.debug.empty()) {
        Status added = add_debug_view(desc, input.imports, request.debug);
        if (!added) return with_places(document, request.tier, added.take_errors());
        place_shaders(desc, input.settings);
    }
    Diagnostics faults;
    TierVariant own{std::move(desc), {}};
    own.shaders = compile_shaders(own.desc, input, faults);
    SkippedFormats skipped;
    if (input.common_formats != nullptr)
        skipped = *input.common_formats;
    else if (faults.empty())
        skipped = formats_with_others(document, own, input);
    Result<ResolvedGraph> graph = resolve_formats(own.desc, own.shaders, input, skipped, warnings);
    if (!graph)
        append(faults, graph.take_errors());
    else
        warn_area_reads(own.desc.sources, *graph, own.shaders, warnings);
    Result<SharedUsages> shared = SharedUsages{};
    if (faults.empty()) shared = agree_on_shared(document, own, input, skipped);
    if (!shared) append(faults, shared.take_errors());
    complete(document, request.tier, faults);
    if (!own.desc.tiers.empty() && !input.compares_tiers)
        warnings.erase(std::remove_if(warnings.begin() + known, warnings.end(), says_unused), warnings.end());
    complete(document, request.tier, warnings);
    if (!faults.empty()) return faults;
    set_usages(*shared, *graph);
    return LoadedGraph{std::move(own.desc), std::move(own.shaders), std::move(*graph), std::move(skipped),
                       std::move(*shared)};
}

}  // namespace

bool says_unused(const Diagnostic& diagnostic) {
    constexpr std::array kCodes{"W130", "W132", "W133", "W134", "W135", "W136"};
    return std::ranges::find(kCodes, diagnostic.code) != kCodes.end();
}

Result<JsonDoc> read_graph(const std::string& path, const LoadSettings& settings) {
    return read_graph(path, reader_of(settings), reading_of(settings));
}

Result<ParsedGraph> parse_graph(const GraphRequest& request, const LoadSettings& settings,
                                std::set<std::filesystem::path>* files) {
    std::set<std::filesystem::path> places;
    const FileReader reader = [&, read = reader_of(settings)](const std::string& path) {
        add_place(path, places);
        return read(path);
    };
    Result<JsonDoc> document = read_graph(request.path, reader, reading_of(settings));
    Result<GraphDesc> desc = Diagnostics{};
    if (document) desc = parse_tier(*document, request.tier, settings, &places);
    if (files != nullptr) files->insert(places.begin(), places.end());
    if (!document) return document.take_errors();
    if (!desc) return with_places(*document, request.tier, desc.take_errors());
    return ParsedGraph{std::move(*document), std::move(*desc), std::move(places)};
}

Status check_request(const ParsedGraph& parsed, const GraphRequest& request, const ImportCatalog& imports) {
    Diagnostics faults;
    if (!request.debug.empty()) {
        GraphDesc desc = parsed.desc;
        Status added = add_debug_view(desc, imports, request.debug);
        if (!added) faults = added.take_errors();
    }
    if (faults.empty()) faults = param_faults(parsed.desc, request.params);
    if (!faults.empty()) return with_places(parsed.document, request.tier, std::move(faults));
    return Unit{};
}

Result<LoadedGraph> load_graph(const ParsedGraph& parsed, const LoadInput& input, Diagnostics& warnings) {
    return load_desc(parsed.document, parsed.desc, input, warnings);
}

Result<LoadedGraph> load_graph(const JsonDoc& document, const LoadInput& input, Diagnostics& warnings) {
    Result<GraphDesc> desc = parse_tier(document, input.request.tier, input.settings, input.searched);
    if (!desc) return with_places(document, input.request.tier, desc.take_errors());
    return load_desc(document, std::move(*desc), input, warnings);
}

Result<ResolvedGraph> resolve_again(const LoadedGraph& loaded, const LoadInput& input,
                                    Diagnostics& warnings) {
    Result<ResolvedGraph> graph =
        resolve_formats(loaded.desc, loaded.shaders, input, loaded.skipped_formats, warnings);
    if (graph) set_usages(loaded.shared_usages, *graph);
    return graph;
}

std::optional<ResolvedGraph> change_values(const LoadedGraph& loaded, const GraphRequest& from,
                                           const LoadInput& input) {
    if (!only_values_differ(from, input.request, loaded.graph.params)) return std::nullopt;
    return change_values(resolve_input(loaded.desc, loaded.shaders, input, loaded.skipped_formats),
                         loaded.graph);
}

}  // namespace weft
