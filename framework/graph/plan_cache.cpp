#include "graph/plan_cache.h"

namespace weft {

const FramePlan& PlanCache::get(const ResolvedGraph& graph, const MemoryNeeds& needs,
                                const CompileOptions& options) {
    const std::string key = compile_hash(graph, needs, options);
    const auto found = plans_.find(key);
    if (found != plans_.end()) return found->second;
    return plans_.emplace(key, compile(graph, needs, options)).first->second;
}

}  // namespace weft
