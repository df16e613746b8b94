// Purpose: which stages wait for which, over all barriers that one queue has recorded. A record of an access
// looks the answer up when it is asked for, so that a barrier costs nothing for the thousands of accesses
// that it is not about. Shapes: a chain is a map from stages to sets of stages. Source: Vulkan 1.3
// specification, "Execution Dependencies": two barriers chain where the destination of the first meets the
// source of the second.
#pragma once

#include <array>
#include <vector>

#include "weft/access.h"

namespace weft::check {

// One barrier's two halves, stages widened for execution and kept narrow for memory.
struct Scopes {
    StageMask src_execution = 0, dst_execution = 0;
    StageMask src_memory = 0, dst_memory = 0;
    AccessMask src_access = 0, dst_access = 0;
};

class StageChain {
 public:
    // Barriers that are added to one chain do not chain with each other.
    void add(const Scopes& barrier);
    // The stages that wait for at least one of `stages`.
    [[nodiscard]] StageMask after(StageMask stages) const;
    // This chain and then `next`: what either orders, and what both together do.
    [[nodiscard]] StageChain then(const StageChain& next) const;
    bool operator==(const StageChain&) const = default;

 private:
    std::array<StageMask, stage::kCount> after_{};  // by stage
};

// The batches of barriers of one queue: each call of vkCmdPipelineBarrier2 is a batch.
class BarrierLog {
 public:
    void append(const StageChain& batch);
    [[nodiscard]] uint32_t count() const { return count_; }
    // All batches but the first `count`, of which there must be fewer than count().
    [[nodiscard]] const StageChain& since(uint32_t count) const;

 private:
    // The chain is the same for all starts from `first` to the next suffix. The longer one holds the shorter
    // one, so there are at most as many suffixes as a chain has pairs of stages.
    struct Suffix {
        uint32_t first = 0;
        StageChain chain;
    };

    std::vector<Suffix> suffixes_;
    uint32_t count_ = 0;
};

}  // namespace weft::check
