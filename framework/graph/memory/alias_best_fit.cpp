#include "graph/memory/alias_best_fit.h"

#include <algorithm>

#include "graph/model/round_up.h"

namespace weft {

uint64_t best_fit(const PackItem& item, std::span<const TakenSpan> taken, uint64_t top_bytes) {
    uint64_t best = kNoPlace, best_slack = UINT64_MAX, cursor = 0;
    const auto offer = [&](uint64_t gap_end) {
        const uint64_t start = round_up(cursor, item.alignment_bytes);
        if (start + item.size_bytes > gap_end) return;
        const uint64_t slack = gap_end - cursor - item.size_bytes;
        if (slack >= best_slack) return;
        best_slack = slack;
        best = start;
    };
    for (const TakenSpan& span : taken) {
        offer(span.begin_bytes);
        cursor = std::max(cursor, span.end_bytes);
    }
    if (best == kNoPlace) offer(top_bytes);
    return best;
}

Packing pack_in_order(const std::vector<PackItem>& items, const std::vector<uint32_t>& order,
                      Conflicts& conflicts) {
    Packing packing;
    packing.offsets_bytes.assign(items.size(), 0);
    conflicts.clear();
    for (const uint32_t i : order) {
        const uint64_t offset = best_fit(items[i], conflicts.taken(i), kNoLimit);
        packing.offsets_bytes[i] = offset;
        packing.height_bytes = std::max(packing.height_bytes, offset + items[i].size_bytes);
        conflicts.place(i, offset);
    }
    return packing;
}

}  // namespace weft
