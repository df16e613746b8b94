#include "weft/compile.h"

#include <functional>
#include <utility>

#include "graph/compile/link.h"
#include "graph/memory/alias.h"
#include "graph/schedule/attachment_ops.h"
#include "graph/schedule/cull.h"
#include "graph/schedule/lifetimes.h"
#include "graph/schedule/schedule.h"
#include "graph/sync/barriers.h"
#include "graph/sync/submissions.h"
#include "graph/sync/synchronize.h"

namespace weft {

namespace {

using StageOver = std::function<void(const char*)>;

// What follows once it is known what shares memory.
struct Recording {
    BarrierPlan barriers;
    SubmissionPlan submissions;
};

Recording record(const ResolvedGraph& graph, const Schedule& order, const SyncTable& sync,
                 const MemoryPlan& memory, std::vector<std::vector<AttachmentOps>> attachments,
                 const StageOver& over) {
    std::vector<QueueDependency> dependencies = sync.dependencies;
    Recording recording;
    recording.barriers = barriers(graph, order, sync, memory, std::move(attachments), dependencies);
    over("barriers");
    recording.submissions = submissions(order, dependencies);
    over("submissions");
    return recording;
}

}  // namespace

FramePlan compile(const ResolvedGraph& graph, const MemoryNeeds& needs, const CompileOptions& options) {
    const StageOver over = [&](const char* stage) {
        if (options.stage_over) options.stage_over(stage);
    };
    LiveGraph live = cull(graph, options.keep_all_passes);
    over("cull");
    Schedule order = schedule(graph, live, needs, options.queues);
    over("schedule");
    std::vector<std::vector<AttachmentOps>> attachments = attachment_ops(graph, live, order);
    over("attachment_ops");
    SyncTable sync = synchronize(graph, order, attachments, find_scopes(graph, order, attachments));
    order = add_clocks(std::move(order), sync.dependencies);
    over("synchronize");
    Lifetimes spans = lifetimes(graph, live, order);
    over("lifetimes");
    MemoryPlan memory = alias(graph, live, order, spans, needs, options.granularity_bytes);
    over("alias");
    Recording recording = record(graph, order, sync, memory, std::move(attachments), over);
    // A scope does not go on behind a semaphore. Without it queues wait for each other as before.
    ScopeTable scopes = within_batches(sync.scopes, recording.submissions);
    if (scopes != sync.scopes) {
        attachments = attachment_ops(graph, live, order);
        sync = synchronize(graph, order, attachments, std::move(scopes));
        recording = record(graph, order, sync, memory, std::move(attachments), over);
    }
    FramePlan plan = link(graph, std::move(live), std::move(order), sync, std::move(spans), std::move(memory),
                          std::move(recording.barriers), std::move(recording.submissions));
    over("link");
    return plan;
}

MemoryNeeds content_needs(const ResolvedGraph& graph, uint64_t alignment_bytes) {
    MemoryNeeds needs(graph.resources.size());
    for (ResourceId id = 0; id < graph.resources.size(); ++id)
        if (graph.resources[id].lifetime != ResourceLifetime::imported)
            needs[id] = {content_bytes(graph.resources[id]), alignment_bytes, UINT32_MAX};
    return needs;
}

}  // namespace weft
