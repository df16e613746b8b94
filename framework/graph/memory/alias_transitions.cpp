#include "graph/memory/alias_transitions.h"

#include <algorithm>
#include <span>
#include <tuple>

#include "graph/memory/alias_owners.h"
#include "graph/model/rows.h"

namespace weft {
namespace {

// Returns the placed resources, sorted by (first position, resource).
std::vector<ResourceId> by_first_position(const std::vector<Placement>& placements, const Lifetimes& spans) {
    std::vector<uint8_t> placed(spans.spans.size(), 0);
    Position end(0);
    for (const Placement& p : placements) {
        placed[p.resource] = 1;
        end = std::max(end, Position(spans.spans[p.resource].first + 1));
    }
    return make_rows<ResourceId>(end,
                                 [&](const auto& add) {
                                     for (ResourceId id(0); id < placed.size(); ++id)
                                         if (placed[id] != 0) add(spans.spans[id].first, id);
                                 })
        .items;
}

}  // namespace

std::vector<AliasTransition> alias_transitions(const std::vector<Placement>& placements,
                                               const Lifetimes& spans) {
    // Index: ResourceId. Value: index of the resource in `placements`.
    std::vector<uint32_t> place_of(spans.spans.size(), 0);
    uint32_t heap_count = 0;
    for (uint32_t i = 0; i < placements.size(); ++i) {
        place_of[placements[i].resource] = i;
        heap_count = std::max(heap_count, placements[i].heap + 1);
    }
    const std::vector<ResourceId> by_time = by_first_position(placements, spans);
    std::vector<OwnerMap> heaps(heap_count);
    std::vector<Owner> old_owners;
    const auto take = [&](ResourceId id, uint32_t frame) {
        const Placement& p = placements[place_of[id]];
        heaps[p.heap].take(p.offset_bytes, p.offset_bytes + p.size_bytes, {id, frame}, old_owners);
    };
    for (const ResourceId id : by_time) take(id, 0);
    old_owners.clear();
    // Index: ResourceId. The previous owners of the bytes of the resource are `owner_count` elements of
    // `old_owners`, from index `first_owner` on.
    std::vector<uint32_t> first_owner(spans.spans.size(), 0);
    std::vector<uint32_t> owner_count(spans.spans.size(), 0);
    for (const ResourceId id : by_time) {
        first_owner[id] = static_cast<uint32_t>(old_owners.size());
        take(id, 1);
        owner_count[id] = static_cast<uint32_t>(old_owners.size()) - first_owner[id];
    }
    std::vector<AliasTransition> result;
    result.reserve(old_owners.size());
    for (ResourceId to(0); to < spans.spans.size(); ++to) {
        const auto first = static_cast<std::ptrdiff_t>(result.size());
        for (const Owner& owner : std::span(old_owners).subspan(first_owner[to], owner_count[to]))
            result.push_back({owner.resource, to, owner.frame == 0});
        std::sort(result.begin() + first, result.end(),
                  [](const AliasTransition& a, const AliasTransition& b) {
                      return std::tie(a.from, a.wrap) < std::tie(b.from, b.wrap);
                  });
        result.erase(std::unique(result.begin() + first, result.end()), result.end());
    }
    return result;
}

}  // namespace weft
