// Purpose: runs a plan with no GPU, in an order that its barriers and semaphores allow but that nobody would
// wish for. Every subresource holds one 64-bit value at its place in the plan's memory, and a pass writes
// hashes of all that it reads, so that two runs agree on a value only if they agree on everything that led to
// it. Memory behaves as in Vulkan (1.3 specification, chapter "Synchronization and Cache Control" and
// appendix "Memory Model"): a write stays in its stage until something makes it available and visible; what a
// dependency does not cover, what was handed over, and what is in another layout or another queue family's
// hands is poison: a value unlike any other, which spreads to all that is made from it.
// Errors: none; a wrong plan gives wrong values, and says in words where the first of them came from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weft/plan.h"

namespace weft {

// Which of the orders that the plan allows.
enum class NullOrder : uint8_t {
    recorded,  // as it is submitted
    delayed,   // from the last command backwards: nothing is done before something needs it
    shuffled,  // drawn by the seed
};

struct NullOptions {
    uint32_t frames = 3;
    uint64_t seed = 0;  // draws the order, and in which of its stages a write of several is done
    NullOrder order = NullOrder::shuffled;
};

// What is in a subresource, or in a buffer. 0: nothing that anybody may rely on.
using CellValue = uint64_t;
inline constexpr CellValue kUndefinedValue = 0;

// One subresource as somebody outside the frame sees it: a pass with side effects, the owner of an import
// after a frame (pass kNoId), or whoever looks into a persistent resource after the last one.
struct ObservedCell {
    uint32_t frame = 0;
    PassId pass = kNoId;
    uint32_t use = 0;  // index into the pass's uses
    ResourceId resource = kNoId;
    SubresourceRange range;  // one mip of one layer of one aspect
    CellValue value = kUndefinedValue;
};

struct NullRun {
    std::vector<ObservedCell> observed;  // sorted by everything but the value
    std::vector<std::string> faults;  // the first few causes of poison, in the order in which they happened
};

[[nodiscard]] NullRun run_null(const FramePlan& plan, const NullOptions& options = {});

// What `plan` should have given: the passes one by one, every resource in memory of its own, every read
// seeing the version that the graph says. Made from the declarations alone.
[[nodiscard]] NullRun run_reference(const ResolvedGraph& graph, const LiveGraph& live, uint32_t frames = 3);

// What differs, in words; empty when both agree on all that `wanted` defines.
[[nodiscard]] std::vector<std::string> differences(const ResolvedGraph& graph, const NullRun& wanted,
                                                   const NullRun& found);

}  // namespace weft
