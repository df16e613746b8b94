// Purpose: a compiled frame. Everything an executor does is written here; it decides nothing itself.
// Units: bytes. Positions count in schedule order. Barriers at position p are recorded before the pass at p.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft {

using QueueIndex = uint32_t;

// A queue as plans see it. The executor gives each one of the device's queues of its family; several may
// share one.
struct LogicalQueue {
    QueueKind kind = QueueKind::graphics;  // the most capable thing it can do
    uint32_t family = 0;                   // index into DeviceProfile::queue_families
    bool operator==(const LogicalQueue&) const = default;
};

enum class CullReason : uint8_t { live, unused_output, upstream_culled };

struct LiveGraph {
    std::vector<uint8_t> live_passes;     // by PassId
    std::vector<uint8_t> live_resources;  // by ResourceId
    std::vector<CullReason> reasons;      // by PassId
    std::vector<std::string> details;     // by PassId: "nobody reads \"ssao\"", empty when live
};

// One candidate order and what it would have cost.
struct ScheduleCandidate {
    std::string name;  // "program", "forward", "backward"
    uint64_t peak_live_bytes = 0;
    uint32_t barrier_batches = 0;
    uint32_t queue_switches = 0;
};

struct Schedule {
    std::vector<PassId> order;       // live passes only
    std::vector<uint32_t> position;  // by PassId; kNoId when culled
    std::vector<QueueIndex> queue;   // by position
    // By position: per queue, 1 + the latest position of that queue known to precede it in this frame.
    std::vector<std::vector<uint32_t>> clocks;
    std::vector<ScheduleCandidate> candidates;
    std::string chosen;
    std::vector<LogicalQueue> queues{LogicalQueue{}};
};

struct QueueSpan {
    QueueIndex queue = 0;
    uint32_t first = 0;
    uint32_t last = 0;
};

// First and last schedule position that touches a transient. Not live: first > last.
struct LifetimeSpan {
    uint32_t first = 1;
    uint32_t last = 0;
    std::vector<QueueSpan> queues;  // the same for each queue that touches it, in order of first touch
};

struct Lifetimes {
    std::vector<LifetimeSpan> spans;  // by ResourceId
};

struct MemoryNeed {
    uint64_t size_bytes = 0;
    uint64_t alignment_bytes = 1;
    uint32_t type_bits = UINT32_MAX;  // heaps it may live in
};

// By ResourceId. Zero size for what needs no placement (imports).
using MemoryNeeds = std::vector<MemoryNeed>;

struct Placement {
    ResourceId resource = kNoId;
    uint32_t heap = 0;
    uint64_t offset_bytes = 0;
    uint64_t size_bytes = 0;
};

// `to` takes over memory that `from` held. With `wrap`, from's owner was in the frame before.
struct HandOver {
    ResourceId from = kNoId;
    ResourceId to = kNoId;
    bool wrap = false;
    bool operator==(const HandOver&) const = default;
};

struct HeapPlan {
    uint64_t size_bytes = 0;
    uint32_t type_bits = UINT32_MAX;
    bool buffers = false;     // granularity keeps buffers and images apart where it must
    bool persistent = false;  // for what outlives the frame: nothing shares memory here
};

struct MemoryPlan {
    std::vector<HeapPlan> heaps;
    std::vector<Placement>
        placements;  // transients by (heap, offset, resource); persistent ones too, never shared
    std::vector<HandOver> hand_overs;  // sorted
    uint64_t sum_bytes = 0;            // if nothing were shared
    uint64_t peak_live_bytes = 0;
    uint32_t peak_position = 0;
    uint64_t heap_bytes = 0;        // of the transients' heaps
    uint64_t persistent_bytes = 0;  // of the others
};

enum class LoadOp : uint8_t { load, clear, dont_care, none };
enum class StoreOp : uint8_t { store, dont_care, none };

struct AttachmentOps {
    uint32_t use = kNoId;  // index into the pass's uses
    LoadOp load = LoadOp::load;
    StoreOp store = StoreOp::store;
};

enum class BarrierReason : uint8_t {
    raw,
    war,
    waw,
    layout,
    hand_over,
    acquire_import,
    release_import,
    release_queue,  // the first half of a transfer between queue families, after the last use on the old one
    acquire_queue,  // its second half, before the first use on the new one
    prologue,
};

// One dependency. Images: a transition of `range`; buffers: a memory dependency. Stages are those of the
// queue that records it; accesses on other queues are waited for by semaphores, which make all memory
// available and visible, and then only the layout or the owner is left to change.
struct BarrierDecl {
    ResourceId resource = kNoId;
    SubresourceRange range;
    AccessState src;  // layout undefined: the content is dropped
    AccessState dst;
    uint32_t src_family = 0;
    uint32_t dst_family = 0;  // differs from src_family in an ownership transfer
    BarrierReason reason = BarrierReason::raw;
    PassId from = kNoId;  // the pass waited for, where one single pass explains it
    PassId to = kNoId;
    bool from_previous_frame = false;
    std::vector<ResourceId> hand_over_from;  // whose memory is taken over
};

struct PassStep {
    PassId pass = kNoId;
    std::vector<BarrierDecl> barriers;       // one vkCmdPipelineBarrier2 before the pass
    std::vector<BarrierDecl> after;          // one after it: releases, and transitions for several queues
    std::vector<AttachmentOps> attachments;  // colours by location, then depth
    // Draws into the rendering scope of the pass before it on its queue, which ends with the last such pass.
    // The scope loads as its first pass says and stores as its last one does.
    bool continues_scope = false;
};

// Run once, on queue 0, before the first frame: all copies of all persistent resources get their first-frame
// values.
struct ProloguePlan {
    std::vector<BarrierDecl> before;  // out of undefined
    std::vector<ResourceId> cleared;  // to ResourceDecl::first_frame, whole
    std::vector<BarrierDecl> after;   // into the state in which the first frame's role expects it
};

struct BarrierPlan {
    std::vector<PassStep> steps;        // by position
    std::vector<BarrierDecl> epilogue;  // imports into their exit states, at the end of queue 0's last batch
    ProloguePlan prologue;
    std::vector<uint8_t> concurrent;  // by ResourceId: used by several families without ownership
    uint32_t emitted = 0;             // of a frame
};

// `to` must not start before `from` is over, and they are on different queues. With `previous_frame`, `from`
// is a position of the frame before.
struct QueueDependency {
    uint32_t from = 0;
    uint32_t to = 0;
    bool previous_frame = false;
    ResourceId resource = kNoId;  // why; kNoId for `after`
    bool operator==(const QueueDependency&) const = default;
};

// Before its first command a batch waits for another to be over, with all memory it wrote.
struct QueueWait {
    uint32_t batch = 0;  // index into SubmissionPlan::batches, on another queue
    bool previous_frame = false;
    uint32_t dependency = kNoId;  // the dependency that asked for it, in SubmissionPlan::dependencies
};

// Everything between two waits or signals of a queue. When it is over, the timeline semaphore of its queue
// has the value frame × (batches of that queue) + 1 + (its rank among them), counting frames from 0.
struct Batch {
    QueueIndex queue = 0;
    std::vector<uint32_t> positions;  // in schedule order, all on `queue`
    std::vector<QueueWait> waits;
    bool epilogue = false;  // records BarrierPlan::epilogue after its passes
};

struct SubmissionPlan {
    std::vector<Batch> batches;  // by first position, which is an order they can be submitted in
    std::vector<QueueDependency> dependencies;  // what the waits are there for
};

// How every persistent or imported resource is found at the start of a frame, per range. Of persistent ones,
// which only the frame itself touches, the layout says it all.
struct BoundaryState {
    ResourceId resource = kNoId;
    SubresourceRange range;
    AccessState state;
    uint32_t family = 0;
};

struct FramePlan {
    ResolvedGraph graph;
    LiveGraph live;
    Schedule schedule;
    Lifetimes lifetimes;
    MemoryPlan memory;
    BarrierPlan barriers;
    SubmissionPlan submissions;
    std::vector<BoundaryState> boundary;
    std::string hash;  // 32 hex digits over everything above but provenance
};

}  // namespace weft
