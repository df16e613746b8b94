#include "check/memory_holders.h"

#include <algorithm>
#include <iterator>

namespace weft::check {
namespace {

bool is_in(const std::vector<ResourceId>& list, ResourceId resource) {
    return std::find(list.begin(), list.end(), resource) != list.end();
}

}  // namespace

MemoryHolders::MemoryHolders(const FramePlan& plan)
    : placements_(plan.memory.placements),
      first_(plan.graph.resources.size() + 1, 0),
      holds_all_(plan.graph.resources.size(), 0),
      taken_from_(plan.graph.resources.size()) {
    std::stable_sort(placements_.begin(), placements_.end(),
                     [](const Placement& a, const Placement& b) { return a.resource < b.resource; });
    for (const Placement& placement : placements_) ++first_[placement.resource + size_t{1}];
    for (size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

template <class Visit>
void MemoryHolders::for_each_placement(ResourceId resource, Visit visit) const {
    for (size_t i = first_[resource]; i < first_[resource + size_t{1}]; ++i)
        if (placements_[i].offset_bytes < placements_[i].end_bytes()) visit(placements_[i]);
}

MemoryHolders::Regions::const_iterator MemoryHolders::first_in(const Placement& placement) const {
    auto region = regions_.upper_bound({placement.heap, placement.offset_bytes});
    if (region == regions_.begin()) return region;
    const auto before = std::prev(region);
    const bool reaches_in =
        before->first.first == placement.heap && before->second.end_bytes > placement.offset_bytes;
    return reaches_in ? before : region;
}

void MemoryHolders::cut(const Address& at) {
    const auto after = regions_.upper_bound(at);
    if (after == regions_.begin()) return;
    const auto region = std::prev(after);
    const bool inside = region->first.first == at.first && region->first.second < at.second &&
                        at.second < region->second.end_bytes;
    if (!inside) return;
    regions_.emplace_hint(after, at, region->second);
    region->second.end_bytes = at.second;
}

void MemoryHolders::cut(const Placement& placement) {
    cut({placement.heap, placement.offset_bytes});
    cut({placement.heap, placement.end_bytes()});
}

void MemoryHolders::find_others(ResourceId resource) {
    others_.clear();
    for_each_placement(resource, [&](const Placement& placement) {
        const Address end{placement.heap, placement.end_bytes()};
        for (auto region = first_in(placement); region != regions_.end() && region->first < end; ++region)
            for (const ResourceId holder : region->second.holders)
                if (holder != resource) others_.push_back(holder);
    });
    std::sort(others_.begin(), others_.end());
    others_.erase(std::unique(others_.begin(), others_.end()), others_.end());
}

std::span<const ResourceId> MemoryHolders::to_wait_for(ResourceId taker) {
    find_others(taker);
    return others_.empty() ? taken_from_[taker] : others_;
}

std::span<const ResourceId> MemoryHolders::take_over(ResourceId taker) {
    find_others(taker);
    if (others_.empty() && holds_all_[taker] != 0) return others_;
    for (const ResourceId other : others_) holds_all_[other] = 0;
    if (!others_.empty()) taken_from_[taker] = others_;
    holds_all_[taker] = 1;
    for_each_placement(taker, [&](const Placement& placement) {
        cut(placement);
        const Address begin{placement.heap, placement.offset_bytes},
            end{placement.heap, placement.end_bytes()};
        regions_.erase(regions_.lower_bound(begin), regions_.lower_bound(end));
        regions_.emplace(begin, Region{end.second, {taker}});
    });
    return others_;
}

void MemoryHolders::use(ResourceId resource) {
    if (holds_all_[resource] != 0) return;
    holds_all_[resource] = 1;
    for_each_placement(resource, [&](const Placement& placement) {
        cut(placement);
        // Add the resource to the regions inside the placement. In gaps between regions, create new regions.
        uint64_t at = placement.offset_bytes;
        while (at < placement.end_bytes()) {
            const auto next = regions_.lower_bound({placement.heap, at});
            const bool here = next != regions_.end() && next->first == Address{placement.heap, at};
            if (here) {
                if (!is_in(next->second.holders, resource)) next->second.holders.push_back(resource);
                at = next->second.end_bytes;
                continue;
            }
            const bool stops = next != regions_.end() && next->first.first == placement.heap;
            const uint64_t end =
                stops ? std::min(placement.end_bytes(), next->first.second) : placement.end_bytes();
            regions_.emplace(Address{placement.heap, at}, Region{end, {resource}});
            at = end;
        }
    });
}

}  // namespace weft::check
