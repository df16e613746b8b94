#include <algorithm>

#include "graph/diagnostics/quantity_text.h"
#include "graph/report/explain_phrases.h"
#include "graph/report/plan_phrases.h"
#include "weft/report/plan_explain.h"

namespace weft {
namespace {

uint32_t batch_of(const FramePlan& plan, Position position) {
    const std::vector<Batch>& batches = plan.submissions.batches;
    const auto it = std::find_if(batches.begin(), batches.end(), [position](const Batch& batch) {
        return std::find(batch.positions.begin(), batch.positions.end(), position) != batch.positions.end();
    });
    return static_cast<uint32_t>(it - batches.begin());
}

// Returns one line for each use of `resource` by the pass at `position`. The lines explain why one queue
// waits for another: both queues use `resource`.
std::string uses_at(const FramePlan& plan, Position position, ResourceId resource) {
    if (position >= plan.schedule.order.size()) return "";
    std::string text;
    for (const UseDecl& use : plan.graph.passes[plan.schedule.order[position]].uses)
        if (use.resource == resource)
            text += "    " + describe_pass(plan, plan.schedule.order[position]) + ": " +
                    describe_use(plan, use) + ".\n";
    return text;
}

}  // namespace

std::string describe_batch(const FramePlan& plan, const Batch& batch) {
    std::string text = "queue " + std::to_string(batch.queue);
    if (!batch.positions.empty())
        text += ", " + describe_position(plan, batch.positions.front()) +
                (batch.positions.size() > 1 ? " to " + describe_position(plan, batch.positions.back()) : "");
    return text;
}

std::string describe_cause(const FramePlan& plan, uint32_t dependency) {
    if (dependency == kNoId) return "";
    const QueueDependency& d = plan.submissions.dependencies[dependency];
    std::string text = "    " + describe_position(plan, d.to) + " must not start before " +
                       describe_position(plan, d.from) + (d.previous_frame ? " of the previous frame" : "") +
                       " has finished, because of ";
    text += d.resource == kNoId ? "an \"after\"" : describe_resource(plan, d.resource);
    text += ".\n";
    if (d.resource == kNoId) return text;
    return text + uses_at(plan, d.from, d.resource) + uses_at(plan, d.to, d.resource);
}

namespace {

std::string describe_waits(const FramePlan& plan, PassId pass) {
    const std::string words = describe_pass(plan, pass);
    if (!plan.live.live_passes[pass])
        return words + " does not wait, because it is culled: " + plan.live.details[pass] + ".\n";
    const Position position = plan.schedule.position[pass];
    const uint32_t own = batch_of(plan, position);
    if (plan.schedule.queues.size() == 1)
        return words +
               " waits for no other queue, because the plan has only one queue. Barriers order its passes; "
               "use "
               "--queues for a plan with more queues.\n";
    const Batch& batch = plan.submissions.batches[own];
    std::string text = words + " runs in this submission: " + describe_batch(plan, batch) + ".\n";
    if (batch.waits.empty()) text += "  The submission waits for no other queue.\n";
    for (const QueueWait& wait : batch.waits)
        text += "  Before the submission begins, it waits for " +
                describe_batch(plan, plan.submissions.batches[wait.batch]) +
                (wait.previous_frame ? " of the previous frame (not in the first frame)" : "") + ".\n" +
                describe_cause(plan, wait.dependency);
    for (const Batch& other : plan.submissions.batches)
        for (const QueueWait& wait : other.waits)
            if (wait.batch == own)
                text += "  This submission must end before " + describe_batch(plan, other) +
                        (wait.previous_frame ? " of the next frame" : "") + " begins.\n" +
                        describe_cause(plan, wait.dependency);
    return text;
}

}  // namespace

Result<std::string> explain_wait(const FramePlan& plan, const std::string& name) {
    return describe_passes(plan, name, describe_waits);
}

}  // namespace weft
