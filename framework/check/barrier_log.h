// Purpose: records all barriers of one queue and tells which stages wait for which. An access record queries
// the log only when needed, so a barrier costs no time for the thousands of accesses that it does not affect.
// Shapes: a chain is a map from stages to sets of stages. Source: Vulkan 1.3 specification, "Execution
// Dependencies": two barriers chain where the destination of the first intersects the source of the second.
#pragma once

#include <array>
#include <vector>

#include "weft/access.h"

namespace weft::check {

// Both halves of one barrier. Execution scopes include logically earlier and later stages; memory scopes do
// not.
struct Scopes {
    StageMask src_execution = 0, dst_execution = 0;
    StageMask src_memory = 0, dst_memory = 0;
    AccessMask src_access = 0, dst_access = 0;
};

class StageChain {
 public:
    // Barriers added to the same chain do not chain with each other.
    void add(const Scopes& barrier);
    // The stages that wait for at least one of `stages`.
    [[nodiscard]] StageMask after(StageMask stages) const;
    // The chain for both in sequence: dependencies of either, and those that arise by chaining both.
    [[nodiscard]] StageChain then(const StageChain& next) const;
    bool operator==(const StageChain&) const = default;

 private:
    std::array<StageMask, stage::kCount> after_{};  // index: stage
};

// The barrier batches of one queue; each call of vkCmdPipelineBarrier2 is one batch.
class BarrierLog {
 public:
    void append(const StageChain& batch);
    [[nodiscard]] uint32_t count() const { return count_; }
    // The chain of all batches after the first `count`. `count` must be less than count().
    [[nodiscard]] const StageChain& since(uint32_t count) const;

 private:
    // The chain of all batches from any start index between `first` and the next suffix's `first` - 1. A
    // longer suffix contains each shorter one, so there are at most as many different suffixes as pairs of
    // stages.
    struct Suffix {
        uint32_t first = 0;
        StageChain chain;
    };

    std::vector<Suffix> suffixes_;
    uint32_t count_ = 0;
};

}  // namespace weft::check
