#include "graph/schedule/fully_written.h"

#include <algorithm>

namespace weft {
namespace {

bool covers(const ResourceDecl& resource, const std::vector<SubresourceRange>& written) {
    for (uint32_t mip = 0; mip < resource.mips; ++mip)
        for (uint32_t layer = 0; layer < resource.whole().layers; ++layer) {
            const bool found = std::ranges::any_of(written, [&](const SubresourceRange& range) {
                return range.mip <= mip && mip < range.mip + range.mips && range.layer <= layer &&
                       layer < range.layer + range.layers;
            });
            if (!found) return false;
        }
    return true;
}

}  // namespace

std::vector<uint8_t> fully_written(const ResolvedGraph& graph, const Schedule& order) {
    std::vector<uint8_t> whole(graph.resources.size(), 0);
    std::vector<std::vector<SubresourceRange>> parts(graph.resources.size());
    for (const PassId pass : order.order) {
        for (const UseDecl& use : graph.passes[pass].uses) {
            if (!writes(use.access) || whole[use.resource]) continue;
            if (use.range == graph.resources[use.resource].whole())
                whole[use.resource] = 1;
            else
                parts[use.resource].push_back(use.range);
        }
    }
    for (ResourceId id(0); id < whole.size(); ++id)
        if (!whole[id] && !parts[id].empty()) whole[id] = covers(graph.resources[id], parts[id]) ? 1 : 0;
    return whole;
}

}  // namespace weft
