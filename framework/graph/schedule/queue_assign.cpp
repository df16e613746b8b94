// Which queue runs a pass: the one its author hints at, where that queue exists and can do what the pass
// does, else the next more capable one.
#include <algorithm>
#include <array>

#include "graph/schedule/queue_assign.h"
#include "weft/compile.h"

namespace weft {
namespace {

constexpr StageMask kTransferStages = stage::kCopy | stage::kHost;
constexpr StageMask kComputeStages =
    kTransferStages | stage::kClear | stage::kDrawIndirect | stage::kComputeShader;

// Whether a queue can do it: its stages, and the copies and clears that only some queues offer.
bool can_run(const PassDecl& pass, const LogicalQueue& queue) {
    if (queue.kind == QueueKind::graphics) return true;
    if (pass.kind == PassKind::raster || pass.kind == PassKind::fullscreen) return false;
    return std::all_of(pass.uses.begin(), pass.uses.end(), [&](const UseDecl& use) {
        const StageMask stages = use.state.stages;
        const bool depth = (use.range.aspects & (aspect::kDepth | aspect::kStencil)) != 0;
        if (depth && (stages & (stage::kCopy | stage::kClear)) != 0) return false;
        const StageMask offered = queue.kind == QueueKind::compute ? kComputeStages : kTransferStages;
        return (stages & ~offered) == 0;
    });
}

// An import that was not made for all families stays in its own.
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

}  // namespace

std::vector<QueueIndex> assign_queues(const ResolvedGraph& graph, const std::vector<PassId>& order,
                                      const std::vector<LogicalQueue>& queues) {
    std::vector<QueueIndex> assigned;
    std::array<uint32_t, 3> used{};  // by kind: how many passes were given to queues of that kind
    for (const PassId id : order) {
        const PassDecl& pass = graph.passes[id];
        QueueIndex chosen = 0;
        for (int kind = static_cast<int>(pass.queue); kind > 0 && chosen == 0; --kind) {
            std::vector<QueueIndex> fitting;
            for (QueueIndex q = 1; q < queues.size(); ++q)
                if (static_cast<int>(queues[q].kind) == kind && can_run(pass, queues[q]) &&
                    owns_imports(graph, pass, queues[q]))
                    fitting.push_back(q);
            if (!fitting.empty()) chosen = fitting[used[static_cast<size_t>(kind)]++ % fitting.size()];
        }
        assigned.push_back(chosen);
    }
    // The first queue begins and ends every frame; a frame that leaves it idle gains nothing from the others.
    if (std::find(assigned.begin(), assigned.end(), 0u) == assigned.end())
        assigned.assign(assigned.size(), 0);
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
