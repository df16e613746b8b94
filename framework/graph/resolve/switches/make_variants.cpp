#include "graph/resolve/switches/make_variants.h"

#include <algorithm>

#include "graph/resolve/fill_blocks.h"

namespace weft {
namespace {

constexpr std::string_view kHasPrefix = "HAS_";

// Returns true if the shader has the member "<port>Valid" in its block Params.
bool asks_for_validity(const PassDraft& draft, const UseDecl& use) {
    return std::ranges::any_of(draft.shader->params.members,
                               [&](const BlockMember& member) { return member.name == use.port + "Valid"; });
}

// The inputs of a pass in one combination of switch values. The list has two numbers for each use. The first
// number is 1 if the pass reads the use. The second number is 1 if the shader asks whether the content is
// valid, and it is not valid.
using Inputs = std::vector<uint8_t>;

Inputs inputs_in(const PassDraft& draft, const BoundPass& bound, Combination combination) {
    Inputs inputs;
    for (size_t i = 0; i < bound.uses.size(); ++i) {
        const UseDecl& use = bound.uses[i];
        const bool invalid = !has_combination(bound.ports[i].valid_in, combination);
        inputs.push_back(has_combination(use.used_in, combination) ? 1 : 0);
        inputs.push_back(invalid && asks_for_validity(draft, use) ? 1 : 0);
    }
    return inputs;
}

bool depends_on_switches(const PassDraft& draft, const BoundPass& bound) {
    if (draft.shader == nullptr) return false;
    for (size_t i = 0; i < bound.uses.size(); ++i) {
        const UseDecl& use = bound.uses[i];
        if (use.used_in != kEveryCombination) return true;
        if (bound.ports[i].valid_in != kEveryCombination && asks_for_validity(draft, use)) return true;
    }
    return false;
}

// Returns true if the port is bound in some combinations of the switches, but not in this combination.
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
    // Combinations in which the pass does not run have no variant of their own. They are added to the first
    // variant.
    const CombinationSet runs_in = draft.decl.runs_in;
    std::vector<PassVariant> variants;
    std::vector<Inputs> inputs;
    for (Combination c = kCombinationCount; c-- > 0;) {
        if (!has_combination(runs_in, c)) continue;
        const Inputs own = inputs_in(draft, bound, c);
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
        if (!depends_on_switches(declared.expansion.passes[pass], versioned.passes[pass])) continue;
        decl.variants = variants_of(declared, versioned, pass, reporter);
        decl.spec_values = decl.variants.front().spec_values;
        decl.params = decl.variants.front().params;
    }
    return graph;
}

}  // namespace weft
