#include "graph/sync/skipped_reads.h"

#include "graph/model/rows.h"

namespace weft {
namespace {

bool may_be_skipped(const PassDecl& pass, const UseDecl& use) {
    return (pass.switch_id != kNoId || use.used_in != kEveryCombination) && reads(use.access);
}

// Returns the resource itself or, for one of the copies of a resource with history, the copy of age 0. All
// copies count as one resource here, because they change places from frame to frame.
ResourceId whole_ring(const ResolvedGraph& graph, ResourceId resource) {
    const ResourceId ring = graph.resources[resource].ring;
    return ring == kNoId ? resource : ring;
}

// Returns the states of all reads that do not happen in some combinations of the switches. Index:
// whole_ring() of the resource.
Rows<AccessState> skipped_reads(const ResolvedGraph& graph, const BarrierPlan& plan) {
    return make_rows<AccessState>(graph.resources.size(), [&](const auto& add) {
        for (const PassStep& step : plan.steps)
            for (const UseDecl& use : graph.passes[step.pass].uses)
                if (may_be_skipped(graph.passes[step.pass], use))
                    add(whole_ring(graph, use.resource), use.state);
    });
}

class ReadNamer {
 public:
    ReadNamer(const ResolvedGraph& graph, const BarrierPlan& plan)
        : graph_(graph), reads_(skipped_reads(graph, plan)) {}

    void name(std::vector<BarrierDecl>& barriers) const {
        for (BarrierDecl& barrier : barriers) {
            name_reads_of(barrier.resource, barrier);
            for (const ResourceId from : barrier.aliased_from) name_reads_of(from, barrier);
        }
    }

 private:
    void name_reads_of(ResourceId resource, BarrierDecl& barrier) const {
        if (barrier.reason == BarrierReason::acquire_queue) return;
        for (const AccessState& read : reads_[whole_ring(graph_, resource)])
            if ((read.stages & barrier.src.stages) != 0)
                barrier.src.access |= read.access & ~access::kAllWrites;
    }

    const ResolvedGraph& graph_;
    Rows<AccessState> reads_;
};

}  // namespace

void name_skipped_reads(const ResolvedGraph& graph, BarrierPlan& plan) {
    if (graph.switches.empty()) return;
    const ReadNamer namer(graph, plan);
    for (PassStep& step : plan.steps) {
        namer.name(step.barriers);
        namer.name(step.after);
    }
    namer.name(plan.epilogue);
}

}  // namespace weft
