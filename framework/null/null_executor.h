// Purpose: runs a plan without a GPU, in the least favourable order that its barriers and semaphores allow.
// Every subresource holds one 64-bit value at its place in the plan's memory. A pass writes hashes of all
// values that it reads, so two runs have equal values only if everything before was equal too. Memory behaves
// as in Vulkan (1.3 specification, chapter "Synchronization and Cache Control" and appendix "Memory Model"):
// a write stays in its stage until a dependency makes it available and visible. A read gets poison if no
// dependency covers it, if other data has replaced the content, or if the layout or the owning queue family
// is wrong. Poison is a unique value that spreads to all values computed from it. Errors: none; a wrong plan
// gives wrong values, and `faults` describes where the first of them came from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weft/plan.h"

namespace weft {

// Chooses one of the execution orders that the plan allows.
enum class NullOrder : uint8_t {
    recorded,  // in submission order
    delayed,   // backwards from the last command: every command runs as late as possible
    shuffled,  // pseudo-random, from the seed
};

struct NullOptions {
    uint32_t frames = 3;
    uint64_t seed = 0;  // selects the order, and for a write of several stages the stage in which it happens
    NullOrder order = NullOrder::shuffled;
};

// The content of a subresource or buffer. 0: undefined content.
using CellValue = uint64_t;
inline constexpr CellValue kUndefinedValue = 0;

// One subresource as seen from outside the frame: by a pass with side effects, by the owner of an import
// after a frame (pass kNoId), or by a reader of a persistent resource after the last frame.
struct ObservedCell {
    uint32_t frame = 0;
    PassId pass = kNoId;
    uint32_t use = 0;  // index into the pass's uses
    ResourceId resource = kNoId;
    SubresourceRange range;  // one mip of one layer of one aspect
    CellValue value = kUndefinedValue;
};

struct NullRun {
    std::vector<ObservedCell> observed;  // sorted by all members except the value
    std::vector<std::string> faults;     // the first few causes of poison, in order of occurrence
};

[[nodiscard]] NullRun run_null(const FramePlan& plan, const NullOptions& options = {});

// The expected result of `plan`: runs the passes one after another, with separate memory for every resource,
// so that every read sees the version given by the graph. Uses only the declarations.
[[nodiscard]] NullRun run_reference(const ResolvedGraph& graph, const LiveGraph& live, uint32_t frames = 3);

// Text for each difference; empty when both agree on all values that are defined in `wanted`.
[[nodiscard]] std::vector<std::string> differences(const ResolvedGraph& graph, const NullRun& wanted,
                                                   const NullRun& found);

}  // namespace weft
