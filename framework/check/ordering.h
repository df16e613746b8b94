// Purpose: the happens-before relation on one queue, by the rules of Vulkan's execution and memory
// dependencies (Vulkan 1.3 specification, chapter "Synchronization and Cache Control"). A barrier orders
// everything earlier in its source stages before everything later in its destination stages, and chains with
// barriers whose scopes intersect. A barrier whose source names the writing stage and access makes memory
// available, and makes it visible to its destination stages and accesses.
#pragma once

#include <array>
#include <span>

#include "check/barrier_log.h"
#include "check/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

// All stages of a source mask: the named ones and those logically earlier in the same pipeline.
[[nodiscard]] StageMask with_earlier(StageMask stages);
// All stages of a destination mask: the named ones and the logically later ones.
[[nodiscard]] StageMask with_later(StageMask stages);

[[nodiscard]] Scopes scopes_of(const BarrierDecl& barrier);

// One access or layout transition, with the later stages that are ordered after it and see its effects.
class AccessRecord {
 public:
    AccessRecord() = default;
    // A layout transition has no stage of its own: it is complete when its barrier's destination stages
    // start.
    AccessRecord(const Actor& actor, StageMask stages, AccessMask access, bool is_write);
    static AccessRecord transition(const Actor& actor, const Scopes& scopes);

    // Applies one vkCmdPipelineBarrier2. `all` has its barriers on all resources, because execution
    // dependencies apply to every resource; `on_memory` has those on the memory of this access.
    void pass_barriers(const StageChain& all, std::span<const Scopes> on_memory);
    // Applies the batches of `log`, the log of this access's queue, that were recorded since the last call.
    // None of them may be on the memory of this access.
    void follow(const BarrierLog& log);

    // True if every stage of this access is in the barrier's source scope, or chains to it.
    [[nodiscard]] bool ordered_before(const Scopes& scopes) const;
    // True if every stage of this access completes before any of `stages` starts.
    [[nodiscard]] bool ordered_before(StageMask stages) const;
    [[nodiscard]] bool visible_to(StageMask stages, AccessMask access) const;
    // True if an earlier barrier made this write available and chains to the source of `scopes` (or to all of
    // `stages`).
    [[nodiscard]] bool available_before(const Scopes& scopes) const {
        return (available_reach_ & scopes.src_execution) != 0;
    }
    [[nodiscard]] bool available_before(StageMask stages) const { return (stages & ~available_reach_) == 0; }
    [[nodiscard]] bool flushed_by(const Scopes& scopes) const {
        return (stages_ & ~scopes.src_memory) == 0 &&
               (access_ & access::kAllWrites & ~scopes.src_access) == 0;
    }
    [[nodiscard]] bool is_write() const { return is_write_; }
    [[nodiscard]] const Actor& actor() const { return actor_; }
    [[nodiscard]] StageMask stages() const { return stages_; }
    [[nodiscard]] AccessMask access() const { return access_; }

 private:
    void carry(const StageChain& chain, StageMask available_before);

    Actor actor_;
    StageMask stages_ = 0;
    AccessMask access_ = 0;
    bool is_write_ = false;
    uint32_t followed_ = 0;                         // number of barrier batches of its queue already applied
    StageMask available_reach_ = 0;                 // later stages ordered after the barrier that made it
                                                    // available
    std::array<StageMask, stage::kCount> reach_{};  // index: own stage; later stages ordered after it
    StageMask transition_reach_ = 0;
    std::array<AccessMask, stage::kCount> visible_{};  // index: later stage
};

}  // namespace weft::check
