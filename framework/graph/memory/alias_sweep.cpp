// Best-fit packing over time: it simulates a heap from which resources are allocated and freed while the
// frame runs.
#include <algorithm>
#include <map>
#include <numeric>

#include "graph/memory/alias_pack.h"

namespace weft {
namespace {

class FreeList {
 public:
    explicit FreeList(uint64_t& height_bytes) : height_bytes_(height_bytes) {}

    uint64_t take(const PackItem& item) {
        auto best = holes_.end();
        uint64_t best_slack = UINT64_MAX;
        for (auto hole = holes_.begin(); hole != holes_.end(); ++hole) {
            const uint64_t start = aligned(hole->first, item.alignment_bytes);
            if (start + item.size_bytes > hole->second) continue;
            const uint64_t slack = hole->second - hole->first - item.size_bytes;
            if (slack >= best_slack) continue;
            best_slack = slack;
            best = hole;
        }
        return best == holes_.end() ? grow(item) : split(best, item);
    }

    void give(uint64_t begin, uint64_t end) {
        if (begin == end) return;
        auto next = holes_.lower_bound(begin);
        if (next != holes_.end() && next->first == end) {
            end = next->second;
            next = holes_.erase(next);
        }
        if (next != holes_.begin() && std::prev(next)->second == begin)
            std::prev(next)->second = end;
        else
            holes_.emplace(begin, end);
    }

 private:
    using Holes = std::map<uint64_t, uint64_t>;  // The free gaps. Key: begin of a gap; value: its end.

    static uint64_t aligned(uint64_t offset_bytes, uint64_t alignment_bytes) {
        return (offset_bytes + alignment_bytes - 1) / alignment_bytes * alignment_bytes;
    }

    uint64_t split(Holes::iterator hole, const PackItem& item) {
        const auto [begin, end] = *hole;
        const uint64_t start = aligned(begin, item.alignment_bytes);
        holes_.erase(hole);
        give(begin, start);
        give(start + item.size_bytes, end);
        return start;
    }

    uint64_t grow(const PackItem& item) {
        uint64_t begin = height_bytes_;
        if (!holes_.empty() && holes_.rbegin()->second == height_bytes_) {
            begin = holes_.rbegin()->first;
            holes_.erase(begin);
        }
        const uint64_t start = aligned(begin, item.alignment_bytes);
        give(begin, start);
        height_bytes_ = start + item.size_bytes;
        return start;
    }

    Holes holes_;
    uint64_t& height_bytes_;
};

}  // namespace

Packing pack_sweep(const std::vector<PackItem>& items) {
    std::vector<uint32_t> starts(items.size()), ends(items.size());
    std::iota(starts.begin(), starts.end(), 0u);
    std::iota(ends.begin(), ends.end(), 0u);
    std::stable_sort(starts.begin(), starts.end(), [&](uint32_t a, uint32_t b) {
        if (items[a].first != items[b].first) return items[a].first < items[b].first;
        return items[a].size_bytes > items[b].size_bytes;
    });
    std::stable_sort(ends.begin(), ends.end(),
                     [&](uint32_t a, uint32_t b) { return items[a].last < items[b].last; });
    Packing packing;
    packing.offsets_bytes.assign(items.size(), 0);
    FreeList free_list(packing.height_bytes);
    size_t ended = 0;
    for (const uint32_t i : starts) {
        for (; items[ends[ended]].last < items[i].first; ++ended) {
            const uint64_t offset = packing.offsets_bytes[ends[ended]];
            free_list.give(offset, offset + items[ends[ended]].size_bytes);
        }
        packing.offsets_bytes[i] = free_list.take(items[i]);
    }
    return packing;
}

}  // namespace weft
