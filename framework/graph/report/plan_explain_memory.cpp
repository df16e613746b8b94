// Answers the questions `weft explain FILE alias A B` (do two resources share memory?) and `weft explain FILE
// resource R` (what is this resource?).
#include <algorithm>

#include "graph/diagnostics/quantity_text.h"
#include "graph/plan/plan_names.h"
#include "graph/report/explain_phrases.h"
#include "graph/report/live_phrases.h"
#include "graph/report/plan_phrases.h"
#include "weft/report/plan_explain.h"

namespace weft {
namespace {

const Placement* placement_of(const FramePlan& plan, ResourceId resource) {
    const auto it = std::find_if(plan.memory.placements.begin(), plan.memory.placements.end(),
                                 [resource](const Placement& p) { return p.resource == resource; });
    return it == plan.memory.placements.end() ? nullptr : &*it;
}

std::string describe_lifetime(const FramePlan& plan, ResourceId resource) {
    const LifetimeSpan& span = plan.lifetimes.spans[resource];
    return "from " + describe_position(plan, span.first) + " to " + describe_position(plan, span.last);
}

std::string describe_bytes(const Placement& p) {
    return "bytes " + std::to_string(p.offset_bytes) + " to " +
           std::to_string(p.offset_bytes + p.size_bytes - 1) + " of heap " + std::to_string(p.heap);
}

bool overlap_in_memory(const Placement& a, const Placement& b) {
    return a.heap == b.heap && a.offset_bytes < b.offset_bytes + b.size_bytes &&
           b.offset_bytes < a.offset_bytes + a.size_bytes;
}

// Returns the reason why a resource never shares memory, such as being an import. Returns an empty text if it
// may share memory.
std::string describe_unshared(const FramePlan& plan, ResourceId resource) {
    const std::string name = describe_resource(plan, resource);
    if (!plan.live.live_resources[resource])
        return name + " has no memory, because no running pass uses this resource.\n";
    if (!plan.graph.resources[resource].texture_files.empty())
        return name + " is a table of pictures from files, which Weft loads before the first frame.\n";
    if (plan.graph.resources[resource].lifetime == ResourceLifetime::imported)
        return name + " is an import: the program outside the graph provides its memory.\n";
    if (plan.graph.resources[resource].lifetime == ResourceLifetime::persistent)
        return name + " keeps its content from frame to frame, so its memory is never shared.\n";
    return placement_of(plan, resource) == nullptr ? name + " needs no memory.\n" : "";
}

}  // namespace

std::string describe_alias_transitions(const FramePlan& plan, ResourceId a, ResourceId b) {
    std::string text;
    for (const AliasTransition& h : plan.memory.alias_transitions)
        if ((h.from == a && h.to == b) || (h.from == b && h.to == a))
            text += "  " + describe_resource(plan, h.to) + " takes over the memory from " +
                    describe_resource(plan, h.from) + (h.wrap ? " of the previous frame" : "") + ", at " +
                    describe_position(plan, plan.lifetimes.spans[h.to].first) + ".\n";
    return text.empty() ? "  A third resource uses the memory in between.\n" : text;
}

namespace {

std::string describe_overlap(const FramePlan& plan, ResourceId a, ResourceId b) {
    const LifetimeSpan &s = plan.lifetimes.spans[a], &t = plan.lifetimes.spans[b];
    const Position first = std::max(s.first, t.first), last = std::min(s.last, t.last);
    if (first <= last)
        return "  Both are alive from " + describe_position(plan, first) + " to " +
               describe_position(plan, last) + ".\n";
    if (plan.schedule.queues.size() > 1 &&
        (s.queues.size() > 1 || t.queues.size() > 1 || s.queues.front().queue != t.queues.front().queue))
        return "  Several queues use these resources. Then they can share memory only if all uses of one "
               "certainly "
               "end before the uses of the other begin. Even then, packing may place them apart.\n";
    return "  Their lifetimes would allow sharing, but the packing with the least memory placed them side by "
           "side.\n";
}

std::string describe_heap(const FramePlan& plan, const Placement& a, const Placement& b) {
    const HeapPlan &x = plan.memory.heaps[a.heap], &y = plan.memory.heaps[b.heap];
    if (x.buffers != y.buffers)
        return "  Buffers and images have separate heaps, because padding to the granularity of this device "
               "would waste more memory than sharing saves.\n";
    return x.type_bits != y.type_bits ? "  They need different types of memory.\n"
                                      : "  They are in different heaps.\n";
}

std::string describe_shape(const ResourceDecl& r) {
    if (r.textures > 0) return "a table of " + count_text(r.textures, "texture");
    if (r.kind == ResourceKind::buffer)
        return "a buffer of " + bytes_text(r.size_bytes) +
               (r.stride_bytes > 0 ? ", stride " + std::to_string(r.stride_bytes) : "");
    std::string text = "an image, " + std::string(format_info(r.format).name) + ", " +
                       std::to_string(r.extent.width) + "x" + std::to_string(r.extent.height);
    if (r.extent.depth > 1) text += "x" + std::to_string(r.extent.depth);
    if (r.mips > 1) text += ", " + count_text(r.mips, "mip");
    if (r.layers > 1) text += ", " + count_text(r.layers, "layer");
    if (r.samples > 1) text += ", " + count_text(r.samples, "sample");
    return text + " (" + enum_name(r.image_kind) + ")";
}

std::string describe_ring(const FramePlan& plan, const ResourceDecl& r) {
    if (r.lifetime != ResourceLifetime::persistent) return "";
    if (r.age > 0)
        return "  It is the content of " + describe_resource(plan, r.ring) + " from " +
               count_text(r.age, "frame") + " ago.\n";
    return r.history > 0
               ? "  It keeps " + count_text(r.history, "earlier frame") + ", each in separate memory.\n"
               : "  It keeps its content from frame to frame.\n";
}

std::string describe_memory(const FramePlan& plan, ResourceId id) {
    const Placement* own = placement_of(plan, id);
    if (own == nullptr) return "  " + describe_unshared(plan, id);
    std::string text = "  It needs " + bytes_text(own->size_bytes) + ": " + describe_bytes(*own) + ".\n";
    if (plan.lifetimes.spans[id].first > plan.lifetimes.spans[id].last) return text;
    text += "  It is alive " + describe_lifetime(plan, id) + ".\n";
    std::string others;
    for (const Placement& p : plan.memory.placements)
        if (p.resource != id && overlap_in_memory(p, *own))
            others += (others.empty() ? "" : ", ") + describe_resource(plan, p.resource);
    return text + (others.empty() ? "  No other resource shares this memory.\n"
                                  : "  It shares memory with " + others + ".\n");
}

std::string describe_users(const FramePlan& plan, ResourceId id) {
    std::string text;
    const auto add_uses = [&](PassId pass, const std::string& place) {
        for (const UseDecl& use : plan.graph.passes[pass].uses)
            if (use.resource == id)
                text +=
                    "  " + place + ": " + describe_use(plan, use) + " (" + access_name(use.access) + ").\n";
    };
    const std::vector<PassId>& order = plan.schedule.order;
    for (Position p(0); p < order.size(); ++p) add_uses(order[p], describe_position(plan, p));
    for (PassId pass(0); pass < plan.graph.passes.size(); ++pass)
        if (!plan.live.live_passes[pass]) add_uses(pass, "culled, \"" + plan.graph.passes[pass].name + "\"");
    return text.empty() ? "  No pass uses this resource.\n" : text;
}

}  // namespace

Result<std::string> explain_alias(const FramePlan& plan, const std::string& first,
                                  const std::string& second) {
    Result<std::pair<ResourceId, ResourceId>> found =
        both(named_resource(plan, first), named_resource(plan, second));
    if (!found) return found.take_errors();
    const auto [a, b] = *found;
    if (const std::string alone = describe_unshared(plan, a) + (a == b ? "" : describe_unshared(plan, b));
        !alone.empty())
        return "They share no memory.\n  " + alone;
    const Placement &p = *placement_of(plan, a), &q = *placement_of(plan, b);
    const std::string where = "  " + describe_resource(plan, a) + " has " + describe_bytes(p) +
                              " and is alive " + describe_lifetime(plan, a) + ".\n  " +
                              describe_resource(plan, b) + " has " + describe_bytes(q) + " and is alive " +
                              describe_lifetime(plan, b) + ".\n";
    if (a == b) return "Both names mean the same resource.\n" + where;
    if (overlap_in_memory(p, q))
        return "They share memory.\n" + where + describe_alias_transitions(plan, a, b);
    return "They share no memory.\n" + where +
           (p.heap != q.heap ? describe_heap(plan, p, q) : describe_overlap(plan, a, b));
}

Result<std::string> explain_resource(const FramePlan& plan, const std::string& name) {
    Result<std::vector<ResourceId>> resources = named_resources(plan, name);
    if (!resources) return resources.take_errors();
    std::string text;
    for (const ResourceId id : *resources) {
        const ResourceDecl& r = plan.graph.resources[id];
        text += describe_resource(plan, id) + " is " + describe_shape(r) + ", " + enum_name(r.lifetime) +
                ".\n" +
                (r.area == kNoId
                     ? ""
                     : "  The area that passes use in a frame: " + describe_area(plan.graph, r) + ".\n") +
                describe_ring(plan, r) + describe_memory(plan, id) + describe_users(plan, id);
    }
    return text;
}

}  // namespace weft
