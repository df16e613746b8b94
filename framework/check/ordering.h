// Purpose: what happens before what on one queue, by the rules of Vulkan's execution and memory dependencies
// (Vulkan 1.3 specification, chapter "Synchronization and Cache Control").
// A barrier orders everything earlier in its source stages before everything later in its destination stages,
// and chains with barriers whose scopes meet. Memory is made available by a barrier whose source names the
// writing stage and access, and visible to the stages and accesses of the destination.
#pragma once

#include <array>
#include <span>

#include "check/barrier_log.h"
#include "check/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

// Stages that a source mask stands for: those named and, in one pipeline, the logically earlier ones.
[[nodiscard]] StageMask with_earlier(StageMask stages);
// Stages that a destination mask stands for: those named and the logically later ones.
[[nodiscard]] StageMask with_later(StageMask stages);

[[nodiscard]] Scopes scopes_of(const BarrierDecl& barrier);

// One access, or layout transition, and how far its effects have been carried since.
class AccessRecord {
 public:
    AccessRecord() = default;
    // A transition has no stages of its own: it is done when its barrier's destination stages start.
    AccessRecord(const Actor& actor, StageMask stages, AccessMask access, bool is_write);
    static AccessRecord transition(const Actor& actor, const Scopes& scopes);

    // Carries one vkCmdPipelineBarrier2: `all` are its barriers, of any resource, because their execution
    // parts hold for everything; `on_memory` are those on the memory that this access touched.
    void pass_barriers(const StageChain& all, std::span<const Scopes> on_memory);
    // Carries the batches of `log`, the log of this access's queue, that were recorded since it was followed
    // last. None of them is on the memory that this access touched.
    void follow(const BarrierLog& log);

    // Every stage of this access is in, or chained to, the barrier's source.
    [[nodiscard]] bool ordered_before(const Scopes& scopes) const;
    // Every stage of this access is over before any of `stages` starts.
    [[nodiscard]] bool ordered_before(StageMask stages) const;
    [[nodiscard]] bool visible_to(StageMask stages, AccessMask access) const;
    // A barrier before made this write available, and what it made wait chains to this one's source, or to
    // all of `stages`.
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
    uint32_t followed_ = 0;                         // batches of barriers of its queue
    StageMask available_reach_ = 0;                 // later stages known to come after it was made available
    std::array<StageMask, stage::kCount> reach_{};  // by own stage: later stages known to come after it
    StageMask transition_reach_ = 0;
    std::array<AccessMask, stage::kCount> visible_{};  // by later stage
};

}  // namespace weft::check
