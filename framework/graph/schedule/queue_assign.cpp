// Chooses the queue of each pass. A pass gets a queue of the kind that its author suggests. If no such queue
// exists or can run the pass, the pass gets a queue of the next more capable kind.
#include <algorithm>
#include <array>

#include "graph/schedule/queue_assign.h"
#include "weft/compile.h"

namespace weft {
namespace {

constexpr StageMask kTransferStages = stage::kCopy | stage::kHost;
constexpr StageMask kComputeStages =
    kTransferStages | stage::kClear | stage::kDrawIndirect | stage::kComputeShader;

// Returns true if the queue supports all stages of the pass. Depth images can be copied or cleared only on a
// graphics queue. A transfer queue may copy only whole mip levels (minImageTransferGranularity), so it cannot
// copy the area of an image with a live size.
bool can_run(const ResolvedGraph& graph, const PassDecl& pass, const LogicalQueue& queue) {
    if (queue.kind == QueueKind::graphics) return true;
    if (pass.kind == PassKind::raster || pass.kind == PassKind::fullscreen) return false;
    return std::all_of(pass.uses.begin(), pass.uses.end(), [&](const UseDecl& use) {
        const StageMask stages = use.state.stages;
        const bool part = graph.resources[use.resource].area != kNoId;
        if (part && queue.kind == QueueKind::transfer) return false;
        const bool depth = (use.range.aspects & (aspect::kDepth | aspect::kStencil)) != 0;
        if (depth && (stages & (stage::kCopy | stage::kClear)) != 0) return false;
        const StageMask offered = queue.kind == QueueKind::compute ? kComputeStages : kTransferStages;
        return (stages & ~offered) == 0;
    });
}

// Returns true if every import that the pass uses may be used on this queue: the import was created for all
// queue families, or it belongs to the family of the queue.
bool owns_imports(const ResolvedGraph& graph, const PassDecl& pass, const LogicalQueue& queue) {
    return std::all_of(pass.uses.begin(), pass.uses.end(), [&](const UseDecl& use) {
        const std::optional<ImportState>& import = graph.resources[use.resource].import;
        return !import || import->concurrent || import->family == queue.family;
    });
}

uint32_t family_of(const DeviceProfile& profile, QueueKind kind) {
    for (uint32_t family = 0; family < profile.queue_families.size(); ++family)
        if (profile.queue_families[family].kind == kind) return family;
    return kind == QueueKind::transfer  ? family_of(profile, QueueKind::compute)
           : kind == QueueKind::compute ? family_of(profile, QueueKind::graphics)
                                        : 0;
}

// Gives all passes of each group one queue: the queue of the first pass. Exception: they get the graphics
// queue if a pass of the group was assigned to it or cannot run on the queue of the first pass. `order` has
// the passes of a group one after another.
void unite_groups(const ResolvedGraph& graph, const std::vector<PassId>& order,
                  const std::vector<LogicalQueue>& queues, std::vector<QueueIndex>& assigned) {
    for (const GroupDecl& group : graph.groups) {
        std::vector<size_t> members;
        for (size_t i = 0; i < order.size(); ++i)
            if (group.has_unit(graph.passes[order[i]].rest_unit)) members.push_back(i);
        if (members.empty()) continue;
        const QueueIndex first = assigned[members.front()];
        const bool fits = std::ranges::all_of(members, [&](size_t i) {
            const PassDecl& pass = graph.passes[order[i]];
            return assigned[i] != kGraphicsQueue && can_run(graph, pass, queues[first]) &&
                   owns_imports(graph, pass, queues[first]);
        });
        for (const size_t i : members) assigned[i] = fits ? first : kGraphicsQueue;
    }
}

}  // namespace

std::vector<QueueIndex> assign_queues(const ResolvedGraph& graph, const std::vector<PassId>& order,
                                      const std::vector<LogicalQueue>& queues) {
    std::vector<QueueIndex> assigned;
    // Index: QueueKind. Number of passes that got a queue of this kind so far.
    std::array<uint32_t, 3> used{};
    for (const PassId id : order) {
        const PassDecl& pass = graph.passes[id];
        QueueIndex chosen = kGraphicsQueue;
        for (int kind = static_cast<int>(pass.queue); kind > 0 && chosen == kGraphicsQueue; --kind) {
            std::vector<QueueIndex> fitting;
            for (QueueIndex q(1); q < queues.size(); ++q)
                if (static_cast<int>(queues[q].kind) == kind && can_run(graph, pass, queues[q]) &&
                    owns_imports(graph, pass, queues[q]))
                    fitting.push_back(q);
            if (!fitting.empty()) chosen = fitting[used[static_cast<size_t>(kind)]++ % fitting.size()];
        }
        assigned.push_back(chosen);
    }
    unite_groups(graph, order, queues, assigned);
    // Queue 0 begins and ends every frame. If no pass would run on queue 0, further queues bring no
    // advantage, so all passes go to queue 0.
    if (std::find(assigned.begin(), assigned.end(), kGraphicsQueue) == assigned.end())
        assigned.assign(assigned.size(), kGraphicsQueue);
    return assigned;
}

std::vector<LogicalQueue> logical_queues(const DeviceProfile& profile, uint32_t count) {
    constexpr std::array kKinds{QueueKind::graphics, QueueKind::compute, QueueKind::transfer,
                                QueueKind::compute};
    std::vector<LogicalQueue> queues;
    for (uint32_t i = 0; i < count && i < kKinds.size(); ++i)
        queues.push_back({kKinds[i], family_of(profile, kKinds[i])});
    return queues;
}

}  // namespace weft
