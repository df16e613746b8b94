#include "weft/load/load_graph.h"

#include <iterator>
#include <utility>

#include "graph/resolve/resolve.h"
#include "graph/syntax/read_graph.h"
#include "load/load_steps.h"
#include "load/tier_formats.h"

namespace weft {
namespace {

// Semantic faults already have a place in the text. This adds their place in the document as written, and the
// tier in which they occur.
void complete(const JsonDoc& document, const LoadInput& input, Diagnostics& faults) {
    for (Diagnostic& fault : faults) {
        fault.tier = input.tier;
        if (fault.line == 0) continue;
        std::string pointer = pointer_at(document, fault.file, fault.line, fault.column);
        if (!pointer.empty()) fault.pointer = std::move(pointer);
    }
}

}  // namespace

Result<JsonDoc> read_graph(const LoadInput& input) {
    return read_graph(input.path, input.reader, {input.graph_root.string(), input.limits.graph});
}

Status check_request(const LoadInput& input) {
    const Result<JsonDoc> document = read_graph(input);
    if (!document) return document.errors();
    Result<GraphDesc> desc = described(*document, input);
    Diagnostics faults = desc ? param_faults(*desc, input.params) : desc.take_errors();
    complete(*document, input, faults);
    if (!faults.empty()) return faults;
    return Unit{};
}

Result<LoadedGraph> load_graph(const LoadInput& input, Diagnostics& warnings) {
    const Result<JsonDoc> document = read_graph(input);
    return document ? load_graph(*document, input, warnings) : document.errors();
}

Result<LoadedGraph> load_graph(const JsonDoc& document, const LoadInput& input, Diagnostics& warnings) {
    Result<GraphDesc> desc = described(document, input);
    if (!desc) {
        Diagnostics faults = desc.take_errors();
        complete(document, input, faults);
        return faults;
    }

    Diagnostics faults;
    TierVariant own{std::move(*desc), {}};
    own.shaders = compile_shaders(own.desc, input, faults);
    SkippedFormats skipped;
    if (input.common_formats != nullptr)
        skipped = *input.common_formats;
    else if (faults.empty())
        skipped = formats_with_others(document, own, input);
    Result<ResolvedGraph> graph = resolved(own.desc, own.shaders, input, skipped, warnings);
    if (!graph) append(faults, graph.take_errors());
    complete(document, input, faults);
    complete(document, input, warnings);
    if (!faults.empty()) return faults;
    return LoadedGraph{std::move(own.desc), std::move(own.shaders), std::move(*graph), std::move(skipped)};
}

Result<ResolvedGraph> resolve_again(const LoadedGraph& loaded, const LoadInput& input,
                                    Diagnostics& warnings) {
    return resolved(loaded.desc, loaded.shaders, input, loaded.skipped_formats, warnings);
}

}  // namespace weft
