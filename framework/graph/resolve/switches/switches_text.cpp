#include "graph/resolve/switches/switches_text.h"

#include <bit>

namespace weft {
namespace {

// Returns the combinations in which the switches of `named` are as in `values`.
CombinationSet combinations_like(uint32_t named, Combination values) {
    CombinationSet set = 0;
    for (Combination c = 0; c < kCombinationCount; ++c)
        if ((c & named) == (values & named)) set = static_cast<CombinationSet>(set | 1u << c);
    return set;
}

}  // namespace

std::string switches_text(const std::vector<SwitchDecl>& switches, CombinationSet set) {
    const uint32_t known = (1u << switches.size()) - 1;
    for (int count = 0; count <= static_cast<int>(kMostSwitches); ++count)
        for (uint32_t named = 0; named <= known; ++named)
            for (Combination values = 0; values <= known; ++values) {
                if (std::popcount(named) != count || (values & ~named) != 0) continue;
                if ((combinations_like(named, values) & ~set) != 0) continue;
                std::string text;
                for (uint32_t s = 0; s < switches.size(); ++s)
                    if ((named >> s & 1u) != 0)
                        text += (text.empty() ? "\"" : " and \"") + switches[s].param +
                                ((values >> s & 1u) != 0 ? "\" is on" : "\" is off");
                return text;
            }
    return "";
}

}  // namespace weft
