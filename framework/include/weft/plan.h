// Purpose: a compiled frame. It contains all of an executor's work; the executor makes no decisions. Units:
// bytes. Positions are indices in schedule order. Barriers at position p are recorded before the pass at p.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft {

using QueueIndex = uint32_t;

// A queue of a plan. The executor assigns it a queue of its family on the device; several may share one.
struct LogicalQueue {
    QueueKind kind = QueueKind::graphics;  // its most capable kind
    uint32_t family = 0;                   // index into DeviceProfile::queue_families
    bool operator==(const LogicalQueue&) const = default;
};

enum class CullReason : uint8_t { live, unused_output, upstream_culled };

struct LiveGraph {
    std::vector<uint8_t> live_passes;     // index: PassId
    std::vector<uint8_t> live_resources;  // index: ResourceId
    std::vector<CullReason> reasons;      // index: PassId
    std::vector<std::string> details;     // index: PassId; such as "nobody reads \"ssao\""; empty for live
                                          // passes
};

// One candidate order with its cost.
struct ScheduleCandidate {
    std::string name;  // "program", "forward", "backward"
    uint64_t peak_live_bytes = 0;
    uint32_t barrier_batches = 0;
    uint32_t queue_switches = 0;
};

struct Schedule {
    std::vector<PassId> order;       // live passes only
    std::vector<uint32_t> position;  // index: PassId; kNoId if culled
    std::vector<QueueIndex> queue;   // index: position
    // By position: for each queue, 1 + the latest position of that queue that is known to precede it in this
    // frame.
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

// First and last schedule position that uses a transient. If not live, first > last.
struct LifetimeSpan {
    uint32_t first = 1;
    uint32_t last = 0;
    std::vector<QueueSpan> queues;  // the same for each queue that uses it, in order of first use
};

struct Lifetimes {
    std::vector<LifetimeSpan> spans;  // index: ResourceId
};

struct MemoryNeed {
    uint64_t size_bytes = 0;
    uint64_t alignment_bytes = 1;
    uint32_t type_bits = UINT32_MAX;  // memory types that it may use
};

// Indexed by ResourceId. The size is zero for resources without placement (imports).
using MemoryNeeds = std::vector<MemoryNeed>;

struct Placement {
    ResourceId resource = kNoId;
    uint32_t heap = 0;
    uint64_t offset_bytes = 0;
    uint64_t size_bytes = 0;
};

// `to` takes over memory from `from`. With `wrap`, `from` used it in the previous frame.
struct AliasTransition {
    ResourceId from = kNoId;
    ResourceId to = kNoId;
    bool wrap = false;
    bool operator==(const AliasTransition&) const = default;
};

struct HeapPlan {
    uint64_t size_bytes = 0;
    uint32_t type_bits = UINT32_MAX;
    bool buffers = false;     // separates buffers and images if the device's granularity requires it
    bool persistent = false;  // for persistent resources, which share no memory
};

struct MemoryPlan {
    std::vector<HeapPlan> heaps;
    std::vector<Placement>
        placements;  // sorted by (heap, offset, resource); persistent resources share no memory
    std::vector<AliasTransition> alias_transitions;  // sorted
    uint64_t sum_bytes = 0;            // total without sharing
    uint64_t peak_live_bytes = 0;
    uint32_t peak_position = 0;
    uint64_t heap_bytes = 0;        // heaps of transients
    uint64_t persistent_bytes = 0;  // all other heaps
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
    alias,  // the resource takes over memory that another one held
    acquire_import,
    release_import,
    release_queue,  // the first half of an ownership transfer, after the last use on the old queue family
    acquire_queue,  // the second half, before the first use on the new queue family
    prologue,
};

// One dependency: for images a transition of `range`, for buffers a memory dependency. Stages are those of
// the recording queue. Accesses on other queues are ordered by semaphores, which also make memory available
// and visible; then the barrier only changes the layout or owner.
struct BarrierDecl {
    ResourceId resource = kNoId;
    SubresourceRange range;
    AccessState src;  // layout undefined: the content is discarded
    AccessState dst;
    uint32_t src_family = 0;
    uint32_t dst_family = 0;  // differs from src_family in an ownership transfer
    BarrierReason reason = BarrierReason::raw;
    PassId from = kNoId;  // the pass waited for, if a single pass is the reason
    PassId to = kNoId;
    bool from_previous_frame = false;
    std::vector<ResourceId> aliased_from;  // resources whose memory is taken over
};

struct PassStep {
    PassId pass = kNoId;
    std::vector<BarrierDecl> barriers;       // recorded as one vkCmdPipelineBarrier2 before the pass
    std::vector<BarrierDecl> after;          // recorded as one after it: releases, and transitions for
                                             // several queues
    std::vector<AttachmentOps> attachments;  // colours by location, then depth
    // Draws into the rendering scope of the previous pass on its queue. The scope ends with the last such
    // pass. Its load operations are those of its first pass, its store operations those of its last one.
    bool merges_render_pass = false;
};

// Runs once, on queue 0, before the first frame: initialises all copies of all persistent resources.
struct ProloguePlan {
    std::vector<BarrierDecl> before;  // transitions from undefined
    std::vector<ResourceId> cleared;  // completely cleared to ResourceDecl::first_frame
    std::vector<BarrierDecl> after;   // transitions to the states that the first frame expects
};

struct BarrierPlan {
    std::vector<PassStep> steps;        // index: position
    std::vector<BarrierDecl> epilogue;  // transitions of imports to their exit states, at the end of queue
                                        // 0's last batch
    ProloguePlan prologue;
    std::vector<uint8_t> concurrent;  // index: ResourceId; shared by several queue families without ownership
                                      // transfers
    uint32_t emitted = 0;             // number of barriers in a frame
};

// `to` must not start before `from` completes, and they are on different queues. With `previous_frame`,
// `from` is a position of the previous frame.
struct QueueDependency {
    uint32_t from = 0;
    uint32_t to = 0;
    bool previous_frame = false;
    ResourceId resource = kNoId;  // the reason; kNoId for `after`
    bool operator==(const QueueDependency&) const = default;
};

// Before its first command, a batch waits until another batch is complete and all its memory writes are
// visible.
struct QueueWait {
    uint32_t batch = 0;  // index into SubmissionPlan::batches, on another queue
    bool previous_frame = false;
    uint32_t dependency = kNoId;  // index into SubmissionPlan::dependencies of the reason
};

// All work of a queue between two waits or signals. On completion, the timeline semaphore of its queue gets
// the value frame × (batches of that queue) + 1 + (index among them); frames count from 0.
struct Batch {
    QueueIndex queue = 0;
    std::vector<uint32_t> positions;  // in schedule order, all on `queue`
    std::vector<QueueWait> waits;
    bool epilogue = false;  // records BarrierPlan::epilogue after its passes
};

struct SubmissionPlan {
    std::vector<Batch> batches;                 // sorted by first position, which is a valid submission order
    std::vector<QueueDependency> dependencies;  // the reasons for the waits
};

// The state of each range of every persistent or imported resource at the start of a frame. For persistent
// resources, which only frames access, the layout is sufficient.
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
    std::string hash;  // 32 hexadecimal digits, for all members above except places in files
};

}  // namespace weft
