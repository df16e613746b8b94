#include "weft/compile.h"

#include <utility>

#include "graph/stages.h"

namespace weft {

FramePlan compile(const ResolvedGraph& graph, const MemoryNeeds& needs, const CompileOptions& options) {
    const auto over = [&](const char* stage) {
        if (options.stage_over) options.stage_over(stage);
    };
    LiveGraph live = cull(graph, options.keep_all_passes);
    over("cull");
    Schedule order = schedule(graph, live, needs, options.queues);
    over("schedule");
    std::vector<std::vector<AttachmentOps>> attachments = attachment_ops(graph, live, order);
    over("attachment_ops");
    const SyncTable sync = synchronize(graph, order, attachments);
    order = add_clocks(std::move(order), sync.dependencies);
    over("synchronize");
    Lifetimes spans = lifetimes(graph, live, order);
    over("lifetimes");
    MemoryPlan memory = alias(graph, live, order, spans, needs, options.granularity_bytes);
    over("alias");
    std::vector<QueueDependency> dependencies = sync.dependencies;
    BarrierPlan barrier_plan = barriers(graph, order, sync, memory, std::move(attachments), dependencies);
    over("barriers");
    SubmissionPlan submission_plan = submissions(order, dependencies);
    over("submissions");
    FramePlan plan = link(graph, std::move(live), std::move(order), sync, std::move(spans), std::move(memory),
                          std::move(barrier_plan), std::move(submission_plan));
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
