#include "check/structure/check_structure.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "check/structure/check_areas.h"
#include "check/structure/check_buffer_views.h"
#include "check/structure/check_frame_slices.h"
#include "check/structure/check_groups.h"
#include "check/structure/check_indirect.h"
#include "check/structure/check_pieces.h"
#include "check/structure/check_rest_units.h"
#include "check/structure/check_scopes.h"
#include "check/structure/check_switches.h"
#include "check/structure/check_tables.h"
#include "check/structure/check_views.h"
#include "check/structure/memory_collisions.h"

namespace weft::check {
namespace {

constexpr const char* kCompilerFault = "this is an error of Weft, not of the graph: please report it";

bool check_shape(const FramePlan& plan, FaultList& faults) {
    const size_t passes = plan.graph.passes.size();
    bool ok = plan.schedule.order.size() == plan.barriers.steps.size() &&
              plan.live.live_passes.size() == passes &&
              plan.lifetimes.spans.size() == plan.graph.resources.size();
    std::vector<uint32_t> times(passes, 0);
    for (const PassId pass : plan.schedule.order) {
        ok = ok && pass < passes;
        if (pass < passes) ++times[pass];
    }
    for (size_t i = 0; ok && i < plan.schedule.order.size(); ++i)
        ok = plan.barriers.steps[i].pass == plan.schedule.order[i];
    if (!ok) {
        faults.add("C301", {}, "the tables of the plan do not match each other", kCompilerFault);
        return false;
    }
    for (PassId p(0); p < passes; ++p) {
        const uint32_t wanted = plan.live.live_passes[p] ? 1 : 0;
        if (times[p] != wanted)
            faults.add("C301", plan.graph.passes[p].loc,
                       "pass " + faults.pass_name(p) + " is recorded " + std::to_string(times[p]) +
                           " times, but should be " + std::to_string(wanted),
                       kCompilerFault);
    }
    return true;
}

// Index: EdgeKind.
constexpr std::array kEdgeTexts{
    "reads the result of the other pass", "overwrites content that the other pass reads",
    "overwrites content that the other pass writes", "names the other pass in \"after\""};
static_assert(kEdgeTexts.size() == static_cast<size_t>(EdgeKind::after) + 1);

void check_edges(const FramePlan& plan, FaultList& faults) {
    std::vector<Position> position(plan.graph.passes.size(), kNoId);
    for (Position i(0); i < plan.schedule.order.size(); ++i) position[plan.schedule.order[i]] = i;
    for (const EdgeDecl& edge : plan.graph.edges) {
        if (position[edge.from] == kNoId || position[edge.to] == kNoId) continue;
        if (position[edge.from] < position[edge.to]) continue;
        const std::string through =
            edge.resource == kNoId ? "" : " (" + faults.resource_name(edge.resource) + ")";
        faults.add("C302", edge.loc,
                   "pass " + faults.pass_name(edge.to) + " is recorded before pass " +
                       faults.pass_name(edge.from) + ", but " +
                       kEdgeTexts.at(static_cast<size_t>(edge.kind)) + through,
                   "the schedule must order the two passes the other way round");
    }
}

void check_lifetimes(const FramePlan& plan, FaultList& faults) {
    for (Position i(0); i < plan.schedule.order.size(); ++i) {
        const PassDecl& pass = plan.graph.passes[plan.schedule.order[i]];
        for (const UseDecl& use : pass.uses) {
            if (plan.graph.resources[use.resource].lifetime != ResourceLifetime::transient) continue;
            const LifetimeSpan& span = plan.lifetimes.spans[use.resource];
            if (span.first <= i && i <= span.last) continue;
            const auto at = [&](Position position) {
                return position < plan.schedule.order.size() ? faults.pass_name(plan.schedule.order[position])
                                                             : std::string("?");
            };
            faults.add("C342", use.loc,
                       "pass " + faults.pass_name(plan.schedule.order[i]) + " uses " +
                           faults.resource_name(use.resource) +
                           ", but this resource has memory only from pass " + at(span.first) + " to pass " +
                           at(span.last),
                       "the lifetime of a resource must cover all its uses");
        }
    }
}

// Returns the names of the first and last pass that use a resource. Messages about two resources in the same
// memory contain this text for each of the two.
std::string users(const FramePlan& plan, FaultList& faults, ResourceId resource) {
    const LifetimeSpan& span = plan.lifetimes.spans[resource];
    if (span.first > span.last || span.last >= plan.schedule.order.size()) return "unused";
    return "from pass " + faults.pass_name(plan.schedule.order[span.first]) + " to pass " +
           faults.pass_name(plan.schedule.order[span.last]);
}

// A resource with `"keep": "shared"` has a heap of its own, because other plans use the same memory.
void check_shared_heaps(const FramePlan& plan, FaultList& faults) {
    std::vector<uint32_t> tenants(plan.memory.heaps.size(), 0);
    for (const Placement& p : plan.memory.placements)
        if (p.heap < tenants.size()) ++tenants[p.heap];
    for (const Placement& p : plan.memory.placements) {
        if (p.heap >= tenants.size()) continue;
        const ResourceDecl& decl = plan.graph.resources[p.resource];
        const bool right = decl.shared ? tenants[p.heap] == 1 && p.offset_bytes == 0 && decl.history == 0 &&
                                             decl.lifetime == ResourceLifetime::persistent
                                       : true;
        if (!right || decl.shared != plan.memory.heaps[p.heap].shared)
            faults.add("C338", decl.loc,
                       faults.resource_name(p.resource) +
                           (decl.shared ? " is shared by all tiers, but has no heap of its own"
                                        : " is placed in the memory of a resource that all tiers share"),
                       kCompilerFault);
    }
}

void check_placements(const FramePlan& plan, FaultList& faults) {
    std::vector<uint8_t> placed(plan.graph.resources.size(), 0);
    const std::vector<Placement>& all = plan.memory.placements;
    const std::vector<std::pair<uint32_t, uint32_t>> pairs = memory_collisions(plan);
    size_t next = 0;
    for (size_t i = 0; i < all.size(); ++i) {
        const Placement& a = all[i];
        placed[a.resource] = 1;
        if (a.heap >= plan.memory.heaps.size() ||
            a.offset_bytes + a.size_bytes > plan.memory.heaps[a.heap].size_bytes)
            faults.add("C343", plan.graph.resources[a.resource].loc,
                       faults.resource_name(a.resource) + " lies outside its heap", kCompilerFault);
        for (; next < pairs.size() && pairs[next].first == i; ++next) {
            const Placement& b = all[pairs[next].second];
            faults.add("C340", plan.graph.resources[a.resource].loc,
                       faults.resource_name(a.resource) + " (" + users(plan, faults, a.resource) + ") and " +
                           faults.resource_name(b.resource) + " (" + users(plan, faults, b.resource) +
                           ") use the same memory at the same time",
                       "resources with overlapping lifetimes need separate memory");
        }
    }
    for (ResourceId id(0); id < placed.size(); ++id) {
        const LifetimeSpan& span = plan.lifetimes.spans[id];
        const bool needed =
            outlives_the_frame(plan, id)
                ? plan.live.live_resources[id] != 0
                : plan.graph.resources[id].lifetime != ResourceLifetime::imported && span.first <= span.last;
        if (needed && !placed[id])
            faults.add("C343", plan.graph.resources[id].loc,
                       faults.resource_name(id) + " has no place in memory", kCompilerFault);
    }
}

void check_alias_transitions(const FramePlan& plan, FaultList& faults) {
    const std::vector<AliasTransition>& listed = plan.memory.alias_transitions;
    // All alias transitions of the memory plan: the points at which the resource `to` takes over memory from
    // the resource `from`. Key: (from, to). Value: index into `listed`.
    std::multimap<std::pair<ResourceId, ResourceId>, size_t> known;
    for (size_t i = 0; i < listed.size(); ++i) known.emplace(std::pair(listed[i].from, listed[i].to), i);
    std::vector<uint8_t> used(listed.size(), 0);
    for (const PassStep& step : plan.barriers.steps) {
        for (const BarrierDecl& barrier : step.barriers) {
            for (const ResourceId from : barrier.aliased_from) {
                const auto [begin, end] = known.equal_range({from, barrier.resource});
                for (auto it = begin; it != end; ++it) used[it->second] = 1;
                if (begin != end) continue;
                faults.add("C341", plan.graph.resources[barrier.resource].loc,
                           "the barrier before pass " + faults.pass_name(step.pass) + " moves memory of " +
                               faults.resource_name(from) + " (" + users(plan, faults, from) + ") to " +
                               faults.resource_name(barrier.resource) +
                               ", but the memory plan does not contain this alias transition",
                           "the memory plan must list every alias transition");
            }
        }
    }
    for (size_t i = 0; i < listed.size(); ++i) {
        if (used[i]) continue;
        const LifetimeSpan& to = plan.lifetimes.spans[listed[i].to];
        faults.add(
            "C341", plan.graph.resources[listed[i].to].loc,
            faults.resource_name(listed[i].to) + " (" + users(plan, faults, listed[i].to) +
                ") takes over the memory of " + faults.resource_name(listed[i].from) + " (" +
                users(plan, faults, listed[i].from) + "), but no barrier before pass " +
                faults.pass_name(to.first < plan.schedule.order.size() ? plan.schedule.order[to.first]
                                                                       : kNoId) +
                " waits for the end of the earlier uses",
            "the first use of a resource needs a barrier that names the previous resource in its memory");
    }
}

void check_submissions(const FramePlan& plan, FaultList& faults) {
    const size_t count = plan.schedule.order.size();
    std::vector<uint32_t> times(count, 0);
    std::vector<uint32_t> last(plan.schedule.queues.size(), 0);
    uint32_t epilogues = 0;
    bool ok = plan.schedule.queue.size() == count && !plan.schedule.queues.empty();
    for (const Batch& batch : plan.submissions.batches) {
        ok = ok && batch.queue < plan.schedule.queues.size();
        epilogues += batch.epilogue ? 1 : 0;
        for (const Position position : batch.positions) {
            ok = ok && position < count && plan.schedule.queue[position] == batch.queue &&
                 position + 1 > last[batch.queue];
            if (!ok) break;
            ++times[position];
            last[batch.queue] = position + 1;
        }
        ok = ok && (!batch.epilogue || batch.queue == 0);
    }
    ok = ok && epilogues == 1 && std::all_of(times.begin(), times.end(), [](uint32_t n) { return n == 1; });
    if (!ok)
        faults.add("C303", {},
                   "the submissions do not contain each pass once, in order and on its own queue, and the "
                   "end of the "
                   "frame on the first queue",
                   kCompilerFault);
}

constexpr StageMask kTransferStages = stage::kCopy | stage::kHost;
constexpr StageMask kComputeStages =
    kTransferStages | stage::kClear | stage::kDrawIndirect | stage::kComputeShader;

// Checks that each queue supports all stages that its passes and barriers use.
void check_stages(const FramePlan& plan, FaultList& faults) {
    for (Position position(0); position < plan.barriers.steps.size(); ++position) {
        const QueueKind kind = plan.schedule.queues[plan.schedule.queue[position]].kind;
        if (kind == QueueKind::graphics) continue;
        const StageMask offered = kind == QueueKind::compute ? kComputeStages : kTransferStages;
        const PassStep& step = plan.barriers.steps[position];
        StageMask used = 0;
        for (const std::vector<BarrierDecl>* list : {&step.barriers, &step.after})
            for (const BarrierDecl& barrier : *list) used |= barrier.src.stages | barrier.dst.stages;
        for (const UseDecl& use : plan.graph.passes[step.pass].uses) used |= use.state.stages;
        if ((used & ~offered) == 0) continue;
        faults.add("C304", plan.graph.passes[step.pass].loc,
                   "pass " + faults.pass_name(step.pass) + " needs " + stages_text(used & ~offered) +
                       " on queue " + std::to_string(plan.schedule.queue[position]) +
                       ", which does not support these stages",
                   kCompilerFault);
    }
}

// Checks that the barriers of ownership transfers come in pairs (release and acquire) with the same queue
// families, layouts and range. Vulkan requires the same parameters in both halves.
void check_transfers(const FramePlan& plan, FaultList& faults) {
    std::vector<const BarrierDecl*> halves;
    for (const PassStep& step : plan.barriers.steps)
        for (const std::vector<BarrierDecl>* list : {&step.barriers, &step.after})
            for (const BarrierDecl& barrier : *list)
                if (barrier.src_family != barrier.dst_family) halves.push_back(&barrier);
    const auto key = [](const BarrierDecl* half) {
        const SubresourceRange& r = half->range;
        return std::tuple(half->resource, half->src_family, half->dst_family, half->src.layout,
                          half->dst.layout, r.mip, r.mips, r.layer, r.layers, r.aspects);
    };
    // Key: the parameters of one half of an ownership transfer. Value: the number of barriers with these
    // parameters.
    std::map<decltype(key(nullptr)), size_t> same;
    for (const BarrierDecl* half : halves) ++same[key(half)];
    for (const BarrierDecl* half : halves) {
        if (same[key(half)] % 2 == 0) continue;
        faults.add("C360", plan.graph.resources[half->resource].loc,
                   faults.part_name(half->resource, half->range) + " goes from queue family " +
                       std::to_string(half->src_family) + " to " + std::to_string(half->dst_family) +
                       ", but the plan has no matching second half of this ownership transfer",
                   kCompilerFault);
    }
}

void check_boundary(const FramePlan& plan, FaultList& faults) {
    for (const BoundaryState& boundary : plan.boundary) {
        const ResourceDecl& resource = plan.graph.resources[boundary.resource];
        if (!resource.import || boundary.state.layout == resource.import->exit.layout) continue;
        faults.add("C350", resource.loc,
                   faults.resource_name(boundary.resource) + " returns to the program in layout " +
                       layout_text(boundary.state.layout) + ", but the program expects layout " +
                       layout_text(resource.import->exit.layout),
                   kCompilerFault);
    }
}

}  // namespace

bool check_structure(const FramePlan& plan, FaultList& faults) {
    if (!check_shape(plan, faults)) return false;
    check_pieces(plan, faults);
    if (faults.any("C344")) return false;
    check_indirect(plan, faults);
    check_views(plan, faults);
    check_buffer_views(plan, faults);
    check_tables(plan, faults);
    check_edges(plan, faults);
    check_lifetimes(plan, faults);
    check_placements(plan, faults);
    check_shared_heaps(plan, faults);
    check_alias_transitions(plan, faults);
    check_boundary(plan, faults);
    check_submissions(plan, faults);
    if (faults.any("C303")) return false;
    check_scopes(plan, faults);
    check_areas(plan, faults);
    check_transfers(plan, faults);
    check_stages(plan, faults);
    check_frame_slices(plan, faults);
    check_switches(plan, faults);
    if (faults.any("C349")) return false;
    check_rest_units(plan, faults);
    check_groups(plan, faults);
    return true;
}

}  // namespace weft::check
