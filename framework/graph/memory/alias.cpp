// Places all transient resources in heaps. Resources with the same allowed memory types share a heap. Buffers
// and images in one heap must not share a page of bufferImageGranularity, so every placement in such a heap
// is rounded up to whole pages. If a page is larger than 4096 bytes (kMaxPadding), the padding would waste
// more than sharing saves; then buffers and images get separate heaps.
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "graph/memory/alias.h"
#include "graph/memory/alias_pack.h"
#include "graph/memory/alias_transitions.h"

namespace weft {
namespace {

constexpr uint64_t kMaxPadding = 4096;

uint64_t rounded_up(uint64_t bytes, uint64_t page_bytes) {
    return (bytes + page_bytes - 1) / page_bytes * page_bytes;
}

struct HeapKey {
    bool buffers = false;
    uint32_t type_bits = UINT32_MAX;
    bool operator<(const HeapKey& other) const {
        return std::tie(buffers, type_bits) < std::tie(other.buffers, other.type_bits);
    }
};

using Groups = std::map<HeapKey, std::vector<ResourceId>>;

Groups group_by_heap(const ResolvedGraph& graph, const Lifetimes& spans, const MemoryNeeds& needs,
                     bool keep_apart) {
    Groups groups;
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        if (spans.spans[id].first > spans.spans[id].last || needs[id].size_bytes == 0) continue;
        const bool buffers = keep_apart && graph.resources[id].kind == ResourceKind::buffer;
        groups[{buffers, needs[id].type_bits}].push_back(id);
    }
    return groups;
}

struct Peak {
    uint64_t bytes = 0;
    Position position = 0;
};

Peak find_peak(const std::vector<ResourceId>& resources, const Lifetimes& spans, const MemoryNeeds& needs) {
    // Key: schedule position. Value: bytes of the resources whose lifetime begins there, minus bytes of the
    // resources whose lifetime ended just before.
    std::map<Position, int64_t> changes;
    for (const ResourceId id : resources) {
        changes[spans.spans[id].first] += static_cast<int64_t>(needs[id].size_bytes);
        changes[Position(spans.spans[id].last + 1)] -= static_cast<int64_t>(needs[id].size_bytes);
    }
    Peak peak;
    int64_t bytes = 0;
    for (const auto& [position, change] : changes) {
        bytes += change;
        if (bytes > static_cast<int64_t>(peak.bytes)) peak = {static_cast<uint64_t>(bytes), position};
    }
    return peak;
}

bool has_both_kinds(const ResolvedGraph& graph, const std::vector<ResourceId>& group) {
    const auto is_buffer = [&](ResourceId id) { return graph.resources[id].kind == ResourceKind::buffer; };
    return std::any_of(group.begin(), group.end(), is_buffer) &&
           !std::all_of(group.begin(), group.end(), is_buffer);
}

// Returns true if every use of `a` is complete before the first use of `b` starts, according to the vector
// clocks of the queues.
bool over_before(const Schedule& order, const LifetimeSpan& a, const LifetimeSpan& b) {
    return std::all_of(b.queues.begin(), b.queues.end(), [&](const QueueSpan& later) {
        return std::all_of(a.queues.begin(), a.queues.end(), [&](const QueueSpan& earlier) {
            return order.clocks[later.first][earlier.queue] > earlier.last;
        });
    });
}

Unordered unordered_in(const std::vector<ResourceId>& group, const Schedule& order, const Lifetimes& spans) {
    if (order.queues.size() == 1) return {};
    return [&](uint32_t a, uint32_t b) {
        const LifetimeSpan &s = spans.spans[group[a]], &t = spans.spans[group[b]];
        return !over_before(order, s, t) && !over_before(order, t, s);
    };
}

void place_group(const std::vector<ResourceId>& group, const Schedule& order, const Lifetimes& spans,
                 const MemoryNeeds& needs, uint64_t page_bytes, HeapKey key, MemoryPlan& plan) {
    std::vector<PackItem> items;
    for (const ResourceId id : group)
        items.push_back({rounded_up(needs[id].size_bytes, page_bytes),
                         rounded_up(std::max<uint64_t>(needs[id].alignment_bytes, 1), page_bytes),
                         spans.spans[id].first, spans.spans[id].last});
    const Packing packing =
        pack(items, find_peak(group, spans, needs).bytes, unordered_in(group, order, spans));
    const auto heap = static_cast<uint32_t>(plan.heaps.size());
    plan.heaps.push_back({packing.height_bytes, key.type_bits, key.buffers, false});
    for (size_t i = 0; i < group.size(); ++i)
        plan.placements.push_back({group[i], heap, packing.offsets_bytes[i], needs[group[i]].size_bytes});
    plan.heap_bytes += packing.height_bytes;
}

// Places persistent resources one after another in heaps of their own, because they never share memory.
void place_persistent(const ResolvedGraph& graph, const LiveGraph& live, const MemoryNeeds& needs,
                      uint64_t granularity_bytes, MemoryPlan& plan) {
    std::map<HeapKey, uint32_t> heaps;
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        const bool wanted = graph.resources[id].lifetime == ResourceLifetime::persistent &&
                            live.live_resources[id] && needs[id].size_bytes != 0;
        if (!wanted) continue;
        const HeapKey key{false, needs[id].type_bits};
        const auto [it, fresh] = heaps.try_emplace(key, static_cast<uint32_t>(plan.heaps.size()));
        if (fresh) plan.heaps.push_back({0, key.type_bits, key.buffers, true});
        HeapPlan& heap = plan.heaps[it->second];
        const uint64_t alignment = std::max({needs[id].alignment_bytes, granularity_bytes, uint64_t{1}});
        const uint64_t offset = rounded_up(heap.size_bytes, alignment);
        plan.placements.push_back({id, it->second, offset, needs[id].size_bytes});
        heap.size_bytes = offset + needs[id].size_bytes;
    }
    for (const HeapPlan& heap : plan.heaps)
        if (heap.persistent) plan.persistent_bytes += heap.size_bytes;
}

}  // namespace

MemoryPlan alias(const ResolvedGraph& graph, const LiveGraph& live, const Schedule& order,
                 const Lifetimes& spans, const MemoryNeeds& needs, uint64_t granularity_bytes) {
    MemoryPlan plan;
    const Groups groups = group_by_heap(graph, spans, needs, granularity_bytes > kMaxPadding);
    std::vector<ResourceId> placed;
    for (const auto& [key, group] : groups) {
        const uint64_t page_bytes =
            has_both_kinds(graph, group) ? std::max<uint64_t>(granularity_bytes, 1) : 1;
        place_group(group, order, spans, needs, page_bytes, key, plan);
        placed.insert(placed.end(), group.begin(), group.end());
    }
    for (const ResourceId id : placed) plan.sum_bytes += needs[id].size_bytes;
    const Peak peak = find_peak(placed, spans, needs);
    plan.peak_live_bytes = peak.bytes;
    plan.peak_position = peak.position;
    plan.alias_transitions = alias_transitions(plan.placements, spans);
    place_persistent(graph, live, needs, granularity_bytes, plan);
    std::sort(plan.placements.begin(), plan.placements.end(), [](const Placement& a, const Placement& b) {
        return std::tie(a.heap, a.offset_bytes, a.resource) < std::tie(b.heap, b.offset_bytes, b.resource);
    });
    return plan;
}

}  // namespace weft
