// Purpose: unrolls a plan over several frames into nodes, the smallest units that can be delayed, with their
// dependencies. A pass is one node per stage that reads and one per write; barriers, semaphore signals and
// waits are nodes too. Only barriers, semaphores and the rasteriser order nodes. A node in a stage waits for
// earlier barriers whose destination includes that stage. A barrier waits for everything earlier in its
// source stages and for the barriers that it chains with (Vulkan 1.3 specification, "Execution
// Dependencies"). A draw waits for earlier draws in its rendering scope. The order of passes in the plan has
// no other effect.
#pragma once

#include <cstdint>
#include <vector>

#include "null/node_set.h"
#include "weft/plan.h"

namespace weft::null {

inline constexpr uint32_t kNoNode = UINT32_MAX;

enum class NodeKind : uint8_t {
    pass_read,   // all reads of one pass in one stage
    pass_write,  // one write of a pass, in that stage
    clear,       // initialises a persistent resource in the prologue
    barrier,
    signal,         // at the end of a batch
    wait,           // at its beginning
    import_enter,   // the owner makes the import available to the frame
    import_access,  // an earlier access of the owner, in one stage of the entry state
    import_leave,   // an access of the owner after the frame, in one stage of the exit state
};

struct Node {
    NodeKind kind = NodeKind::barrier;
    uint32_t frame = 0;
    QueueIndex queue = 0;
    StageMask stage = stage::kNone;  // one bit; kNone: not assigned to a stage
    uint32_t instance = kNoNode;     // for passes: index into Timeline::instances
    const BarrierDecl* barrier = nullptr;
    ResourceId resource = kNoId;  // for imports and clears
    // For draws: the rendering scope, numbered over all frames. A draw waits for earlier draws of its scope
    // to the same kind of attachment and sees their results; other parts of the passes do not.
    uint32_t scope = kNoNode;
};

// One pass in one frame.
struct PassInstance {
    uint32_t frame = 0;
    uint32_t position = 0;
    bool goes_on = false;  // the next pass draws into the same rendering scope, so store operations have not
                           // happened yet
};

struct Timeline {
    std::vector<Node> nodes;      // in the order of recording
    std::vector<NodeSet> before;  // index: node; all its direct and indirect predecessors
    // index: node; predecessors that are ordered only through the owner of an import. The owner is not part
    // of the plan, so no other node may rely on this order.
    std::vector<std::vector<uint32_t>> outside_before;
    std::vector<PassInstance> instances;
};

// The result refers to `plan`. `choice` selects the stages of writes and of imports' entry states.
[[nodiscard]] Timeline unroll(const FramePlan& plan, uint32_t frames, uint64_t choice);

}  // namespace weft::null
