#include "graph/resolve/switches/switches_text.h"

#include <bit>

namespace weft {

CombinationSet SwitchValues::combinations() const {
    CombinationSet set = 0;
    for (Combination c = 0; c < kCombinationCount; ++c)
        if ((c & named) == (values & named)) set = static_cast<CombinationSet>(set | 1u << c);
    return set;
}

SwitchValues fewest_values(const std::vector<SwitchDecl>& switches, CombinationSet set) {
    const uint32_t all = (1u << switches.size()) - 1;
    SwitchValues best{all, 0};
    for (uint32_t named = all + 1; named-- > 0;)
        for (Combination values = 0; values <= all; ++values) {
            const SwitchValues tried{named, values};
            const bool fewer = std::popcount(named) <= std::popcount(best.named);
            if (fewer && (values & ~named) == 0 && (tried.combinations() & ~set) == 0) best = tried;
        }
    return best;
}

std::string values_text(const std::vector<SwitchDecl>& switches, const SwitchValues& values) {
    std::string text;
    for (uint32_t s = 0; s < switches.size(); ++s)
        if ((values.named >> s & 1u) != 0)
            text += (text.empty() ? "\"" : " and \"") + switches[s].param +
                    ((values.values >> s & 1u) != 0 ? "\" is on" : "\" is off");
    return text;
}

}  // namespace weft
