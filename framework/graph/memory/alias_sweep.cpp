// Best-fit packing over time: it simulates a heap from which resources are allocated and freed while the
// frame runs.
#include <algorithm>
#include <compare>
#include <numeric>

#include "graph/memory/alias_pack.h"
#include "graph/memory/sorted_list.h"
#include "graph/model/round_up.h"

namespace weft {
namespace {

// The blocks of a heap in the order of their bytes. A block is in use or free. Two free blocks are never
// neighbours.
class BlockList {
 public:
    // Takes space for the item from the smallest free block into which it fits. If it fits into none, the
    // heap grows. Returns the index of the block that now contains the item.
    uint32_t take(const PackItem& item) {
        const auto fits = [&](const Gap& gap) {
            const Block& block = blocks_[gap.block];
            return round_up(block.begin, item.alignment_bytes) + item.size_bytes <= block.end;
        };
        const Gap* gap = gaps_.find({item.size_bytes, 0, 0}, fits);
        const uint32_t block = gap != nullptr ? gap->block : grow(item);
        if (gap != nullptr) gaps_.erase(Gap(*gap));
        const uint64_t start = round_up(blocks_[block].begin, item.alignment_bytes);
        if (start != blocks_[block].begin) split_before(block, start);
        const uint64_t end = start + item.size_bytes;
        if (end != blocks_[block].end) split_behind(block, end);
        blocks_[block].free = false;
        return block;
    }
    void give(uint32_t block) {
        blocks_[block].free = true;
        if (const uint32_t before = blocks_[block].before; before != kNoId && blocks_[before].free) {
            remove_gap(before);
            blocks_[block].begin = blocks_[before].begin;
            unlink(before);
        }
        if (const uint32_t behind = blocks_[block].behind; behind != kNoId && blocks_[behind].free) {
            remove_gap(behind);
            blocks_[block].end = blocks_[behind].end;
            unlink(behind);
        }
        add_gap(block);
    }
    [[nodiscard]] uint64_t begin_of(uint32_t block) const { return blocks_[block].begin; }
    [[nodiscard]] uint64_t height_bytes() const { return last_ == kNoId ? 0 : blocks_[last_].end; }

 private:
    struct Block {
        uint64_t begin = 0, end = 0;
        // Indices of the blocks directly before and behind this block.
        uint32_t before = kNoId, behind = kNoId;
        bool free = true;
    };
    // A free block. Gaps are sorted by size, then by begin.
    struct Gap {
        uint64_t size = 0, begin = 0;
        uint32_t block = 0;
        auto operator<=>(const Gap&) const = default;
    };

    [[nodiscard]] Gap gap_of(uint32_t block) const {
        return {blocks_[block].end - blocks_[block].begin, blocks_[block].begin, block};
    }
    void add_gap(uint32_t block) { gaps_.insert(gap_of(block)); }
    void remove_gap(uint32_t block) { gaps_.erase(gap_of(block)); }

    // Returns a block at the end of the heap into which the item fits exactly. The heap grows.
    uint32_t grow(const PackItem& item) {
        if (last_ == kNoId || !blocks_[last_].free) {
            const uint64_t top = height_bytes();
            last_ = insert_between(last_, kNoId, top, top);
        } else {
            remove_gap(last_);
        }
        blocks_[last_].end = round_up(blocks_[last_].begin, item.alignment_bytes) + item.size_bytes;
        return last_;
    }
    void split_before(uint32_t block, uint64_t start) {
        const uint32_t gap = insert_between(blocks_[block].before, block, blocks_[block].begin, start);
        blocks_[block].begin = start;
        add_gap(gap);
    }
    void split_behind(uint32_t block, uint64_t end) {
        const uint32_t gap = insert_between(block, blocks_[block].behind, end, blocks_[block].end);
        blocks_[block].end = end;
        if (last_ == block) last_ = gap;
        add_gap(gap);
    }
    uint32_t insert_between(uint32_t before, uint32_t behind, uint64_t begin, uint64_t end) {
        const auto block = static_cast<uint32_t>(blocks_.size());
        blocks_.push_back({begin, end, before, behind, true});
        if (before != kNoId) blocks_[before].behind = block;
        if (behind != kNoId) blocks_[behind].before = block;
        return block;
    }
    void unlink(uint32_t block) {
        const auto [begin, end, before, behind, free] = blocks_[block];
        if (before != kNoId) blocks_[before].behind = behind;
        if (behind != kNoId) blocks_[behind].before = before;
        if (last_ == block) last_ = before;
    }

    std::vector<Block> blocks_;
    SortedList<Gap> gaps_;
    uint32_t last_ = kNoId;  // Index of the block at the end of the heap.
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
    BlockList blocks;
    std::vector<uint32_t> block_of(items.size());
    size_t ended = 0;
    for (const uint32_t i : starts) {
        for (; items[ends[ended]].last < items[i].first; ++ended) blocks.give(block_of[ends[ended]]);
        block_of[i] = blocks.take(items[i]);
        packing.offsets_bytes[i] = blocks.begin_of(block_of[i]);
    }
    packing.height_bytes = blocks.height_bytes();
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
