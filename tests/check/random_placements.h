// Purpose: makes plans that have only resources, lifetimes and places in memory, for tests of the checker's
// tables of memory.
#pragma once

#include <random>

#include "weft/plan.h"

namespace weft::test {

// Returns a plan with `count` transient resources at random places in two heaps of `heap_bytes` bytes each.
// Each has up to `most_bytes` bytes and is alive at up to `most_positions` positions.
inline FramePlan random_placements(uint32_t seed, uint32_t count, uint32_t heap_bytes, uint32_t most_bytes,
                                   uint32_t most_positions) {
    std::mt19937 random(seed);
    FramePlan plan;
    plan.graph.resources.resize(count);
    plan.lifetimes.spans.resize(count);
    plan.memory.heaps.resize(2);
    for (ResourceId id(0); id < count; ++id) {
        plan.graph.resources[id].lifetime = ResourceLifetime::transient;
        LifetimeSpan& span = plan.lifetimes.spans[id];
        span.first = Position(static_cast<uint32_t>(random() % 100));
        span.last = Position(span.first + static_cast<uint32_t>(random() % most_positions));
        const uint64_t begin = random() % heap_bytes;
        const uint64_t size = std::min<uint64_t>(1 + random() % most_bytes, heap_bytes - begin);
        plan.memory.placements.push_back({id, static_cast<uint32_t>(random() % 2), begin, size});
    }
    return plan;
}

}  // namespace weft::test
