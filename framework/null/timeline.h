// Purpose: unrolls a plan over several frames into nodes with dependencies. A node is the smallest unit that
// can be delayed. A pass has one node per stage that reads and one per stage that writes. Barriers, semaphore
// signals and waits are nodes too. A node in a stage waits for earlier semaphore waits on its queue, and for
// earlier barriers whose destination includes that stage. A barrier waits for all earlier work in its source
// stages and for the barriers with which it chains (Vulkan 1.3 specification, "Execution Dependencies"). A
// draw waits for earlier draws in its rendering scope. The writes of a pass wait for its reads. An access to
// an import waits for the owner of the import. The order of passes in the plan has no other effect.
#pragma once

#include <cstdint>
#include <vector>

#include "null/node_set.h"
#include "null/null_executor.h"
#include "weft/plan.h"

namespace weft::null {

inline constexpr uint32_t kNoNode = UINT32_MAX;

enum class NodeKind : uint8_t {
    pass_read,   // All reads of one pass in one stage.
    pass_write,  // All writes of one pass in one stage.
    clear,       // The prologue's clear of a persistent resource.
    barrier,
    signal,         // A semaphore signal, for example at the end of a batch.
    wait,           // A semaphore wait, for example at the beginning of a batch.
    import_enter,   // The program passes an import to the frame.
    import_access,  // The program accesses an import before the frame, in one stage of the entry state.
    // The program accesses an import after the frame, in one stage of the exit state (`stage` is kNone if the
    // exit state has no stage). Or the program reads a persistent resource in one stage of
    // ResourceDecl::between.
    import_leave,
};

struct Node {
    NodeKind kind = NodeKind::barrier;
    uint32_t frame = 0;
    QueueIndex queue = kGraphicsQueue;
    StageMask stage = stage::kNone;  // The stage in which the node runs; kNone: the node has no stage.
    uint32_t instance = kNoNode;     // For a pass: index into Timeline::instances.
    const BarrierDecl* barrier = nullptr;
    ResourceId resource = kNoId;  // For imports and clears: the resource that the node uses.
    // For attachment accesses: the number of the rendering scope, counted over all frames. The node waits for
    // earlier nodes of its scope that access the same kind of attachment (colour or depth), and sees their
    // results. Nodes that access no attachment have kNoNode.
    uint32_t scope = kNoNode;
};

// One execution of a pass: its frame and its position in the schedule.
struct PassInstance {
    uint32_t frame = 0;
    Position position = 0;
    // True if the next pass draws into the same rendering scope. Then the store operations happen only after
    // that pass.
    bool scope_continues = false;
};

struct Timeline {
    std::vector<Node> nodes;      // All nodes, in the order in which their commands are recorded.
    std::vector<NodeSet> before;  // Index: node. Its direct and indirect predecessors.
    // Index: node. Predecessors that `before` does not contain: only the program, as the owner of an import,
    // orders them before the node. The plan does not contain this order, so no other node may rely on it.
    std::vector<std::vector<uint32_t>> outside_before;
    std::vector<PassInstance> instances;
};

// Unrolls the plan. The result has pointers into `plan`. `choice` is the seed of a pseudo-random choice of
// stages: each write, and each access of an import's entry state, happens in one of its possible stages.
// `resting` says which passes are skipped in each frame: a skipped pass has no node in this frame. `rounds`
// is the order in which the rounds of groups run in each frame.
[[nodiscard]] Timeline unroll(const FramePlan& plan, uint32_t frames, uint64_t choice,
                              const RestChoice& resting, const RoundOrder& rounds);

}  // namespace weft::null
