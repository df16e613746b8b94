// What a graph means is known; what its plan will cost follows from it. Compiling follows every subresource
// through the accesses to it, and the checker carries all that is outstanding through the barriers of every
// pass, over several frames.
#include <algorithm>

#include "graph/resolve_context.h"

namespace weft {
namespace {

constexpr uint64_t kStepsPerSubresource = 16;  // it has a state in each of several tables
constexpr uint64_t kVisitsPerStep = 12;        // of the checker, for what a barrier leaves as it is
constexpr uint64_t kCheckedFrames = 3;         // and one more for each frame of a history

uint64_t count_subresources(const SubresourceRange& range) {
    return uint64_t{range.mips} * range.layers *
           (range.aspects == (aspect::kDepth | aspect::kStencil) ? 2 : 1);
}

}  // namespace

void weigh_plan(ResolveState& state) {
    uint64_t subresources = 0;
    uint64_t frames = kCheckedFrames;
    for (const ResourceDecl& resource : state.graph.resources) {
        const uint64_t own = count_subresources(resource.whole());
        state.spend(kStepsPerSubresource * own, resource.loc);
        subresources += own;
        frames = std::max(frames, kCheckedFrames + resource.history);
    }
    for (const PassDecl& pass : state.graph.passes) {
        state.spend(1 + frames * subresources / kVisitsPerStep, pass.loc);
        for (const UseDecl& use : pass.uses) state.spend(frames * count_subresources(use.range), use.loc);
    }
}

}  // namespace weft
