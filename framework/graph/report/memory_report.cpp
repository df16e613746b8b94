#include "weft/report/memory_report.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "graph/diagnostics/quantity_text.h"

namespace weft {
namespace {

constexpr size_t kNamedAtPeak = 3;  // A message about memory names at most this many resources.

// Returns the index of the memory type that an executor would choose: the first type that the plan allows for
// the heap. Returns nothing if the device profile lacks that type.
std::optional<uint32_t> memory_type(const HeapPlan& heap, const DeviceProfile& profile) {
    const auto type = static_cast<uint32_t>(std::countr_zero(heap.type_bits));
    return type < profile.memory_types.size() ? std::optional(type) : std::nullopt;
}

std::string type_text(const HeapPlan& heap, const DeviceProfile& profile) {
    const std::optional<uint32_t> type = memory_type(heap, profile);
    if (!type) return "";
    const MemoryTypeProfile& t = profile.memory_types[*type];
    return "  memory type " + std::to_string(*type) + (t.device_local ? ", device-local" : ", host memory") +
           (t.lazily_allocated ? ", lazily allocated: may use no real memory" : "");
}

std::string heap_text(const FramePlan& plan, uint32_t heap, const DeviceProfile* profile) {
    const HeapPlan& h = plan.memory.heaps[heap];
    std::string text = "    heap " + std::to_string(heap) + (h.buffers ? " (buffers) " : " ") +
                       (h.shared       ? "(shared by all tiers) "
                        : h.persistent ? "(kept from frame to frame) "
                                       : "") +
                       bytes_text(h.size_bytes);
    if (profile != nullptr) text += type_text(h, *profile);
    return text + "\n";
}

std::string placement_text(const FramePlan& plan, const Placement& p) {
    const auto name = [&](ResourceId id) { return plan.graph.resources[id].name; };
    std::string text = "        " + std::to_string(p.offset_bytes) + " + " + std::to_string(p.size_bytes) +
                       "  " + name(p.resource);
    const LifetimeSpan& span = plan.lifetimes.spans[p.resource];
    if (span.first <= span.last)
        text += "  [" + std::to_string(span.first) + ".." + std::to_string(span.last) + "]";
    std::string owners;
    for (const AliasTransition& h : plan.memory.alias_transitions)
        if (h.to == p.resource && h.from != h.to)
            owners += (owners.empty() ? "  reuses memory of " : ", ") + name(h.from) +
                      (h.wrap ? " of the previous frame" : "");
    return text + owners + "\n";
}

std::string peak_text(const FramePlan& plan) {
    const MemoryPlan& m = plan.memory;
    std::string text = "    peak of " + bytes_text(m.peak_live_bytes);
    if (m.peak_position < plan.schedule.order.size())
        text += " at " + std::to_string(m.peak_position) + " " +
                plan.graph.passes[plan.schedule.order[m.peak_position]].name;
    text += ":";
    for (const ResourceId id : live_at_peak(plan))
        text += " " + plan.graph.resources[id].name + " (" + bytes_text(placed_bytes(plan, id)) + ")";
    return text + "\n";
}

std::string largest_at_peak(const FramePlan& plan) {
    std::vector<ResourceId> live = live_at_peak(plan);
    live.resize(std::min(live.size(), kNamedAtPeak));
    std::string text;
    for (const ResourceId id : live)
        text += (text.empty() ? "" : ", ") + plan.graph.resources[id].name + " " +
                bytes_text(placed_bytes(plan, id));
    return text;
}

// Creates a diagnostic about memory. Its source location is the declaration of the largest resource that is
// alive at the memory peak.
Diagnostic memory_fault(const FramePlan& plan, const std::string& file, std::string code,
                        std::string message) {
    const std::vector<ResourceId> live = live_at_peak(plan);
    const SourceLoc loc = live.empty() ? SourceLoc{} : plan.graph.resources[live.front()].loc;
    Diagnostic d = plan.graph.sources.error(loc, std::move(code), std::move(message));
    if (d.line == 0) d.file = file;
    return d;
}

}  // namespace

uint64_t placed_bytes(const FramePlan& plan, ResourceId resource) {
    const auto it = std::find_if(plan.memory.placements.begin(), plan.memory.placements.end(),
                                 [resource](const Placement& p) { return p.resource == resource; });
    return it == plan.memory.placements.end() ? 0 : it->size_bytes;
}

std::vector<ResourceId> live_at_peak(const FramePlan& plan) {
    std::vector<const Placement*> placed;
    for (const Placement& p : plan.memory.placements) {
        const LifetimeSpan& span = plan.lifetimes.spans[p.resource];
        if (span.first <= plan.memory.peak_position && plan.memory.peak_position <= span.last)
            placed.push_back(&p);
    }
    std::sort(placed.begin(), placed.end(), [](const Placement* a, const Placement* b) {
        return a->size_bytes != b->size_bytes ? a->size_bytes > b->size_bytes : a->resource < b->resource;
    });
    std::vector<ResourceId> live;
    for (const Placement* p : placed) live.push_back(p->resource);
    return live;
}

std::string memory_report(const FramePlan& plan, const DeviceProfile* profile) {
    const MemoryPlan& m = plan.memory;
    const uint64_t gap = m.heap_bytes > m.peak_live_bytes ? m.heap_bytes - m.peak_live_bytes : 0;
    std::string text = "    sum of resources " + bytes_text(m.sum_bytes) + ", peak of live resources " +
                       bytes_text(m.peak_live_bytes) + ", heaps " + bytes_text(m.heap_bytes) +
                       ", excess of the heaps over the peak " + percent_text(gap, m.peak_live_bytes);
    if (m.persistent_bytes > 0) text += ", kept from frame to frame " + bytes_text(m.persistent_bytes);
    text += "\n";
    if (m.peak_live_bytes > 0) text += peak_text(plan);
    for (uint32_t heap = 0; heap < m.heaps.size(); ++heap) {
        text += heap_text(plan, heap, profile);
        for (const Placement& p : m.placements)
            if (p.heap == heap) text += placement_text(plan, p);
    }
    return text;
}

Diagnostics memory_faults(const FramePlan& plan, const DeviceProfile& profile, const std::string& file) {
    std::vector<uint64_t> wanted(profile.memory_heaps.size(), 0);
    for (const HeapPlan& heap : plan.memory.heaps) {
        const std::optional<uint32_t> type = memory_type(heap, profile);
        if (type && !profile.memory_types[*type].lazily_allocated)
            wanted[profile.memory_types[*type].heap] += heap.size_bytes;
    }
    Diagnostics faults;
    for (size_t i = 0; i < wanted.size(); ++i) {
        const uint64_t room = profile.memory_heaps[i].size_bytes;
        if (wanted[i] <= room) continue;
        Diagnostic d =
            memory_fault(plan, file, "W142",
                         "the plan needs " + bytes_text(wanted[i]) + " of memory heap " + std::to_string(i) +
                             " of \"" + profile.name + "\", which has only " + bytes_text(room));
        d.severity = Severity::warning;
        d.help = {"use a smaller --size or smaller formats; the largest resources at the peak are " +
                  largest_at_peak(plan)};
        faults.push_back(std::move(d));
    }
    return faults;
}

Diagnostics budget_faults(const FramePlan& plan, const GraphLimits& limits, const std::string& file) {
    const uint64_t wanted = plan.memory.heap_bytes + plan.memory.persistent_bytes;
    if (wanted <= limits.transient_bytes) return {};
    Diagnostic d = memory_fault(plan, file, "W143",
                                "the resources of the frame need " + bytes_text(wanted) +
                                    " of memory; the limit is " + limit_bytes_text(limits.transient_bytes));
    d.help = {"use a smaller --size or smaller formats, " + raise_limit_text("graph.transientBytes") +
              "; the largest resources at the peak are " + largest_at_peak(plan)};
    return {std::move(d)};
}

}  // namespace weft
