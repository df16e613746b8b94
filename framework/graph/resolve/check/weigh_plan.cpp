// Estimates the steps of compiling and checking a resolved graph. The compiler and the checker follow each
// subresource through all its accesses; the checker does so for several frames.
#include <algorithm>

#include "graph/resolve/checks.h"

namespace weft {
namespace {

// Steps per subresource: several tables of the compiler and the checker have an entry for each subresource.
constexpr uint64_t kStepsPerSubresource = 16;
// Number of frames that the checker simulates if no resource has a history. Otherwise it simulates this
// number of frames plus the length of the longest history, in frames.
constexpr uint64_t kCheckedFrames = 3;

uint64_t count_subresources(const SubresourceRange& range) {
    return uint64_t{range.mips} * range.layers *
           (range.aspects == (aspect::kDepth | aspect::kStencil) ? 2 : 1);
}

}  // namespace

void weigh_plan(const ResolvedGraph& graph, Reporter& reporter) {
    if (reporter.has_errors()) return;
    uint64_t frames = kCheckedFrames;
    for (const ResourceDecl& resource : graph.resources) {
        reporter.spend(kStepsPerSubresource * count_subresources(resource.whole()), resource.loc);
        frames = std::max(frames, kCheckedFrames + resource.history);
    }
    // For each combination of the switches after the first, the checker simulates all frames again, and one
    // frame more.
    const uint64_t combinations = uint64_t{1} << graph.switches.size();
    frames += (combinations - 1) * (frames + 1);
    for (const PassDecl& pass : graph.passes) {
        reporter.spend(1, pass.loc);
        for (const UseDecl& use : pass.uses) reporter.spend(frames * count_subresources(use.range), use.loc);
    }
}

}  // namespace weft
