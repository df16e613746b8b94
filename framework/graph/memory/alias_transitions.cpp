#include "graph/memory/alias_transitions.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>

namespace weft {
namespace {

struct Owner {
    ResourceId resource = kNoId;
    uint32_t frame = 0;
};

// Stores the last owner (resource and frame) of every byte range of one heap. A new owner replaces or
// shortens the ranges that it overlaps.
class OwnerMap {
 public:
    // Appends the owners of the bytes from `begin` to `end` - 1 to `old_owners`. Then makes `owner` the owner
    // of these bytes.
    void take(uint64_t begin, uint64_t end, Owner owner, std::vector<Owner>& old_owners) {
        cut(begin);
        cut(end);
        auto it = ranges_.lower_bound(begin);
        while (it != ranges_.end() && it->first < end) {
            old_owners.push_back(it->second.owner);
            it = ranges_.erase(it);
        }
        ranges_.emplace(begin, Range{end, owner});
    }

 private:
    struct Range {
        uint64_t end = 0;
        Owner owner;
    };

    void cut(uint64_t at) {
        auto it = ranges_.lower_bound(at);
        if (it == ranges_.begin()) return;
        it = std::prev(it);
        if (it->second.end <= at) return;
        const Range upper = it->second;
        it->second.end = at;
        ranges_.emplace(at, upper);
    }

    std::map<uint64_t, Range> ranges_;  // The ranges of one owner each. Key: first byte of the range.
};

bool before(const AliasTransition& a, const AliasTransition& b) {
    return std::tie(a.to, a.from, a.wrap) < std::tie(b.to, b.from, b.wrap);
}

}  // namespace

std::vector<AliasTransition> alias_transitions(const std::vector<Placement>& placements,
                                               const Lifetimes& spans) {
    std::vector<Placement> by_time = placements;
    std::sort(by_time.begin(), by_time.end(), [&](const Placement& a, const Placement& b) {
        return std::tie(spans.spans[a.resource].first, a.resource) <
               std::tie(spans.spans[b.resource].first, b.resource);
    });
    std::map<uint32_t, OwnerMap> heaps;
    std::vector<AliasTransition> result;
    std::vector<Owner> old_owners;
    for (uint32_t frame = 0; frame < 2; ++frame) {
        for (const Placement& p : by_time) {
            old_owners.clear();
            heaps[p.heap].take(p.offset_bytes, p.offset_bytes + p.size_bytes, {p.resource, frame},
                               old_owners);
            if (frame == 0) continue;
            for (const Owner& owner : old_owners)
                result.push_back({owner.resource, p.resource, owner.frame == 0});
        }
    }
    std::sort(result.begin(), result.end(), before);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

}  // namespace weft
