// Best-fit packing over time: it simulates a heap from which resources are allocated and freed while the
// frame runs.
#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "graph/memory/alias_pack.h"
#include "graph/model/round_up.h"

namespace weft {
namespace {

class FreeList {
 public:
    explicit FreeList(uint64_t& height_bytes) : height_bytes_(height_bytes) {}

    uint64_t take(const PackItem& item) {
        for (auto hole = by_size_.lower_bound({item.size_bytes, 0}); hole != by_size_.end(); ++hole) {
            const auto [size, begin] = *hole;
            const uint64_t start = round_up(begin, item.alignment_bytes);
            if (start + item.size_bytes > begin + size) continue;
            remove(by_begin_.find(begin));
            give(begin, start);
            give(start + item.size_bytes, begin + size);
            return start;
        }
        return grow(item);
    }

    void give(uint64_t begin, uint64_t end) {
        if (begin == end) return;
        auto next = by_begin_.lower_bound(begin);
        if (next != by_begin_.end() && next->first == end) {
            end = next->second;
            next = remove(next);
        }
        if (next != by_begin_.begin() && std::prev(next)->second == begin) {
            begin = std::prev(next)->first;
            remove(std::prev(next));
        }
        by_begin_.emplace(begin, end);
        by_size_.emplace(end - begin, begin);
    }

 private:
    using Holes = std::map<uint64_t, uint64_t>;

    Holes::iterator remove(Holes::iterator hole) {
        by_size_.erase({hole->second - hole->first, hole->first});
        return by_begin_.erase(hole);
    }

    uint64_t grow(const PackItem& item) {
        uint64_t begin = height_bytes_;
        if (!by_begin_.empty() && by_begin_.rbegin()->second == height_bytes_) {
            begin = by_begin_.rbegin()->first;
            remove(std::prev(by_begin_.end()));
        }
        const uint64_t start = round_up(begin, item.alignment_bytes);
        give(begin, start);
        height_bytes_ = start + item.size_bytes;
        return start;
    }

    Holes by_begin_;                                   // The free gaps. Key: begin of a gap; value: its end.
    std::set<std::pair<uint64_t, uint64_t>> by_size_;  // The same gaps: size and begin of each.
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

Packing pack_sweep_back(std::vector<PackItem> items) {
    uint32_t end = 0;
    for (const PackItem& item : items) end = std::max(end, item.last);
    for (PackItem& item : items) {
        const uint32_t first = item.first;
        item.first = end - item.last;
        item.last = end - first;
    }
    return pack_sweep(items);
}

}  // namespace weft
