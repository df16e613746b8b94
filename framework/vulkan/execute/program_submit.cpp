#include "vulkan/execute/program_submit.h"
#include "graph/diagnostics/make_error.h"

#include <algorithm>
#include <string>

namespace weft::vk {
namespace {

bool uses_resource(const FramePlan& plan, const Batch& batch, ResourceId resource) {
    return std::ranges::any_of(batch.positions, [&](Position position) {
        const PassDecl& pass = plan.graph.passes[plan.schedule.order[position]];
        return std::ranges::any_of(pass.uses, [&](const UseDecl& use) { return use.resource == resource; });
    });
}

// Returns the first submitted batch with a pass that uses the import. A use in the epilogue does not count,
// because in the plan the epilogue waits for these passes. Returns kNoId if no submitted batch uses the
// import. Also returns kNoId if passes on several queues use the import: a binary semaphore can release only
// one batch, and the batches on the other queues would not wait.
uint32_t first_batch_with(const FramePlan& plan, const std::string& import,
                          const std::vector<uint8_t>& empty) {
    const ResourceId resource = find_resource(plan.graph, import);
    if (import.empty() || resource == kNoId) return kNoId;
    uint32_t first = kNoId;
    const std::vector<Batch>& batches = plan.submissions.batches;
    for (uint32_t i = 0; i < batches.size(); ++i) {
        if (!uses_resource(plan, batches[i], resource) || (i < empty.size() && empty[i] != 0)) continue;
        if (first == kNoId) first = i;
        if (batches[i].queue != batches[first].queue) return kNoId;
    }
    return first;
}

}  // namespace

Status check_submit(const FramePlan& plan, const FrameSubmit& submit) {
    const bool has_ticket = submit.ticket.timeline != VK_NULL_HANDLE;
    if (submit.commands == VK_NULL_HANDLE) {
        if (!has_ticket) return Unit{};
        return make_error("V423", "the frame has a ticket, but no command buffer of the program",
                          {"set FrameSubmit::commands, or remove the ticket: Weft knows when its own "
                           "submissions have finished"});
    }
    if (plan.submissions.batches.size() > 1)
        return make_error(
            "V422",
            "the plan has " + std::to_string(plan.submissions.batches.size()) + " batches on " +
                std::to_string(plan.schedule.queues.size()) +
                " queues, but the program's command buffer can contain only one batch",
            {"plan for one queue (SessionInput::queues = 1), or let Weft submit the frame and order it with "
             "semaphores (FrameSubmit::waits and signals)"});
    if (!has_ticket)
        return make_error("V423", "the frame has a command buffer of the program, but no ticket",
                          {"set FrameSubmit::ticket to a timeline semaphore and the value that it reaches "
                           "when the commands have finished"});
    if (submit.waits.empty() && submit.signals.empty()) return Unit{};
    return make_error("V423", "the frame has both a command buffer of the program and semaphores",
                      {"give the semaphores to your own submission of the command buffer"});
}

std::vector<uint32_t> waiting_batches(const FramePlan& plan, const std::vector<SemaphoreWait>& waits,
                                      const std::vector<uint8_t>& empty) {
    std::vector<uint32_t> batches;
    for (const SemaphoreWait& wait : waits) batches.push_back(first_batch_with(plan, wait.import, empty));
    return batches;
}

}  // namespace weft::vk
