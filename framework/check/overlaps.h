// Purpose: finds the pairs of placements (resources in a heap) that share bytes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "weft/plan.h"

namespace weft::check {

[[nodiscard]] inline bool share_memory(const Placement& a, const Placement& b) {
    return a.heap == b.heap && a.offset_bytes < b.offset_bytes + b.size_bytes &&
           b.offset_bytes < a.offset_bytes + a.size_bytes;
}

// Calls visit(i, j) once for each pair of placements that share bytes; i and j are their indices, i < j. The
// placements are sorted by offset, and each is compared only with placements that begin inside it. So the run
// time grows with the number of pairs that share bytes.
template <typename Visit>
void for_each_overlap(const std::vector<Placement>& placements, Visit visit) {
    std::vector<uint32_t> by_offset(placements.size());
    std::iota(by_offset.begin(), by_offset.end(), 0u);
    std::sort(by_offset.begin(), by_offset.end(), [&](uint32_t a, uint32_t b) {
        const Placement &p = placements[a], &q = placements[b];
        return p.heap != q.heap ? p.heap < q.heap : p.offset_bytes < q.offset_bytes;
    });
    for (size_t k = 0; k < by_offset.size(); ++k) {
        const Placement& first = placements[by_offset[k]];
        for (size_t l = k + 1; l < by_offset.size(); ++l) {
            const Placement& next = placements[by_offset[l]];
            if (next.heap != first.heap || next.offset_bytes >= first.offset_bytes + first.size_bytes) break;
            if (share_memory(first, next))
                visit(std::min(by_offset[k], by_offset[l]), std::max(by_offset[k], by_offset[l]));
        }
    }
}

}  // namespace weft::check
