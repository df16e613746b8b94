// Places transient and persistent resources in heaps. Transient resources with the same allowed memory types
// share a heap. Buffers and images in one heap must not share a page of bufferImageGranularity, so every
// placement in such a heap is rounded up to whole pages. If a page is larger than 4096 bytes (kMaxPadding),
// the padding may waste more than sharing saves; then buffers and images get separate heaps. Persistent
// resources get other heaps: see place_persistent().
#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "graph/memory/alias.h"
#include "graph/memory/alias_pack.h"
#include "graph/memory/alias_times.h"
#include "graph/memory/alias_transitions.h"
#include "graph/model/round_up.h"

namespace weft {
namespace {

constexpr uint64_t kMaxPadding = 4096;

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

bool has_both_kinds(const ResolvedGraph& graph, const std::vector<ResourceId>& group) {
    const auto is_buffer = [&](ResourceId id) { return graph.resources[id].kind == ResourceKind::buffer; };
    return std::any_of(group.begin(), group.end(), is_buffer) &&
           !std::all_of(group.begin(), group.end(), is_buffer);
}

// Returns the items to pack, in the order of `group`. Their sizes are whole pages.
std::vector<PackItem> items_of(const std::vector<ResourceId>& group, const Lifetimes& spans,
                               const MemoryNeeds& needs, uint64_t page_bytes) {
    std::vector<PackItem> items;
    items.reserve(group.size());
    for (const ResourceId id : group)
        items.push_back({round_up(needs[id].size_bytes, page_bytes),
                         round_up(std::max<uint64_t>(needs[id].alignment_bytes, 1), page_bytes),
                         spans.spans[id].first, spans.spans[id].last});
    return items;
}

// Returns the largest total size of resources that are alive at the same time, without padding.
Peak peak_of(const std::vector<ResourceId>& resources, const Lifetimes& spans, const MemoryNeeds& needs) {
    return find_peak(resources.size(), [&](size_t i) {
        const ResourceId id = resources[i];
        return PackItem{needs[id].size_bytes, 1, spans.spans[id].first, spans.spans[id].last};
    });
}

// `queues` is null if the frame uses one queue.
Packing pack_group(const std::vector<ResourceId>& group, const QueueOrder* queues, const Lifetimes& spans,
                   std::vector<PackItem> items, uint64_t lower_bound_bytes) {
    if (queues == nullptr) return pack(items, lower_bound_bytes);
    const QueueTimes times = queues->times(group, spans);
    for (uint32_t i = 0; i < items.size(); ++i)
        items[i].last = std::max(items[i].last, times.last_position(i));
    return pack(items, lower_bound_bytes, &times);
}

// Adds a heap with the resources of the group to the plan. The placements are sorted by (offset, resource).
void add_heap(const std::vector<ResourceId>& group, const Packing& packing, const MemoryNeeds& needs,
              HeapKey key, MemoryPlan& plan) {
    const auto heap = static_cast<uint32_t>(plan.heaps.size());
    plan.heaps.push_back({packing.height_bytes, key.type_bits, key.buffers, false});
    std::vector<std::pair<uint64_t, uint32_t>> by_offset;
    by_offset.reserve(group.size());
    for (uint32_t i = 0; i < group.size(); ++i) by_offset.emplace_back(packing.offsets_bytes[i], i);
    std::ranges::sort(by_offset);
    for (const auto& [offset, i] : by_offset)
        plan.placements.push_back({group[i], heap, offset, needs[group[i]].size_bytes});
    plan.heap_bytes += packing.height_bytes;
}

// Places persistent resources one after another in heaps of their own, because they never share memory. Each
// resource with `"keep": "shared"` has a heap of its own.
void place_persistent(const ResolvedGraph& graph, const LiveGraph& live, const MemoryNeeds& needs,
                      uint64_t granularity_bytes, MemoryPlan& plan) {
    std::map<HeapKey, uint32_t> heaps;
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        const bool wanted = graph.resources[id].lifetime == ResourceLifetime::persistent &&
                            live.live_resources[id] && needs[id].size_bytes != 0;
        if (!wanted) continue;
        const HeapKey key{false, needs[id].type_bits};
        if (graph.resources[id].shared) {
            plan.placements.push_back(
                {id, static_cast<uint32_t>(plan.heaps.size()), 0, needs[id].size_bytes});
            plan.heaps.push_back({needs[id].size_bytes, key.type_bits, false, true, true});
            continue;
        }
        const auto [it, fresh] = heaps.try_emplace(key, static_cast<uint32_t>(plan.heaps.size()));
        if (fresh) plan.heaps.push_back({0, key.type_bits, key.buffers, true});
        HeapPlan& heap = plan.heaps[it->second];
        const uint64_t alignment = std::max({needs[id].alignment_bytes, granularity_bytes, uint64_t{1}});
        const uint64_t offset = round_up(heap.size_bytes, alignment);
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
    const std::optional<QueueOrder> queues =
        order.queues.size() > 1 ? std::optional<QueueOrder>(order) : std::nullopt;
    std::vector<ResourceId> placed;
    Peak peak;
    plan.placements.reserve(graph.resources.size());
    for (const auto& [key, group] : groups) {
        const uint64_t page_bytes =
            has_both_kinds(graph, group) ? std::max<uint64_t>(granularity_bytes, 1) : 1;
        peak = peak_of(group, spans, needs);
        const Packing packing = pack_group(group, queues ? &*queues : nullptr, spans,
                                           items_of(group, spans, needs, page_bytes), peak.bytes);
        add_heap(group, packing, needs, key, plan);
        placed.insert(placed.end(), group.begin(), group.end());
    }
    for (const ResourceId id : placed) plan.sum_bytes += needs[id].size_bytes;
    if (groups.size() > 1) peak = peak_of(placed, spans, needs);
    plan.peak_live_bytes = peak.bytes;
    plan.peak_position = peak.position;
    plan.alias_transitions = alias_transitions(plan.placements, spans);
    const auto transient_count = static_cast<std::ptrdiff_t>(plan.placements.size());
    place_persistent(graph, live, needs, granularity_bytes, plan);
    const auto first_persistent = plan.placements.begin() + transient_count;
    std::sort(first_persistent, plan.placements.end(), [](const Placement& a, const Placement& b) {
        return std::tie(a.heap, a.offset_bytes, a.resource) < std::tie(b.heap, b.offset_bytes, b.resource);
    });
    return plan;
}

}  // namespace weft
