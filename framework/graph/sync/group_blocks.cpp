#include "graph/sync/group_blocks.h"

#include <algorithm>

namespace weft {
namespace {

const GroupBlock* block_of(const std::vector<GroupBlock>& blocks, Position position) {
    const auto found = std::ranges::find_if(
        blocks, [&](const GroupBlock& block) { return !block.empty() && block.contains(position); });
    return found == blocks.end() ? nullptr : &*found;
}

// Moves barriers from the list `from` to the end of the list `into`: those that are recorded in every frame,
// even if the pass does not run.
void move_shared(std::vector<BarrierDecl>& from, std::vector<BarrierDecl>& into) {
    const auto own = std::ranges::stable_partition(from, &BarrierDecl::if_pass_runs);
    into.insert(into.end(), own.begin(), own.end());
    from.erase(own.begin(), own.end());
}

}  // namespace

std::vector<GroupBlock> group_blocks(const ResolvedGraph& graph, const Schedule& order) {
    std::vector<GroupBlock> blocks(graph.groups.size());
    for (Position position(0); position < order.order.size(); ++position) {
        const uint32_t unit = graph.passes[order.order[position]].rest_unit;
        if (unit == kNoId) continue;
        for (size_t group = 0; group < blocks.size(); ++group) {
            if (!graph.groups[group].has_unit(unit)) continue;
            if (blocks[group].empty()) blocks[group].first = position;
            blocks[group].last = position;
        }
    }
    return blocks;
}

std::vector<QueueDependency> outside_blocks(const std::vector<GroupBlock>& blocks,
                                            std::vector<QueueDependency> dependencies) {
    for (QueueDependency& dependency : dependencies) {
        if (const GroupBlock* block = block_of(blocks, dependency.from)) dependency.from = block->last;
        if (const GroupBlock* block = block_of(blocks, dependency.to)) dependency.to = block->first;
    }
    return dependencies;
}

void move_shared_barriers(const std::vector<GroupBlock>& blocks, BarrierPlan& plan) {
    for (const GroupBlock& block : blocks) {
        for (Position position(block.first + 1); position <= block.last; ++position) {
            PassStep& first = plan.steps[block.first];
            const size_t moved = first.barriers.size();
            move_shared(plan.steps[position].barriers, first.barriers);
            for (size_t i = moved; i < first.barriers.size(); ++i) first.barriers[i].to = first.pass;
        }
        for (Position position = block.first; position < block.last; ++position)
            move_shared(plan.steps[position].after, plan.steps[block.last].after);
    }
}

}  // namespace weft
