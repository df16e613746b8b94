#include "graph/plan/plan_cache.h"

namespace weft {

const FramePlan& PlanCache::get(const ResolvedGraph& graph, const MemoryNeeds& needs,
                                const CompileOptions& options) {
    const std::string key = compile_hash(graph, needs, options);
    if (const FramePlan* plan = find(key)) return *plan;
    return plans_.emplace(key, compile(graph, needs, options)).first->second;
}

const FramePlan* PlanCache::find(const std::string& hash) const {
    const auto found = plans_.find(hash);
    return found == plans_.end() ? nullptr : &found->second;
}

}  // namespace weft
