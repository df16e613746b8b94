#include <algorithm>

#include "graph/schedule/lifetimes.h"

namespace weft {
namespace {

void add_to_queue(LifetimeSpan& span, QueueIndex queue, Position position) {
    const auto own = std::find_if(span.queues.begin(), span.queues.end(),
                                  [queue](const QueueSpan& s) { return s.queue == queue; });
    if (own == span.queues.end())
        span.queues.push_back({queue, position, position});
    else
        own->last = position;
}

// The memory of a transient that a rest unit (passes with "rest" that run together, or a round of a group)
// writes is never shared with another resource. So a readback can read the content in the frames in which the
// unit rests. And no pass has to wait for the unit only because of shared memory.
void extend_rested(const ResolvedGraph& graph, const Schedule& order, Lifetimes& result) {
    LifetimeSpan whole{0, Position(order.order.size() - 1), {}};
    if (order.queues.size() > 1)
        for (Position position(0); position < order.order.size(); ++position)
            add_to_queue(whole, order.queue[position], position);
    for (const PassId pass : order.order) {
        if (graph.passes[pass].rest_unit == kNoId) continue;
        for (const UseDecl& use : graph.passes[pass].uses)
            if (writes(use.access) && graph.resources[use.resource].lifetime == ResourceLifetime::transient)
                result.spans[use.resource] = whole;
    }
}

}  // namespace

Lifetimes lifetimes(const ResolvedGraph& graph, const LiveGraph& live, const Schedule& order) {
    const bool several_queues = order.queues.size() > 1;
    Lifetimes result;
    result.spans.resize(graph.resources.size());
    for (Position position(0); position < order.order.size(); ++position) {
        for (const UseDecl& use : graph.passes[order.order[position]].uses) {
            const bool counts = live.live_resources[use.resource] &&
                                graph.resources[use.resource].lifetime == ResourceLifetime::transient;
            if (!counts) continue;
            LifetimeSpan& span = result.spans[use.resource];
            if (span.first > span.last) span.first = position;
            span.last = position;
            if (several_queues) add_to_queue(span, order.queue[position], position);
        }
    }
    if (graph.rest_unit_count > 0) extend_rested(graph, order, result);
    return result;
}

}  // namespace weft
