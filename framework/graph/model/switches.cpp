// Functions for graphs with switches, which are parameters that turn passes on and off from frame to frame.
#include <algorithm>

#include "weft/declaration.h"

namespace weft {

uint32_t variant_in(const PassDecl& pass, Combination combination) {
    for (uint32_t i = 0; i < pass.variants.size(); ++i)
        if (has_combination(pass.variants[i].combinations, combination)) return i;
    return 0;
}

PassDecl pass_of_variant(const PassDecl& pass, uint32_t variant) {
    PassDecl result = pass;
    if (pass.variants.empty()) return result;
    const PassVariant& chosen = pass.variants[variant];
    result.spec_values = chosen.spec_values;
    result.params = chosen.params;
    result.variants.clear();
    for (UseDecl& use : result.uses) {
        if ((use.used_in & chosen.combinations) != 0) continue;
        use.access = Access::none;
        use.binding = kNoId;
    }
    return result;
}

Combination switches_of(const ResolvedGraph& graph) {
    Combination combination = 0;
    for (uint32_t i = 0; i < graph.switches.size(); ++i) {
        const auto param = std::ranges::find(graph.params, graph.switches[i].param, &GraphParam::name);
        if (param != graph.params.end() && param->value != 0) combination |= 1u << i;
    }
    return combination;
}

}  // namespace weft
