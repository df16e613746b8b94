// Purpose: an unchanged graph costs a hash and a look-up instead of a compilation. Where a graph was written
// is no part of the hash: a plan found here names the lines of the first graph that asked for it.
#pragma once

#include <map>
#include <string>

#include "weft/compile.h"

namespace weft {

// The canonical hash of all that compile() reads: 32 hex digits.
[[nodiscard]] std::string compile_hash(const ResolvedGraph& graph, const MemoryNeeds& needs,
                                       const CompileOptions& options);

class PlanCache {
 public:
    // Compiles what it has not seen yet. The plan stays where it is for as long as the cache lives.
    [[nodiscard]] const FramePlan& get(const ResolvedGraph& graph, const MemoryNeeds& needs,
                                       const CompileOptions& options);
    // By a compile_hash() that the caller kept: whoever knows that nothing has changed hashes nothing. Null
    // where nobody has asked for it before.
    [[nodiscard]] const FramePlan* find(const std::string& hash) const;

 private:
    std::map<std::string, FramePlan> plans_;
};

}  // namespace weft
