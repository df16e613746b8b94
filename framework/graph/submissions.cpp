#include "graph/stages.h"

namespace weft {

SubmissionPlan submissions(const ResolvedGraph&, const Schedule& order, const BarrierPlan&) {
    // With one queue nothing is waited for: pipeline barriers order work across submissions too.
    Batch batch;
    batch.count = static_cast<uint32_t>(order.order.size());
    batch.epilogue = true;
    return SubmissionPlan{{batch}};
}

}  // namespace weft
