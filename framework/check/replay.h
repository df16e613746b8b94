// Purpose: plays a plan over consecutive frames and watches every subresource: its layout, whose content it
// holds, which queue family owns it, and which accesses are still to be waited for.
#pragma once

#include <string>
#include <vector>

#include "check/batch_clock.h"
#include "check/cells.h"
#include "check/fault_list.h"
#include "check/ordering.h"
#include "weft/plan.h"

namespace weft::check {

// A resource whose memory overlaps that of another one.
struct Neighbour {
    ResourceId resource = kNoId;
    bool covered = false;  // all of its memory is the other's, too
};

class Replay {
 public:
    Replay(const FramePlan& plan, FaultList& faults);
    void run(uint32_t frames);

 private:
    void prologue();
    void rotate_rings();
    void check_boundary();
    void seal_rings();
    void enter_imports();
    void leave_imports();
    void batch(uint32_t index);
    // `goes_on`: the next pass draws into the same rendering scope.
    void step(const PassStep& step, bool goes_on);
    void uses(const PassStep& step, bool goes_on);

    void barriers(const std::vector<BarrierDecl>& batch, PassId before);
    void transition(const BarrierDecl& barrier, const Scopes& scopes, PassId before);
    void carry(const std::vector<BarrierDecl>& batch, const std::vector<Scopes>& scopes);
    // Carries the record through the barriers of its queue that are not on its memory. To be called before it
    // is judged.
    void follow(AccessRecord& record) const { record.follow(logs_[record.actor().queue]); }
    [[nodiscard]] const BarrierLog& log() const { return logs_[clock_.queue()]; }
    void apply(const BarrierDecl& barrier, const Scopes& scopes, PassId before);
    void transfer(const BarrierDecl& barrier, PassId before);

    void read(const Actor& by, const UseDecl& use, const AccessState& state);
    static void note_read(Cell& cell, const AccessRecord& record);
    void write(const Actor& by, const UseDecl& use, const AccessState& state, bool kept);

    // What other queues did is over when a semaphore says so; what this queue did, when barriers do.
    [[nodiscard]] bool ordered(const AccessRecord& record, StageMask stages) const;
    [[nodiscard]] bool ordered(const AccessRecord& record, const Scopes& scopes) const;
    [[nodiscard]] bool flushed(const AccessRecord& record, const Scopes& scopes) const;
    [[nodiscard]] bool flushed(const AccessRecord& record, StageMask stages) const;
    [[nodiscard]] bool visible(const AccessRecord& record, const AccessState& state) const;
    [[nodiscard]] bool changes_image(const BarrierDecl& barrier) const;
    [[nodiscard]] Actor actor(PassId pass, bool transition = false) const {
        return {pass, frame_, transition, clock_.queue(), clock_.batch_count(), 0, log().count()};
    }
    // Drawing is ordered within its rendering scope.
    [[nodiscard]] Actor actor_of_use(PassId pass, uint32_t use) const;
    [[nodiscard]] uint32_t family() const { return plan_.schedule.queues[clock_.queue()].family; }
    // The program around the graph is known to the first queue only by barriers.
    [[nodiscard]] bool covered(const AccessRecord& record) const {
        const Actor& by = record.actor();
        const bool outside = by.pass == kNoId && !by.transition;
        return !(outside && clock_.queue() == by.queue) && clock_.covers(by);
    }
    [[nodiscard]] std::string missing(const AccessRecord& record, const std::string& barrier) const;

    // `hint`: the source that the last cell of this use was found in; the next one is near it.
    void expect_content(PassId id, const UseDecl& use, const Cell& cell, size_t& hint);
    [[nodiscard]] bool is_wanted_content(const UseDecl& use, const Cell& cell, PassId wanted) const;
    [[nodiscard]] bool anybody_writes(ResourceId resource, const SubresourceRange& range) const;
    void expect_order(const Actor& by, const UseDecl& use, Cell& cell, const AccessState& state, bool writes);
    void expect_owner(const Actor& by, const UseDecl& use, Cell& cell);
    void expect_free_memory(const Actor& by, ResourceId resource, SourceLoc loc, StageMask stages,
                            const BarrierDecl* transition);
    void overwrite_neighbours(PassId by, ResourceId resource);
    // For `taker`, which is about to take over memory of `resource`.
    [[nodiscard]] bool is_superseded(ResourceId resource, ResourceId taker) const {
        const ResourceId by = cells_[resource].superseded_by;
        return by != kNoId && by != taker;
    }

    const FramePlan& plan_;
    FaultList& faults_;
    BatchClock clock_;
    std::vector<BarrierLog> logs_;  // by queue
    uint64_t barrier_batches_ = 0;  // of all queues
    uint32_t frame_ = 0;
    uint32_t scope_ = 0;                              // counts the rendering scopes of all frames
    std::vector<Cells> cells_;                        // by resource
    std::vector<std::vector<Neighbour>> neighbours_;  // by resource
    std::vector<std::vector<ResourceId>> rings_;      // by resource that leads a ring: its roles by age
};

// The stages and accesses that a use has once the load and store operations of its attachment are counted in.
[[nodiscard]] AccessState effective_state(const UseDecl& use, const AttachmentOps* ops);
[[nodiscard]] const AttachmentOps* ops_of(const PassStep& step, uint32_t use);

}  // namespace weft::check
