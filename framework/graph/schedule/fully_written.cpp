#include "graph/schedule/fully_written.h"

#include <algorithm>
#include <span>

namespace weft {
namespace {

// A part of a resource that a pass writes.
struct WrittenPart {
    ResourceId resource;
    SubresourceRange range;
};

// Returns true if the parts in `written`, which all belong to the resource, together contain all its mips and
// layers. Aspects are not compared.
bool covers(const ResourceDecl& resource, std::span<const WrittenPart> written) {
    for (uint32_t mip = 0; mip < resource.mips; ++mip)
        for (uint32_t layer = 0; layer < resource.whole().layers; ++layer) {
            const bool found = std::ranges::any_of(written, [&](const WrittenPart& part) {
                const SubresourceRange& range = part.range;
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
    std::vector<WrittenPart> parts;
    for (const PassId pass : order.order) {
        for (const UseDecl& use : graph.passes[pass].uses) {
            if (!writes(use.access) || whole[use.resource]) continue;
            if (use.range == graph.resources[use.resource].whole())
                whole[use.resource] = 1;
            else
                parts.push_back({use.resource, use.range});
        }
    }
    std::ranges::stable_sort(parts, {}, &WrittenPart::resource);
    for (size_t first = 0, last = 0; first < parts.size(); first = last) {
        const ResourceId id = parts[first].resource;
        while (last < parts.size() && parts[last].resource == id) ++last;
        if (!whole[id])
            whole[id] = covers(graph.resources[id], std::span(parts).subspan(first, last - first)) ? 1 : 0;
    }
    return whole;
}

}  // namespace weft
