// Purpose: makes plans of random graphs with all optional features, for one to four queues.
#pragma once

#include "tests/graph/samples/random_graph.h"
#include "weft/compile.h"

namespace weft::test {

inline FramePlan random_plan(uint32_t seed, uint32_t max_passes) {
    DeviceProfile profile;
    profile.queue_families = {{QueueKind::graphics, 1}, {QueueKind::compute, 2}, {QueueKind::transfer, 1}};
    CompileOptions options;
    options.queues = logical_queues(profile, 1 + seed % 4);
    RandomGraphOptions features = all_features();
    features.max_passes = max_passes;
    const ResolvedGraph graph = random_graph(seed, features);
    return compile(graph, content_needs(graph), options);
}

}  // namespace weft::test
