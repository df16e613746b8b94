#include "weft/load/plan_graph.h"

#include <utility>

#include "weft/compile.h"

namespace weft {

Result<PlannedGraph> plan_graph(const JsonDoc& document, const LoadInput& input, uint32_t queue_count,
                                Diagnostics& warnings) {
    Result<LoadedGraph> loaded = load_graph(document, input, warnings);
    if (!loaded) return loaded.take_errors();
    const MemoryNeeds needs = profile_needs(loaded->graph, input.profile);
    FramePlan plan = compile(loaded->graph, needs, compile_options(input.profile, queue_count));
    return PlannedGraph{std::move(*loaded), std::move(plan)};
}

}  // namespace weft
