// Purpose: records all barriers of one queue and tells which stages wait for which other stages. A new
// barrier updates only the AccessRecords (ordering.h) of the memory that the barrier names. All other
// AccessRecords, maybe thousands, read the barrier from this log later, when the checker needs them. A chain
// of barriers is stored as a map from each stage to the set of stages that wait for it. Source: Vulkan 1.3
// specification, "Execution Dependencies": two barriers form a chain if the destination stages of the first
// barrier and the source stages of the second barrier intersect.
#pragma once

#include <array>
#include <vector>

#include "weft/access.h"

namespace weft::check {

// The source and destination scopes of one barrier. The execution scopes also include the stages that come
// logically before a source stage or after a destination stage in the pipeline. The memory scopes include
// only the stages that the barrier names.
struct Scopes {
    StageMask src_execution = 0, dst_execution = 0;
    StageMask src_memory = 0, dst_memory = 0;
    AccessMask src_access = 0, dst_access = 0;
};

class StageChain {
 public:
    // Adds a barrier of the same vkCmdPipelineBarrier2 call. Barriers of one call do not chain with each
    // other.
    void add(const Scopes& barrier);
    // Returns the stages that wait for at least one of `stages`.
    [[nodiscard]] StageMask after(StageMask stages) const;
    // Returns this chain, followed by the chain `next`. The result has the dependencies of both chains, and
    // indirect ones: if stage B waits for stage A in this chain, and stage C waits for B in `next`, then C
    // waits for A.
    [[nodiscard]] StageChain then(const StageChain& next) const;
    bool operator==(const StageChain&) const = default;

 private:
    // Index: bit of stage s. Value: the stages that wait for s.
    std::array<StageMask, stage::kCount> after_{};
};

// The barrier batches of one queue; each call of vkCmdPipelineBarrier2 is one batch.
class BarrierLog {
 public:
    void append(const StageChain& batch);
    [[nodiscard]] uint32_t count() const { return count_; }
    // Returns the combined chain of all batches except the first `count` batches. `count` must be less than
    // count().
    [[nodiscard]] const StageChain& since(uint32_t count) const;

 private:
    // The combined chain of the batches from index `first` to the last batch. Every index from `first` up to,
    // but not including, `first` of the next Suffix gives the same combined chain. So all these indices share
    // one Suffix. The chain of each Suffix contains all dependencies of the next Suffix, and at least one
    // more. So the number of Suffixes is limited by the number of pairs of stages.
    struct Suffix {
        uint32_t first = 0;
        StageChain chain;
    };

    std::vector<Suffix> suffixes_;
    uint32_t count_ = 0;
};

}  // namespace weft::check
