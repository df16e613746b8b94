// Purpose: computes the happens-before relation on one queue by the rules of Vulkan's execution and memory
// dependencies (Vulkan 1.3 specification, chapter "Synchronization and Cache Control"). A barrier orders all
// earlier commands in its source stages before all later commands in its destination stages, and chains with
// barriers whose scopes intersect. If the source names the stage and access of a write, the barrier makes
// this write available, and visible to its destination stages and accesses.
#pragma once

#include <array>
#include <span>

#include "check/barrier_log.h"
#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

// Returns `stages`, the stages of a source scope, together with the logically earlier stages of the same
// pipeline.
[[nodiscard]] StageMask with_earlier(StageMask stages);
// Returns `stages`, the stages of a destination scope, together with the logically later stages of the same
// pipeline.
[[nodiscard]] StageMask with_later(StageMask stages);

[[nodiscard]] Scopes scopes_of(const BarrierDecl& barrier);

// One access or layout transition. It stores which later stages are ordered after it and to which accesses it
// is visible.
class AccessRecord {
 public:
    AccessRecord() = default;
    AccessRecord(const Actor& actor, StageMask stages, AccessMask access, bool is_write);
    // Creates the record of a layout transition. A transition has no stage of its own: it is complete when
    // the destination stages of its barrier start.
    static AccessRecord transition(const Actor& actor, const Scopes& scopes);

    // Applies one vkCmdPipelineBarrier2 call. `all` has the barriers of the call on all resources, because
    // execution dependencies apply to every resource. `on_memory` has only the barriers on the memory of this
    // access.
    void pass_barriers(const StageChain& all, std::span<const Scopes> on_memory);
    // Applies the barrier batches that were recorded in `log` since the last call. `log` must be the log of
    // this access's queue, and none of these batches may have a barrier on the memory of this access.
    void follow(const BarrierLog& log);

    // Returns true if the barrier with these scopes waits for every stage of this access, directly or through
    // a chain of earlier barriers.
    [[nodiscard]] bool ordered_before(const Scopes& scopes) const;
    // Returns true if every stage of this access completes before any of `stages` starts.
    [[nodiscard]] bool ordered_before(StageMask stages) const;
    [[nodiscard]] bool visible_to(StageMask stages, AccessMask access) const;
    // Returns true if an earlier barrier made this write available, and that barrier chains with the source
    // scope of the barrier `scopes`.
    [[nodiscard]] bool available_before(const Scopes& scopes) const {
        return (available_reach_ & scopes.src_execution) != 0;
    }
    // Returns true if a barrier since the write made it available, and all later commands in `stages` wait
    // for that barrier.
    [[nodiscard]] bool available_before(StageMask stages) const { return (stages & ~available_reach_) == 0; }
    // Returns true if the barrier `scopes` itself makes this write available: its source contains the write.
    [[nodiscard]] bool flushed_by(const Scopes& scopes) const {
        return (stages_ & ~scopes.src_memory) == 0 &&
               (access_ & access::kAllWrites & ~scopes.src_access) == 0;
    }
    [[nodiscard]] bool is_write() const { return is_write_; }
    [[nodiscard]] const Actor& actor() const { return actor_; }
    [[nodiscard]] StageMask stages() const { return stages_; }
    [[nodiscard]] AccessMask access() const { return access_; }

 private:
    // A mask of stages or accesses with 16 instead of 32 bits, to save memory: for a plan with 10,000 passes,
    // the checker stores about a million of these masks.
    using ShortMask = uint16_t;
    static_assert(stage::kCount <= 16 && access::kCount <= 16);

    void carry(const StageChain& chain, StageMask available_before);

    Actor actor_;
    StageMask stages_ = 0;
    AccessMask access_ = 0;
    bool is_write_ = false;
    // Index of the first barrier batch of the access's queue that is not yet applied to this record. Batches
    // before the access do not affect it.
    uint32_t followed_ = 0;
    // The stages whose later commands wait for the barrier that made the write available.
    StageMask available_reach_ = 0;
    // Index: bit of a stage s of this access. Value: the stages whose later commands wait for s.
    std::array<ShortMask, stage::kCount> reach_{};
    // Index: bit of a stage s. Value: the accesses of later commands in s to which the write is visible.
    std::array<ShortMask, stage::kCount> visible_{};
    StageMask transition_reach_ = 0;  // For a layout transition: the stages whose later commands wait for it.
};

}  // namespace weft::check
