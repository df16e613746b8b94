// Purpose: simulates a plan over consecutive frames. For every subresource it tracks the layout, the origin
// of the content, the queue family that owns it, and the accesses that later accesses must wait for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/batch_clock.h"
#include "check/cells.h"
#include "check/faults/fault_list.h"
#include "check/memory_holders.h"
#include "check/ordering.h"
#include "check/structure/effective_state.h"
#include "weft/plan.h"

namespace weft::check {

class Replay {
 public:
    // Simulates frames in which the switches are as in `combination`. Exception: in frame 2, all switches are
    // on, so that the switches change before and after this frame.
    Replay(const FramePlan& plan, FaultList& faults, Combination combination = kAllSwitchesOn);
    void run(uint32_t frames);

 private:
    void prologue();
    void rotate_rings();
    void check_boundary();
    void seal_rings();
    void enter_imports();
    void leave_imports();
    void read_kept();
    void batch(uint32_t index);
    // Simulates a pass with its barriers. `scope_continues` is true if the next pass draws into the same
    // rendering scope.
    void step(const PassStep& step, bool scope_continues);
    void uses(const PassStep& step, bool scope_continues);
    [[nodiscard]] Combination combination() const { return frame_ == 2 ? kAllSwitchesOn : combination_; }
    // Returns true if the pass accesses the resource of the use in the current frame.
    [[nodiscard]] bool is_active(const UseDecl& use) const {
        return has_combination(use.used_in, combination());
    }
    // Returns the pass whose content a reader sees if the reader names the version that the pass `wanted`
    // writes. If a switch has turned `wanted` off, this is an earlier writer. Returns nullopt if no version
    // is left.
    [[nodiscard]] std::optional<PassId> version_left(PassId wanted, ResourceId resource,
                                                     const SubresourceRange& cell) const;
    // Returns a text such as " in frames in which "fog" is off", where fog is the name of a switch. Returns
    // an empty text if all switches are on.
    [[nodiscard]] std::string switches_text() const;
    void expect_written_output(ResourceId id, const Cell& cell);
    void expect_kept(ResourceId id, const Cell& cell);

    void barriers(const std::vector<BarrierDecl>& batch, PassId before);
    void transition(const BarrierDecl& barrier, const Scopes& scopes, PassId before);
    void carry(const std::vector<BarrierDecl>& batch);
    // Applies to an access record all barriers that were recorded on its queue since the last call. Call this
    // before each check of a record, because a new barrier does not update all records.
    void follow(AccessRecord& record) const { record.follow(logs_[record.actor().queue]); }
    [[nodiscard]] const BarrierLog& log() const { return logs_[clock_.queue()]; }
    void apply(const BarrierDecl& barrier, const Scopes& scopes, PassId before);
    void transfer(const BarrierDecl& barrier, PassId before);

    void read(const Actor& by, const UseDecl& use, const AccessState& state);
    static void note_read(Cell& cell, const AccessRecord& record);
    void write(const Actor& by, const UseDecl& use, const AccessState& state, bool kept);

    // These functions check an earlier access. ordered(): the current work waits for it. flushed(): its write
    // is available. visible(): its write is visible. For an access on another queue, a semaphore must ensure
    // this; for an access on the same queue, a barrier must.
    [[nodiscard]] bool ordered(const AccessRecord& record, StageMask stages) const;
    [[nodiscard]] bool ordered(const AccessRecord& record, const Scopes& scopes) const;
    [[nodiscard]] bool flushed(const AccessRecord& record, const Scopes& scopes) const;
    [[nodiscard]] bool flushed(const AccessRecord& record, StageMask stages) const;
    [[nodiscard]] bool visible(const AccessRecord& record, const AccessState& state) const;
    [[nodiscard]] bool changes_image(const BarrierDecl& barrier) const;
    [[nodiscard]] Actor actor(PassId pass, bool transition = false) const {
        return {pass, frame_, transition, clock_.queue(), clock_.batch_count(), 0, log().count()};
    }
    // Returns the actor for one use of a pass. For an attachment it has the rendering scope, because draws
    // are ordered within one scope.
    [[nodiscard]] Actor actor_of_use(PassId pass, uint32_t use) const;
    [[nodiscard]] uint32_t family() const { return plan_.schedule.queues[clock_.queue()].family; }
    // Returns true if semaphores already order the recorded access before the current batch. Accesses by the
    // program outside the graph are an exception: on queue 0, barriers must order them.
    [[nodiscard]] bool covered(const AccessRecord& record) const {
        const Actor& by = record.actor();
        const bool outside = by.pass == kNoId && !by.transition;
        return !(outside && clock_.queue() == by.queue) && clock_.covers(by);
    }
    [[nodiscard]] std::string missing(const AccessRecord& record, const std::string& barrier) const;

    // Checks that a cell has the content that the use declares. `hint` is an index into UseDecl::sources: the
    // entry that matched the previous cell of this use. The search starts at this entry, because neighbouring
    // cells often match the same entry.
    void expect_content(PassId id, const UseDecl& use, const Cell& cell, size_t& hint);
    [[nodiscard]] bool is_latest_content(PassId reader, const UseDecl& use, const Cell& cell) const;
    [[nodiscard]] bool is_wanted_content(const UseDecl& use, const Cell& cell, PassId wanted) const;
    [[nodiscard]] bool anybody_writes(ResourceId ring, const SubresourceRange& range) const;
    void expect_order(const Actor& by, const UseDecl& use, Cell& cell, const AccessState& state, bool writes);
    void expect_owner(const Actor& by, const UseDecl& use, Cell& cell);
    void expect_free_memory(const Actor& by, ResourceId resource, SourceLoc loc, StageMask stages,
                            const BarrierDecl* transition);
    // Takes over the memory of `resource`. The content of all other resources in this memory is lost.
    void take_memory(PassId by, ResourceId resource);

    const FramePlan& plan_;
    FaultList& faults_;
    Combination combination_;
    BatchClock clock_;
    std::vector<BarrierLog> logs_;  // Index: queue. All barriers recorded on the queue so far.
    // The next three members are temporary values of barriers() and carry(). They are not local variables, so
    // that each call uses the same memory again.
    std::vector<Scopes> scopes_;  // Index: barrier in the current vkCmdPipelineBarrier2 call.
    // Sorted pairs: a resource, and the index of a barrier in the call that affects this resource.
    std::vector<std::pair<ResourceId, size_t>> on_resource_;
    std::vector<Scopes> on_memory_;  // The scopes of the barriers that affect the current cell.
    uint64_t barrier_batches_ = 0;   // Number of vkCmdPipelineBarrier2 calls so far, on all queues.
    uint32_t frame_ = 0;
    // Number of the current rendering scope, counted over all frames.
    uint32_t scope_ = 0;
    std::vector<Cells> cells_;  // Index: ResourceId. The states of the resource's subresources.
    MemoryHolders holders_;
    // Index: ResourceId. For the copy of age 0 of a persistent resource: the parts of this copy that live
    // passes write. For all other resources: empty.
    std::vector<std::vector<SubresourceRange>> written_;
    // A ring is the list of the copies of one persistent resource (ResourceDecl::ring), ordered by age.
    // Index: the copy of age 0.
    std::vector<std::vector<ResourceId>> rings_;
};

}  // namespace weft::check
