#include "weft/compile.h"

#include <utility>

#include "graph/compile/link.h"
#include "graph/compile/stage_timer.h"
#include "graph/memory/alias.h"
#include "graph/resolve/cull.h"
#include "graph/schedule/attachment_ops.h"
#include "graph/schedule/lifetimes.h"
#include "graph/schedule/schedule.h"
#include "graph/sync/barriers.h"
#include "graph/sync/group_blocks.h"
#include "graph/sync/submissions.h"
#include "graph/sync/synchronize.h"

namespace weft {
namespace {

std::vector<QueueDependency> all_dependencies(const ResolvedGraph& graph, const Schedule& order,
                                              const SyncTable& sync, const BarrierResult& recorded) {
    std::vector<QueueDependency> all = sync.dependencies;
    all.insert(all.end(), recorded.memory_dependencies.begin(), recorded.memory_dependencies.end());
    if (graph.groups.empty() || all.empty()) return all;
    return outside_blocks(group_blocks(graph, order), std::move(all));
}

}  // namespace

FramePlan compile(ResolvedGraph graph, const MemoryNeeds& needs, const CompileOptions& options,
                  std::vector<StageTime>* times) {
    StageTimer timer(times);
    LiveGraph live = timer.stage("cull", cull(graph, options.keep_all_passes, options.retained));
    Schedule order = timer.stage("schedule", schedule(graph, live, needs, options.queues));
    const AttachmentTable ops = timer.stage("attachment_ops", attachment_ops(graph, live, order));
    ScopeTable scopes = timer.stage("find_scopes", find_scopes(graph, order, ops));
    SyncTable sync = timer.stage("synchronize", synchronize(graph, live, order, ops, std::move(scopes)));
    order = timer.stage("add_clocks", add_clocks(std::move(order), sync.dependencies));
    Lifetimes spans = timer.stage("lifetimes", lifetimes(graph, live, order));
    MemoryPlan memory =
        timer.stage("alias", alias(graph, live, order, spans, needs, options.granularity_bytes));
    BarrierResult recorded = timer.stage("barriers", barriers(graph, order, sync, memory, ops));
    SubmissionPlan submitted =
        timer.stage("submissions", submissions(order, all_dependencies(graph, order, sync, recorded)));
    // A rendering scope cannot continue in another batch. So the barriers and batches are computed again
    // without the scopes that a batch boundary divides. The waits between queues stay the same.
    if (ScopeTable kept = within_batches(sync.scopes, submitted); kept != sync.scopes) {
        sync = synchronize(graph, live, order, ops, std::move(kept));
        recorded = barriers(graph, order, sync, memory, ops);
        submitted = submissions(order, all_dependencies(graph, order, sync, recorded));
    }
    return timer.stage("link", link({.graph = std::move(graph),
                                     .live = std::move(live),
                                     .schedule = std::move(order),
                                     .sync = std::move(sync),
                                     .lifetimes = std::move(spans),
                                     .memory = std::move(memory),
                                     .barriers = std::move(recorded.plan),
                                     .submissions = std::move(submitted)}));
}

CompileOptions compile_options(const DeviceProfile& profile, uint32_t queue_count) {
    return {.granularity_bytes = profile.buffer_image_granularity_bytes,
            .queues = logical_queues(profile, queue_count)};
}

MemoryNeeds content_needs(const ResolvedGraph& graph, uint64_t alignment_bytes) {
    MemoryNeeds needs(graph.resources.size());
    for (ResourceId id(0); id < graph.resources.size(); ++id)
        if (graph.resources[id].lifetime != ResourceLifetime::imported)
            needs[id] = {content_bytes(graph.resources[id]), alignment_bytes, UINT32_MAX};
    return needs;
}

}  // namespace weft
