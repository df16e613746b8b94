#include "load/tier_formats.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "graph/syntax/merge.h"
#include "load/load_steps.h"

namespace weft {
namespace {

bool has_alternatives(const GraphDesc& desc) {
    return std::ranges::any_of(desc.resources, [](const auto& r) { return r.second.formats.size() > 1; });
}

std::vector<std::string> all_tiers(const JsonDoc& document) {
    std::vector<std::string> tiers = tier_names(document);
    tiers.emplace_back();
    return tiers;
}

// Sets skipped[name] for each image with alternative formats to the index of the format that was chosen, if
// this index is larger. Returns whether a value changed.
bool raise(const GraphDesc& desc, const ResolvedGraph& graph, SkippedFormats& skipped) {
    bool changed = false;
    for (const auto& [name, resource] : desc.resources) {
        const ResourceId id = find_resource(graph, name);
        if (id == kNoId || resource.formats.size() < 2) continue;
        const std::string chosen(format_info(graph.resources[id].format).name);
        const auto at =
            static_cast<size_t>(std::ranges::find(resource.formats, chosen) - resource.formats.begin());
        size_t& least = skipped[name];
        changed = changed || at > least;
        least = std::max(least, at);
    }
    return changed;
}

// Resolves one tier without the skipped formats. Then raises `skipped` to the indices of the formats that
// were chosen. Returns whether a value changed.
bool raise_for(const TierVariant& variant, const LoadInput& input, SkippedFormats& skipped) {
    Diagnostics ignored;
    const Result<ResolvedGraph> graph =
        resolve_formats(variant.desc, variant.shaders, input, skipped, ignored);
    return graph && raise(variant.desc, *graph, skipped);
}

}  // namespace

std::vector<TierVariant> load_tiers(const JsonDoc& document, const std::vector<std::string>& tiers,
                                    LoadInput input) {
    std::vector<TierVariant> variants;
    for (const std::string& tier : tiers) {
        input.request.tier = tier;
        Result<GraphDesc> desc = parse_tier(document, tier, input.settings);
        if (!desc) continue;
        Diagnostics faults;
        ShaderCatalog shaders = compile_shaders(*desc, input, faults);
        if (faults.empty()) variants.push_back({std::move(*desc), std::move(shaders)});
    }
    return variants;
}

LoadInput as_written(LoadInput input) {
    input.request.observed.clear();
    input.request.exports.clear();
    input.request.params.clear();
    input.request.debug.clear();
    return input;
}

SkippedFormats common_formats(const JsonDoc& document, const LoadInput& input) {
    SkippedFormats skipped;
    const LoadInput plain = as_written(input);
    const std::vector<TierVariant> variants = load_tiers(document, all_tiers(document), plain);
    bool changed = variants.size() > 1;
    while (changed) {
        changed = false;
        for (const TierVariant& variant : variants) changed = raise_for(variant, plain, skipped) || changed;
    }
    return skipped;
}

SkippedFormats formats_with_others(const JsonDoc& document, const TierVariant& own, const LoadInput& input) {
    SkippedFormats skipped;
    if (tier_names(document).empty() || !has_alternatives(own.desc)) return skipped;
    const LoadInput plain = as_written(input);
    std::vector<std::string> names = all_tiers(document);
    std::erase(names, input.request.tier);
    const std::vector<TierVariant> others = load_tiers(document, names, plain);
    bool changed = true;
    while (changed) {
        changed = false;
        for (const TierVariant& other : others) changed = raise_for(other, plain, skipped) || changed;
        changed = raise_for(own, input, skipped) || changed;
    }
    return skipped;
}

}  // namespace weft
