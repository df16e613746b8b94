// Purpose: random frames with all features and their plans, for tests that run them: a seed says everything.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "graph/random_graph.h"
#include "weft/compile.h"

namespace weft::test {

// Ten thousand graphs take minutes: only when asked for.
inline bool extended() {
    return std::getenv("WEFT_EXTENDED") != nullptr;
}

// A quarter of the seeds for each number of queues from 1 to 4; every eighth has one family for all.
inline CompileOptions random_options(uint32_t seed) {
    DeviceProfile profile;
    if (seed % 8 != 7)
        profile.queue_families = {
            {QueueKind::graphics, 1}, {QueueKind::compute, 2}, {QueueKind::transfer, 1}};
    CompileOptions options;
    options.queues = logical_queues(profile, 1 + seed % 4);
    options.granularity_bytes = seed % 16 == 5 ? 65536 : 64;
    return options;
}

inline FramePlan random_plan(uint32_t seed, uint32_t max_passes = 60) {
    RandomGraphOptions options = all_features();
    options.max_passes = max_passes;
    const ResolvedGraph graph = random_graph(seed, options);
    return compile(graph, content_needs(graph), random_options(seed));
}

}  // namespace weft::test
