// Purpose: a plan unrolled over several frames into the smallest things that can be delayed, and which of
// them have to wait for which. A pass is one node for each stage that reads and one for each write; a
// barrier, a semaphore's signal and a wait are nodes too. Only barriers, semaphores and the rasteriser order
// anything: a node of a stage waits for the barriers before it whose destination reaches that stage, a
// barrier for everything before it in its source stages and for the barriers that it chains with (Vulkan 1.3
// specification, "Execution Dependencies"), and drawing for earlier drawing in its rendering scope. The
// passes' order in the plan means nothing else.
#pragma once

#include <cstdint>
#include <vector>

#include "null/node_set.h"
#include "weft/plan.h"

namespace weft::null {

inline constexpr uint32_t kNoNode = UINT32_MAX;

enum class NodeKind : uint8_t {
    pass_read,   // all reads of one pass in one stage
    pass_write,  // all writes of one pass that are done in that stage
    clear,       // of a persistent resource, in the prologue
    barrier,
    signal,         // at the end of a batch
    wait,           // at its beginning
    import_enter,   // its owner has it ready for the frame
    import_access,  // what its owner did to it before, in one stage of the entry state
    import_leave,   // its owner looks at it after the frame, in one stage of the exit state
};

struct Node {
    NodeKind kind = NodeKind::barrier;
    uint32_t frame = 0;
    QueueIndex queue = 0;
    StageMask stage = stage::kNone;  // one bit; none: not bound to a stage
    uint32_t instance = kNoNode;     // passes: index into Timeline::instances
    const BarrierDecl* barrier = nullptr;
    ResourceId resource = kNoId;  // imports and clears
    // What draws: its rendering scope, counted over all frames. Later drawing in a scope waits for earlier
    // drawing to the same kind of attachment, and sees it; nothing else of the passes does.
    uint32_t scope = kNoNode;
};

// One pass in one frame.
struct PassInstance {
    uint32_t frame = 0;
    uint32_t position = 0;
    bool goes_on = false;  // the next pass draws into the same rendering scope: nothing is stored yet
};

struct Timeline {
    std::vector<Node> nodes;      // as recorded
    std::vector<NodeSet> before;  // by node: all that it waits for, directly or not
    // By node: what is done before it thanks to the owner of an import, who is no part of the plan and whom
    // nothing else may rely on.
    std::vector<std::vector<uint32_t>> outside_before;
    std::vector<PassInstance> instances;
};

// Points into `plan`. `choice` draws the stages of writes and of what imports bring with them.
[[nodiscard]] Timeline unroll(const FramePlan& plan, uint32_t frames, uint64_t choice);

}  // namespace weft::null
