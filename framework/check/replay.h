// Purpose: plays a plan over consecutive frames and watches every subresource: its layout, whose content it
// holds, and which accesses are still to be waited for.
#pragma once

#include <vector>

#include "check/fault_list.h"
#include "check/ordering.h"
#include "weft/plan.h"

namespace weft::check {

// Whose values a subresource holds.
struct Content {
    enum class Kind : uint8_t { undefined, outside, written, overwritten } kind = Kind::undefined;
    PassId pass = kNoId;  // written: by whom; overwritten: by whom, through `through`
    uint32_t frame = 0;
    ResourceId through = kNoId;
};

// One mip and layer of one aspect, or a buffer.
struct Cell {
    SubresourceRange range;
    Layout layout = Layout::undefined;
    Content content;
    bool has_write = false;
    AccessRecord write;               // the last write or transition
    std::vector<AccessRecord> reads;  // since then
};

class Replay {
 public:
    Replay(const FramePlan& plan, FaultList& faults);
    void run(uint32_t frames);

 private:
    void barriers(const std::vector<BarrierDecl>& batch, PassId before);
    void transition(const BarrierDecl& barrier, const Scopes& scopes, PassId before);
    void carry(const std::vector<BarrierDecl>& batch, const std::vector<Scopes>& scopes);
    void step(const PassStep& step);
    void read(const PassDecl& pass, PassId id, const UseDecl& use, const AccessState& state);
    void write(const PassDecl& pass, PassId id, const UseDecl& use, const AccessState& state, bool kept);
    void expect_content(PassId id, const UseDecl& use, const Cell& cell);
    void expect_order(const Actor& actor, const UseDecl& use, const Cell& cell, const AccessState& state,
                      bool writes);
    void expect_free_memory(const Actor& actor, ResourceId resource, SourceLoc loc, StageMask stages,
                            const Scopes* transition);
    void overwrite_neighbours(PassId by, ResourceId resource);
    void enter_frame();
    void leave_frame();

    const FramePlan& plan_;
    FaultList& faults_;
    uint32_t frame_ = 0;
    std::vector<std::vector<Cell>> cells_;             // by resource
    std::vector<std::vector<ResourceId>> neighbours_;  // by resource: whose memory overlaps
};

// The stages and accesses that a use has once the load and store operations of its attachment are counted in.
[[nodiscard]] AccessState effective_state(const UseDecl& use, const AttachmentOps* ops);
[[nodiscard]] const AttachmentOps* ops_of(const PassStep& step, uint32_t use);

}  // namespace weft::check
