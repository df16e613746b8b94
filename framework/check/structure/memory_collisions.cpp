#include "check/structure/memory_collisions.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>

namespace weft::check {
namespace {

bool share_memory(const Placement& a, const Placement& b) {
    return a.heap == b.heap && a.offset_bytes < b.end_bytes() && b.offset_bytes < a.end_bytes();
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
            if (next.heap != first.heap || next.offset_bytes >= first.end_bytes()) break;
            if (share_memory(first, next))
                visit(std::min(by_offset[k], by_offset[l]), std::max(by_offset[k], by_offset[l]));
        }
    }
}

bool live_together(const FramePlan& plan, ResourceId a, ResourceId b) {
    const LifetimeSpan &s = plan.lifetimes.spans[a], &t = plan.lifetimes.spans[b];
    return outlives_the_frame(plan, a) || outlives_the_frame(plan, b) ||
           (s.first <= t.last && t.first <= s.last);
}

// A placement and the schedule positions during which its resource is alive.
struct Tenancy {
    Position first, last;
    uint32_t heap;
    uint64_t begin_bytes, end_bytes;
};

// Returns the tenancies (placements with their lifetimes) of all placements that are not empty, sorted by the
// first schedule position.
std::vector<Tenancy> tenancies(const FramePlan& plan) {
    std::vector<Tenancy> all;
    all.reserve(plan.memory.placements.size());
    for (const Placement& placement : plan.memory.placements) {
        const LifetimeSpan& span = plan.lifetimes.spans[placement.resource];
        Tenancy tenancy{std::min(span.first, span.last), std::max(span.first, span.last), placement.heap,
                        placement.offset_bytes, placement.end_bytes()};
        if (outlives_the_frame(plan, placement.resource)) tenancy.first = 0, tenancy.last = kNoId;
        if (tenancy.begin_bytes < tenancy.end_bytes) all.push_back(tenancy);
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Tenancy& a, const Tenancy& b) { return a.first < b.first; });
    return all;
}

// Returns true if two resources use the same bytes at the same schedule position. A tenancy is a placement
// with its lifetime. The function goes through the tenancies in the order of their first positions. So it is
// fast even if thousands of resources use the same bytes one after another.
bool any_collision(const FramePlan& plan) {
    struct Region {
        uint64_t end_bytes;
        Position last;  // Last schedule position at which this region is in use.
    };
    // The regions of the heaps with their latest user so far; they do not overlap. Key: (heap, first byte).
    std::map<std::pair<uint32_t, uint64_t>, Region> regions;
    for (const Tenancy& tenancy : tenancies(plan)) {
        auto region = regions.upper_bound({tenancy.heap, tenancy.begin_bytes});
        if (region != regions.begin()) {
            const auto before = std::prev(region);
            if (before->first.first == tenancy.heap && before->second.end_bytes > tenancy.begin_bytes)
                region = before;
        }
        while (region != regions.end() && region->first < std::pair(tenancy.heap, tenancy.end_bytes)) {
            if (region->second.last >= tenancy.first) return true;
            region = regions.erase(region);
        }
        regions.emplace_hint(region, std::pair(tenancy.heap, tenancy.begin_bytes),
                             Region{tenancy.end_bytes, tenancy.last});
    }
    return false;
}

}  // namespace

bool outlives_the_frame(const FramePlan& plan, ResourceId resource) {
    return plan.graph.resources[resource].lifetime == ResourceLifetime::persistent;
}

std::vector<std::pair<uint32_t, uint32_t>> memory_collisions(const FramePlan& plan) {
    std::vector<std::pair<uint32_t, uint32_t>> pairs;
    if (!any_collision(plan)) return pairs;
    const std::vector<Placement>& all = plan.memory.placements;
    for_each_overlap(all, [&](uint32_t i, uint32_t j) {
        if (live_together(plan, all[i].resource, all[j].resource)) pairs.emplace_back(i, j);
    });
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace weft::check
