#include <numeric>

#include "graph/stages.h"

namespace weft {

SubmissionPlan submissions(const ResolvedGraph&, const Schedule& order, const BarrierPlan&) {
    // With one queue nothing is waited for: pipeline barriers order work across submissions too.
    Batch batch;
    batch.positions.resize(order.order.size());
    std::iota(batch.positions.begin(), batch.positions.end(), 0u);
    batch.epilogue = true;
    return SubmissionPlan{{batch}, {}};
}

}  // namespace weft
