#include "graph/resolve/switches/make_variants.h"

#include <algorithm>

#include "graph/resolve/fill_blocks.h"

namespace weft {
namespace {

constexpr std::string_view kHasPrefix = "HAS_";

// The inputs of a pass in one combination: which uses are read, and which have valid content.
using Inputs = std::vector<uint8_t>;

Inputs inputs_in(const BoundPass& bound, Combination combination) {
    Inputs inputs;
    for (size_t i = 0; i < bound.uses.size(); ++i) {
        inputs.push_back(has_combination(bound.uses[i].used_in, combination) ? 1 : 0);
        inputs.push_back(has_combination(bound.ports[i].valid_in, combination) ? 1 : 0);
    }
    return inputs;
}

bool depends_on_switches(const BoundPass& bound) {
    return std::ranges::any_of(bound.uses, [](const UseDecl& u) { return u.used_in != kEveryCombination; }) ||
           std::ranges::any_of(bound.ports,
                               [](const PortDraft& p) { return p.valid_in != kEveryCombination; });
}

// Returns true if the port is one of those that are bound only in some combinations, and is not bound in
// this one.
bool is_unbound(const BoundPass& bound, std::string_view port, Combination combination) {
    bool known = false;
    for (const UseDecl& use : bound.uses) {
        if (use.port != port) continue;
        if (has_combination(use.used_in, combination)) return false;
        known = true;
    }
    return known;
}

std::vector<SpecValue> constants_in(const PassDraft& draft, const BoundPass& bound, Combination combination) {
    std::vector<SpecValue> values = bound.spec_values;
    for (const SpecConstant& constant : draft.shader->spec_constants) {
        if (constant.type != ScalarType::boolean || !constant.name.starts_with(kHasPrefix)) continue;
        const auto value = std::ranges::find(values, constant.id, &SpecValue::id);
        const std::string_view port = std::string_view(constant.name).substr(kHasPrefix.size());
        if (value != values.end() && is_unbound(bound, port, combination)) value->bits = 0;
    }
    return values;
}

std::vector<PassVariant> variants_of(const Declared& declared, const VersionedGraph& versioned, PassId pass,
                                     Reporter& reporter) {
    const PassDraft& draft = declared.expansion.passes[pass];
    const BoundPass& bound = versioned.passes[pass];
    // Combinations in which the pass does not run have no variant of their own.
    const CombinationSet runs_in = draft.decl.runs_in;
    std::vector<PassVariant> variants;
    std::vector<Inputs> inputs;
    for (Combination c = kCombinationCount; c-- > 0;) {
        if (!has_combination(runs_in, c)) continue;
        const Inputs own = inputs_in(bound, c);
        const auto place = std::ranges::find(inputs, own) - inputs.begin();
        if (place == std::ssize(inputs)) {
            inputs.push_back(own);
            variants.push_back({.combinations = 0,
                                .spec_values = constants_in(draft, bound, c),
                                .params = fill_block(declared, versioned, pass, c, reporter)});
        }
        CombinationSet& set = variants[static_cast<size_t>(place)].combinations;
        set = static_cast<CombinationSet>(set | 1u << c);
    }
    CombinationSet used = 0;
    for (const PassVariant& variant : variants)
        used = static_cast<CombinationSet>(used | variant.combinations);
    CombinationSet& first = variants.front().combinations;
    first = static_cast<CombinationSet>(first | complement(used));
    return variants;
}

}  // namespace

ResolvedGraph make_variants(const Declared& declared, const VersionedGraph& versioned, ResolvedGraph graph,
                            Reporter& reporter) {
    if (declared.expansion.switches.empty()) return graph;
    graph.switches = declared.expansion.switches;
    if (reporter.has_errors()) return graph;
    for (PassId pass(0); pass < graph.passes.size(); ++pass) {
        PassDecl& decl = graph.passes[pass];
        if (!depends_on_switches(versioned.passes[pass]) || !declared.expansion.passes[pass].shader) continue;
        decl.variants = variants_of(declared, versioned, pass, reporter);
        decl.spec_values = decl.variants.front().spec_values;
        decl.params = decl.variants.front().params;
    }
    return graph;
}

}  // namespace weft
